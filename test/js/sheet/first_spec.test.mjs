import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cornersOfBox } from '../../../js/shot/frame.mjs';
import { firstSpec } from '../../../js/sheet/first_spec.mjs';
import { readSpec } from '../../../js/sheet/read.mjs';
import { oneOf, seeded } from './random.mjs';

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

const BOX = { bounds: { min: [0, 0, 0], max: [0.4, 0.6, 0.2] } };

test('variants that come to one name are numbered, and those that a spec cannot name are left out', () => {
  const variants = ['navy_blue', 'navy.blue', 'Navy', 'navy', 'navy_2', '', '_', ' ', 'red', 'red', 'a\nb', 'x'.repeat(121), 'y'.repeat(120)];
  const materials = [{ name: 'jersey_navy' }, { name: '_' }, { name: `${'z'.repeat(130)}\n` }];
  const facts = { ...BOX, variants, materials, variantMaterials: variants.map((_, i) => [i % 3]) };
  const { colourways, bill } = firstSpec(facts);
  assert.deepEqual(
    colourways.map(({ name, variant }) => [name, variant]),
    [
      ['Navy blue', 'navy_blue'],
      ['Navy blue 2', 'navy.blue'],
      ['Navy', 'Navy'],
      ['Navy 2', 'navy'],
      ['Navy 2 2', 'navy_2'],
      ['_', '_'],
      ['Colourway', ' '],
      ['Red', 'red'],
      [`Y${'y'.repeat(119)}`, 'y'.repeat(120)],
    ],
  );
  // The colours are those of the first of two variants of one name, as its pictures are.
  assert.deepEqual(colourways[7].swatches, [{ part: `Z${'z'.repeat(118)}…`, material: 2 }]);
  assert.deepEqual(
    bill.map(({ item }) => item),
    ['Jersey', '_', `Z${'z'.repeat(118)}…`],
  );
  assert.equal(readSpec(firstSpec(facts), facts).colourways.length, 9);
});

test('a length that is longer than a spec may have is left out, and so are places that it may not name', () => {
  const sized = (size) => firstSpec({ bounds: { min: [0, 0, 0], max: [size, 1, 0] } });
  assert.deepEqual(
    [1000, 1001, 1e12].map((size) => sized(size).measures.map(({ values }) => values)),
    [
      [{ M: 100_000 }, { M: 100 }],
      [{}, { M: 100 }],
      [{}, { M: 100 }],
    ],
  );
  assert.deepEqual([sized(1e31).anchors, sized(1e31).measures], [{}, []]);
});

/** Parts of names that files may have: marks, control characters, halves of characters, letters that grow as capitals, names of JavaScript. */
const PARTS = [
  'a',
  'Navy',
  'navy',
  '_',
  '.',
  ' ',
  '\n',
  '\t',
  '\u0000',
  '\u007f',
  '\u2028',
  '\ud83d',
  '\ude00',
  '😀',
  'ß',
  'é',
  '__proto__',
  'constructor',
  '2',
  'x'.repeat(119),
  '😀'.repeat(60),
];

test('what a first spec holds, whatever the model is called and however large it is, is a spec', () => {
  for (let seed = 1; seed <= 400; ++seed) {
    const random = seeded(seed);
    const below = (count) => Math.floor(random() * count);
    const pick = (values) => oneOf(random, values);
    const list = (most, make) => Array.from({ length: below(most + 1) }, make);
    const name = () => list(5, () => pick(PARTS)).join('');
    const variants = list(60, name);
    const materials = list(600, () => ({ name: `${name()}${pick(['', ...variants])}` }));
    const scale = 10 ** (below(80) - 40);
    const corner = () => [0, 1, 2].map(() => scale * (below(2001) - 1000));
    const outline = [corner(), corner(), ...list(20, corner)];
    const facts = {
      ...factsOf(outline),
      ...(below(2) && { outline: undefined }),
      name: name(),
      variants,
      materials,
      variantMaterials: variants.map(() => (materials.length > 0 ? list(8, () => below(materials.length)) : [])),
    };
    const spec = firstSpec(facts, { name: name(), language: pick(['en', 'es']) });
    assert.doesNotThrow(() => readSpec(JSON.parse(JSON.stringify(spec)), facts), `seed ${seed}`);
  }
});
