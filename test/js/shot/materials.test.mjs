import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { resolveMaterials } from '../../../js/shot/materials.mjs';
import { shotIdentity } from '../../../js/shot/identity.mjs';

// Root > Body > (Front, Back), Root > Sleeve
const NAMES = {
  materials: ['Body fabric', 'Sleeve fabric', 'Trim', '7'],
  nodes: [
    { node: 4, name: 'Root', parent: -1 },
    { node: 3, name: 'Body', parent: 0 },
    { node: 0, name: 'Front', parent: 1 },
    { node: 1, name: 'Back', parent: 1 },
    { node: 2, name: 'Sleeve', parent: 0 },
  ],
};
const partsOf = (selector) => {
  const [{ materials, nodes }] = resolveMaterials({ materials: { [selector]: {} } }, NAMES);
  return { materials, nodes };
};

test('a selector means materials by name, and nodes by name with all beneath them', () => {
  assert.deepEqual(partsOf('Trim'), { materials: [2], nodes: [] });
  assert.deepEqual(partsOf('Body'), { materials: [], nodes: [3, 0, 1] });
  assert.deepEqual(partsOf('Front'), { materials: [], nodes: [0] });
  assert.deepEqual(partsOf('Body*'), { materials: [0], nodes: [3, 0, 1] });
  assert.deepEqual(partsOf('*fabric'), { materials: [0, 1], nodes: [] });
  assert.deepEqual(partsOf('*rim*'), { materials: [2], nodes: [] });
  assert.deepEqual(partsOf('*e*v*'), { materials: [1], nodes: [2] });
  assert.deepEqual(partsOf('*').materials, [0, 1, 2, 3]);
});

test('digits are an index, unless a material has that name', () => {
  assert.deepEqual(partsOf('1'), { materials: [1], nodes: [] });
  assert.deepEqual(partsOf('7'), { materials: [3], nodes: [] });
});

test('an index holds before names, and a later name before an earlier one', () => {
  const order = resolveMaterials({ materials: { Trim: { preset: 'silk' }, '*': { preset: 'denim' }, 2: { preset: 'satin' } } }, NAMES);
  assert.deepEqual(
    order.map(({ preset }) => preset),
    ['silk', 'denim', 'satin'],
  );
});

test('what nothing is called is an error that says what there is', () => {
  const missing = (selector) => () => partsOf(selector);
  assert.throws(missing('Trimm'), { code: 'E_CLOTH', pointer: '/materials/Trimm', message: /no material or node "Trimm"; did you mean "Trim"\?/ });
  assert.throws(missing('a/b*'), { code: 'E_CLOTH', pointer: '/materials/a~1b*', message: /it has "Body fabric", "Sleeve fabric", "Trim", "7", "Root"/ });
  assert.throws(missing('9'), { code: 'E_CLOTH' });
});

test('a name that was made to cost time costs none', () => {
  const names = { materials: ['a'.repeat(20_000)], nodes: [] };
  assert.throws(() => resolveMaterials({ materials: { [`${'*a'.repeat(2_000)}b`]: {} } }, names), { code: 'E_CLOTH' });
});

test('cloths have defaults, and colours become linear', () => {
  const [denim] = resolveMaterials({ materials: { Trim: { preset: 'denim', color: '#ffffff' } } }, NAMES);
  assert.deepEqual(denim, { materials: [2], nodes: [], preset: 'denim', color: [1, 1, 1], scale: 1, metresPerUv: null, rotation: 0 });
  assert.throws(() => resolveMaterials({ materials: { Trim: { preset: 'denmi' } } }, NAMES), { code: 'E_SHOT', pointer: '/materials/Trim/preset' });
  assert.throws(() => resolveMaterials({ materials: { Trim: { scale: 0 } } }, NAMES), { code: 'E_SHOT', pointer: '/materials/Trim/scale' });
});

test('metres of the texture coordinates are measured, or stated: one number for both, or each', () => {
  const stated = (metresPerUv) => resolveMaterials({ materials: { Trim: { preset: 'denim', metresPerUv } } }, NAMES)[0].metresPerUv;
  assert.deepEqual([stated(0.5), stated([0.5, 2]), stated(null)], [[0.5, 0.5], [0.5, 2], null]);
  for (const wrong of [0, -1, [1], [1, 2, 3], [1, 0], '1 m'])
    assert.throws(() => stated(wrong), {
      code: 'E_SHOT',
      pointer: /^\/materials\/Trim\/metresPerUv/,
      message: /metres in \[0\.000001, 1000000\], \[metres along u, metres along v\], or null/,
    });
});

test('a resolved shot has them, and resolves to itself', () => {
  const facts = { bounds: { min: [0, 0, 0], max: [1, 1, 1] } };
  const once = resolveShot({ materials: { Trim: { preset: 'denim' } } }, facts);
  assert.deepEqual(once.materials, { Trim: { preset: 'denim', color: null, scale: 1, metresPerUv: null, rotation: 0 } });
  assert.deepEqual(resolveShot(once, facts), once);
});

test('their order is part of what a shot asks for', () => {
  const [a, b] = [{ preset: 'denim' }, { preset: 'satin' }];
  const keys = [
    { '*': a, Trim: b },
    { Trim: b, '*': a },
  ].map((materials) => JSON.stringify(shotIdentity({ materials })));
  assert.notEqual(keys[0], keys[1]);
});
