import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createRenderer, inspect } from '../../../js/index.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { instance } from '../../fixtures/motion.mjs';
import './support/real.mjs';

const BUTTONS = 5;

/** A panel of 2 x 2 cells, and a button of one cell that is drawn five times; the variant "red" has others of both. */
async function buttoned() {
  const builder = new GlbBuilder();
  const [cloth, horn, red, shell] = ['cloth', 'horn', 'red', 'shell'].map((name) => builder.material({ name }));
  builder.add(plane(0.4, 0.4, { cells: 2 }), cloth, { name: 'panel' });
  const button = builder.add(plane(0.01, 0.01), horn, { name: 'button' });
  instance(builder, button, { translation: Array.from({ length: 3 * BUTTONS }, (_, i) => i / 100) });
  builder.add(plane(0.1, 0.1), red);
  builder.add(plane(0.1, 0.1), shell);
  return editedGlb(await builder.bytes(), (json) => {
    json.extensionsUsed = [...(json.extensionsUsed ?? []), 'KHR_materials_variants'];
    json.extensions = { KHR_materials_variants: { variants: [{ name: 'red' }] } };
    const wears = (mesh, material) => {
      json.meshes[mesh].primitives[0].extensions = { KHR_materials_variants: { mappings: [{ material, variants: [0] }] } };
    };
    wears(0, 2);
    wears(1, 3);
  });
}

test('each instance counts: its triangles, its vertices, and what a variant draws most of', async () => {
  const { triangles, vertices, drawCalls, materials, variantMaterials } = await inspect(await buttoned());
  const [panel, square] = [
    { triangles: 8, vertices: 9 },
    { triangles: 2, vertices: 4 },
  ];
  const squares = BUTTONS + 2;
  assert.deepEqual([triangles, vertices, drawCalls], [panel.triangles + squares * square.triangles, panel.vertices + squares * square.vertices, 4]);
  assert.deepEqual(
    variantMaterials[0].map((i) => materials[i].name),
    ['shell', 'red'],
  );
});

test('a camera names the node of the file, which is what a shot frames by its number', async () => {
  const builder = new GlbBuilder();
  builder.add(plane(0.4, 0.4), null, { name: 'panel' });
  const bytes = editedGlb(await builder.bytes(), (json) => {
    json.cameras = [{ type: 'perspective', perspective: { yfov: 1, znear: 0.1 } }];
    json.nodes.push({ name: 'not in the scene' }, { mesh: 0, camera: 0, translation: [0, 3, 0], scale: [0.5, 0.5, 0.5] });
    json.scenes[0].nodes.push(2);
  });
  const { cameras } = await inspect(bytes);
  assert.deepEqual(
    cameras.map(({ node }) => node),
    [2],
  );
  const renderer = await createRenderer();
  const { part } = await renderer.factsOf(await renderer.load(bytes), { camera: { frame: { node: cameras[0].node } } });
  await renderer.close();
  assert.ok(Math.abs(part.bounds.min[1] - 2.9) < 1e-6, `${part.bounds.min}`);
});
