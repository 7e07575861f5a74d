import assert from 'node:assert/strict';
import { test } from 'node:test';
import { placeDimensions } from '../../../js/sheet/place/dimensions.mjs';
import { distance, isWithin, linesCross, overlaps, passes, segmentsOf } from '../../../js/sheet/place/geometry.mjs';
import { between, seeded } from './random.mjs';

const AREA = { x: 0, y: 0, width: 273, height: 155 };
/** A garment of a body and two sleeves, about the middle of the page. */
const BOXES = [
  { x: 100, y: 30, width: 70, height: 95 },
  { x: 80, y: 35, width: 110, height: 30 },
];
const GARMENT = { covers: (x, y) => BOXES.some((box) => x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height) };

const isOn = ([x, y]) => GARMENT.covers(x, y);
const steps = ([a, b]) => Array.from({ length: 101 }, (_, i) => [a[0] + ((b[0] - a[0]) * i) / 100, a[1] + ((b[1] - a[1]) * i) / 100]);

function faultsOf(dimensions, { drawn, rest }) {
  const faults = [];
  drawn.forEach((a, i) => {
    const { points, width, height } = dimensions.find(({ id }) => id === a.id);
    if (!a.line.every(([x, y]) => isWithin({ x, y, width: 0, height: 0 }, AREA)) || !isWithin(a.label, AREA)) faults.push(`${a.id} leaves the page`);
    if (a.label.width !== width || a.label.height !== height) faults.push(`${a.id} has another label`);
    const [from, to] = [points[0], points.at(-1)];
    if (a.outside) {
      if (segmentsOf(a.line).some((segment) => steps(segment).some(isOn))) faults.push(`${a.id} lies on the garment`);
      if (Math.abs(distance(...a.line) - distance(from, to)) > 1e-9) faults.push(`${a.id} has another length`);
      const turn = (to[0] - from[0]) * (a.line[1][1] - a.line[0][1]) - (to[1] - from[1]) * (a.line[1][0] - a.line[0][0]);
      if (Math.abs(turn) > 1e-6) faults.push(`${a.id} is not parallel`);
    }
    for (const b of drawn.slice(i + 1)) {
      if (linesCross(a.line, b.line)) faults.push(`${a.id} crosses ${b.id}`);
      if (overlaps(a.label, b.label)) faults.push(`labels ${a.id} and ${b.id} overlap`);
    }
    for (const b of drawn) if (b !== a && segmentsOf(b.line).some((segment) => passes(segment, a.label))) faults.push(`${b.id} strikes the label of ${a.id}`);
  });
  const seen = [...drawn, ...rest].map(({ id }) => id).sort((a, b) => a - b);
  if (JSON.stringify(seen) !== JSON.stringify(dimensions.map(({ id }) => id))) faults.push('something is lost or twice');
  if (drawn.length === 0) faults.push('nothing is drawn');
  return faults;
}

function randomDimensions(seed) {
  const random = seeded(seed);
  const onGarment = () => {
    const box = BOXES[random() < 0.6 ? 0 : 1];
    return [between(random, box.x, box.x + box.width), between(random, box.y, box.y + box.height)];
  };
  return Array.from({ length: 1 + Math.floor(random() * 14) }, (_, id) => {
    const from = onGarment();
    const level = random();
    const to = level < 0.35 ? [between(random, 80, 190), from[1]] : level < 0.6 ? [from[0], between(random, 30, 125)] : onGarment();
    const isPath = random() < 0.15;
    return { id, points: isPath ? [from, onGarment(), to] : [from, to], width: between(random, 4, 14), height: 4, isPath };
  });
}

test('500 sets of dimensions: parallel, off the garment, no line crosses another or strikes a label, none is lost', () => {
  let outside = 0;
  let all = 0;
  for (let seed = 1; seed <= 500; ++seed) {
    const dimensions = randomDimensions(seed);
    const result = placeDimensions(dimensions, { area: AREA, garment: GARMENT });
    assert.deepEqual(faultsOf(dimensions, result), [], `seed ${seed}`);
    outside += result.drawn.filter((each) => each.outside).length;
    all += dimensions.length;
  }
  assert.ok(outside > 0.5 * all, `${outside} of ${all} stand off the garment`);
});

test('what finds no room is drawn on further pages', () => {
  const dimensions = Array.from({ length: 40 }, (_, id) => ({
    id,
    points: [
      [101, 60 + id / 10],
      [169, 60 + id / 10],
    ],
    width: 8,
    height: 4,
  }));
  let left = dimensions;
  for (let page = 0; left.length > 0; ++page) {
    const { drawn, rest } = placeDimensions(left, { area: AREA, garment: GARMENT });
    assert.ok(drawn.length > 0 && page < 10);
    left = rest;
  }
});

test('the shorter of two lies nearer to the garment, so that no witness line crosses a dimension line', () => {
  const [wide, narrow] = [
    {
      id: 0,
      points: [
        [100, 40],
        [170, 40],
      ],
      width: 6,
      height: 4,
    },
    {
      id: 1,
      points: [
        [120, 40],
        [150, 40],
      ],
      width: 6,
      height: 4,
    },
  ];
  const { drawn } = placeDimensions([wide, narrow], { area: AREA, garment: GARMENT });
  const of = (id) => drawn.find((each) => each.id === id);
  assert.ok(of(0).line[0][1] < of(1).line[0][1] && of(1).line[0][1] < 30);
});

test('planted faults are seen', () => {
  const dimensions = randomDimensions(11);
  const plant = (change) => {
    const result = placeDimensions(dimensions, { area: AREA, garment: GARMENT });
    change(
      result.drawn.filter(({ outside }) => outside),
      result,
    );
    return faultsOf(dimensions, result).join('\n');
  };
  const moved = plant(([first]) => {
    first.line = first.line.map(([x, y]) => [x + (135 - x) * 0.9, y + (75 - y) * 0.9]);
  });
  assert.match(moved, /on the garment|another length/);
  assert.match(
    plant(([first, second]) => {
      second.label = { ...first.label, width: second.label.width, height: second.label.height };
    }),
    /overlap/,
  );
  assert.match(
    plant((_, { drawn }) => drawn.pop()),
    /lost/,
  );
  assert.match(
    plant(([first]) => {
      first.line = [first.line[0], [first.line[1][0] + 3, first.line[1][1] - 7]];
    }),
    /not parallel|another length/,
  );
});
