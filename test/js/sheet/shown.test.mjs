// Views of a sheet with ghosts and with parts apart: sizes of what they show, and what is refused.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { readOptions } from '../../../js/sheet/options.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';

let renderer, model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  const cloth = builder.material({ name: 'cloth', doubleSided: true });
  builder.add(plane(0.4, 0.6), builder.material({ name: 'red', baseColor: [0.8, 0.1, 0.1, 1], doubleSided: true }), {
    name: 'front',
    translation: [0, 0, 0.1],
  });
  builder.add(plane(0.5, 0.6), cloth, { name: 'back', translation: [0, 0, -0.1], rotation: [0, 1, 0, 0] });
  builder.add(plane(1, 1.8), cloth, { name: 'mannequin', translation: [0, 0, -0.3] });
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

const ALONE = [{ node: 'manne*', opacity: 0 }];
const sheet = (spec) => createSheet(model, { ppi: 36, ...spec }, { renderer, format: 'svg' });

/** Metres across and up that each view shows. */
async function sizes(views) {
  const { layout, engine } = await layOut(model, { views }, readOptions({ renderer }));
  engine.close();
  return layout.spec.views.map((view) => {
    const { width, height } = layout.extent(view);
    return [width, height].map((x) => Number(x.toFixed(4)));
  });
}

test('a view is as large as what it shows', async () => {
  const side = { azimuth: 90, elevation: 0 };
  const found = await sizes([
    { name: 'whole' },
    { name: 'garment', ghost: ALONE },
    { name: 'sheer', ghost: [{ node: 'manne*' }] },
    { name: 'front', ghost: [...ALONE, { node: 'back', opacity: 0 }] },
    { name: 'together', ...side, ghost: ALONE },
    { name: 'apart', ...side, ghost: ALONE, explode: 0.25 },
  ]);
  assert.deepEqual(found, [
    [1, 1.8],
    [0.5, 0.6],
    [1, 1.8],
    [0.4, 0.6],
    [0.2, 0.6],
    [0.7, 0.6],
  ]);
});

test('pictures and flats of such views are drawn, and others than those of the whole', async () => {
  const view = { name: 'one', view: 'three-quarter' };
  const pages = [];
  for (const more of [
    {},
    { ghost: ALONE },
    { ghost: [...ALONE, { node: 'front' }] },
    { ghost: ALONE, explode: 0.1 },
    { ghost: ALONE, explode: 0.1, style: 'flat' },
  ])
    pages.push((await sheet({ views: [{ ...view, ...more }] })).files[0].toString());
  assert.equal(new Set(pages).size, pages.length);
});

const WRONG = [
  [
    { views: [{ name: 'a' }, { name: 'b', ghost: [{ node: 'hood', opacity: 0 }] }] },
    '/views/1/ghost/0',
    /spec\.views\[1\]\.ghost\[0\]: the model draws no node .*hood/,
  ],
  [{ views: [{ name: 'a' }, { name: 'b', ghost: [{ node: 'back' }, { node: 'hood' }] }] }, '/views/1/ghost/1', /the model draws no node .*hood/],
  [{ views: [{ name: 'a', style: 'flat', ghost: [{ material: 'hood' }] }] }, '/views/0/ghost/0', /the model draws no material .*hood/],
  [{ views: [{ name: 'a', ghost: [{ node: '*', opacity: 0 }] }] }, '/views/0/ghost', /leaves a part/],
  [{ views: [{ name: 'a', explode: -1 }] }, '/views/0/explode', /expected/],
  [{ views: [{ name: 'a', explode: 0.1 }], callouts: [{ point: [0, 0, 0], text: 'x' }] }, '/callouts/0/view', /not exploded/],
  [{ views: [{ name: 'a', explode: 0.1 }], measures: [{ code: 'A', description: 'x', border: true }] }, '/measures/0/view', /not exploded/],
];
for (const [spec, pointer, message] of WRONG)
  test(`refused at ${pointer}: ${message}`, async () => {
    await assert.rejects(sheet(spec), { code: 'E_SPEC', pointer, message });
  });
