import assert from 'node:assert/strict';
import { test } from 'node:test';
import { labelPlaces } from '../../../js/view/page/label_places.mjs';
import { seeded } from '../sheet/random.mjs';

const PICTURE = [430, 430];

/** Pixels that labels of 12 px cover of each other and of points. */
function covered(labels, places, points) {
  const boxes = places.map(([x, y], i) => [x, y - 11, x + labels[i].width, y + 3]);
  const shared = (a, b) => Math.max(0, Math.min(a[2], b[2]) - Math.max(a[0], b[0])) * Math.max(0, Math.min(a[3], b[3]) - Math.max(a[1], b[1]));
  let sum = 0;
  boxes.forEach((box, i) => {
    for (const other of boxes.slice(0, i)) sum += shared(box, other);
    for (const [x, y] of points) sum += shared(box, [x - 5, y - 5, x + 5, y + 5]);
  });
  return sum;
}

const outside = (labels, places) => places.filter(([x, y], i) => x < 0 || x + labels[i].width > PICTURE[0] || y < 11 || y + 3 > PICTURE[1]).length;

/** Every label at its first point, to the right and above. */
const allAlike = (labels) => labels.map(({ points: [[x, y]] }) => [x + 9, y - 7]);

test('labels of measures from one point, of neighbours and at the sides cover neither each other nor points', () => {
  const neck = [205, 28];
  const labels = [
    { points: [neck, [205, 405]], width: 66 },
    { points: [neck, [299, 28]], width: 66 },
    { points: [neck, [250, 50]], width: 66 },
    { points: [[250, 50]], width: 66 },
    {
      points: [
        [425, 100],
        [300, 100],
      ],
      width: 66,
    },
    { points: [[100, 4]], width: 66 },
  ];
  const points = labels.flatMap((label) => label.points);
  const places = labelPlaces(labels, points, PICTURE);
  assert.equal(covered(labels, places, points), 0);
  assert.equal(outside(labels, places), 0);
  assert.deepEqual(places[0], [neck[0] + 9, neck[1] - 7], 'the first one stands where it always did');
  assert.ok(covered(labels, allAlike(labels), points) > 0, 'the same place for all covers');
  assert.ok(outside(labels, allAlike(labels)) > 0);
});

test('of more labels than have room, less is covered than with one place for all', () => {
  const random = seeded(7);
  let [placed, alike] = [0, 0];
  for (let run = 0; run < 50; run++) {
    const labels = Array.from({ length: 25 }, () => ({
      points: Array.from({ length: 2 }, () => PICTURE.map((side) => side * random())),
      width: 12 + 70 * random(),
    }));
    const points = labels.flatMap((label) => label.points);
    placed += covered(labels, labelPlaces(labels, points, PICTURE), points);
    alike += covered(labels, allAlike(labels), points);
  }
  assert.ok(placed < 0.1 * alike, `${placed} of ${alike} square pixels`);
});
