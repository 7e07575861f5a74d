import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cornersOfBox } from '../../../js/shot/frame.mjs';
import { firstSpec } from '../../../js/sheet/first_spec.mjs';

const factsOf = (outline) => {
  const along = (axis) => outline.map((point) => point[axis]);
  return { bounds: { min: [0, 1, 2].map((i) => Math.min(...along(i))), max: [0, 1, 2].map((i) => Math.max(...along(i))) }, outline };
};

const lengthsOf = (facts) => firstSpec(facts).measures.map(({ values }) => values.M);

/** Corners of an open tube that narrows, by its rings, turned about +Y. */
function tube({ turned = 0, offset = 0, sides = 48, radii = [0.25, 0.15], top = 0.7, height = 0.6 }) {
  return [1, top].flatMap((part, ring) =>
    Array.from({ length: sides }, (_, i) => {
      const angle = (2 * Math.PI * i) / sides;
      const [x, z] = [part * radii[0] * Math.cos(angle), part * radii[1] * Math.sin(angle)];
      return [offset + x * Math.cos(turned) + z * Math.sin(turned), ring * height, z * Math.cos(turned) - x * Math.sin(turned)];
    }),
  );
}

test('the overall sizes of a box are those that its front shows, in any order of its corners, and without an outline', () => {
  const bounds = { min: [-0.2, 0, -0.2], max: [0.2, 0.6, 0.2] };
  const corners = cornersOfBox(bounds);
  for (let k = 0; k < corners.length; ++k) {
    const outline = [...corners.slice(k), ...corners.slice(0, k)];
    const { anchors, measures } = firstSpec({ bounds, outline });
    assert.deepEqual(
      measures.map(({ values }) => values.M),
      [40, 60],
      `from ${k}`,
    );
    // Of the pairs that are alike, those of the front.
    assert.deepEqual(
      Object.values(anchors).map(([, , z]) => z),
      [0.2, 0.2, 0.2, 0.2],
    );
  }
  assert.deepEqual(lengthsOf({ bounds }), [40, 60]);
});

test('the overall length of a tube leans no more than its wall, however it is turned', () => {
  // A wall leans by 4.5 cm to 7.5 cm: 60.17 cm to 60.47 cm. A corner may lie half a side off the one that leans least: 1.6 cm.
  for (let degrees = 0; degrees <= 180; degrees += 7.5) {
    const [, length] = lengthsOf(factsOf(tube({ turned: (degrees * Math.PI) / 180 })));
    assert.ok(length >= 60 && length <= 60.5, `${length} cm, turned by ${degrees}`);
  }
});

test('a model that was moved has the same overall sizes', () => {
  for (const turned of [0, 0.3, 1.1]) {
    const lengths = [0, 1, 1000, -1e5].map((offset) => lengthsOf(factsOf(tube({ turned, offset }))));
    for (const moved of lengths) assert.deepEqual(moved, lengths[0]);
  }
});

test('a length is no shorter than the front shows it because it runs in depth', () => {
  // The nearer pair is as long as the front is wide, but is not all of it.
  const outline = [
    [-0.2, 0, 0],
    [0.2, 0.02, 0],
    [-0.194, 0.3, 0],
    [0.194, 0.3, 0.097],
    [0, 0.6, 0],
    [0, -0.01, 0],
  ];
  const { anchors } = firstSpec(factsOf(outline));
  assert.deepEqual([anchors.left, anchors.right], [outline[0], outline[1]]);
});
