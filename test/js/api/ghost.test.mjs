// Parts that are seen through, by raster and path tracer: a red square 0.2 m before a blue one. Each figure is checked against
// the picture without the ghost, which has to miss it.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { BLUE, RED } from './support/layer_scenes.mjs';
import './support/real.mjs';

const SIZE = 16;
const CENTRE = SIZE * (SIZE / 2) + SIZE / 2;
const QUALITIES = { raster: 'standard', reference: { preset: 'reference', samples: 1024, transport: 'direct' } };

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  const [red, blue] = [RED, BLUE].map((baseColor, i) => builder.material({ name: ['red', 'blue'][i], baseColor, doubleSided: true, unlit: true }));
  builder.add(plane(1, 1), red, { name: 'front_left', translation: [0, 0, 0.1] });
  builder.add(plane(1, 1), blue, { name: 'back', translation: [0, 0, -0.1] });
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

async function drawn(ghost, quality, rest = {}) {
  const shot = { size: { width: SIZE, height: SIZE }, camera: { view: 'front' }, environment: 'none', toneMapping: 'none', quality, ghost, ...rest };
  const {
    data,
    layers = {},
    info,
  } = await renderer.render(model, { ...shot, output: { format: 'raw', bitDepth: 32, layers: { format: 'raw' } } }, { timeoutMs: null });
  const floats = (bytes) => new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  const pixels = floats(data);
  const values = Object.fromEntries(Object.entries(layers).map(([name, bytes]) => [name, floats(bytes)[CENTRE]]));
  return { color: [...pixels.slice(4 * CENTRE, 4 * CENTRE + 4)], layers: values, info };
}

for (const [name, quality] of Object.entries(QUALITIES)) {
  test(`${name}: a ghost lets through what lies behind it`, async () => {
    const far = (color, opacity) => Math.max(...color.slice(0, 3).map((v, c) => Math.abs(v - (RED[c] * opacity + BLUE[c] * (1 - opacity)))));
    // The raster blends once. 1024 paths meet the front or not: a standard error of sqrt(0.25 / 1024) = 0.016 times what the colours differ by.
    const bar = { raster: 1e-3, reference: 0.04 }[name];
    assert.ok(far((await drawn([], quality)).color, 1) < bar, 'without ghosts');
    for (const opacity of [0, 0.25, 0.6]) {
      const { color } = await drawn([{ node: 'front_left', opacity }], quality);
      assert.ok(far(color, opacity) < bar, `${opacity}: ${color}`);
      assert.ok(far(color, opacity + 0.15) > bar, 'of another opacity');
      assert.ok(Math.abs(color[3] - 1) < 1e-6, 'the back covers the pixel');
    }
    assert.ok(far((await drawn([{ material: 'red' }], quality)).color, 0.25) < bar, 'by its material, as opaque as the default says');
    assert.ok(far((await drawn([{ node: 'f*_l*t' }], quality)).color, 0.25) < bar, 'by a pattern');
    assert.ok(
      far(
        (
          await drawn(
            [
              { node: 'front_left', opacity: 0.5 },
              { material: 0, opacity: 0.5 },
            ],
            quality,
          )
        ).color,
        0.25,
      ) < bar,
      'a node times its material',
    );
  });

  test(`${name}: layers do not have what is less opaque than a half`, async () => {
    const partOf = async (opacity) => (await drawn([{ node: 'front*', opacity }], quality, { layers: ['partId', 'depth'] })).layers;
    const [solid, sheer, gone] = [await partOf(0.6), await partOf(0.4), await partOf(0)];
    assert.deepEqual([solid.partId, sheer.partId, gone.partId], [1, 2, 2]);
    assert.ok(Math.abs(sheer.depth - solid.depth - 0.2) < 1e-5, `${sheer.depth} ${solid.depth}`);
  });

  test(`${name}: a part in another cloth is a ghost by the material of the file`, async () => {
    const worn = (ghost) => drawn(ghost, quality, { materials: { front_left: { color: 'lime' } }, layers: ['partId'] });
    assert.equal((await worn([])).layers.partId, 1, 'planted: nothing is left out');
    assert.equal((await worn([{ material: 'red', opacity: 0 }])).layers.partId, 2);
    assert.equal((await worn([{ material: 'blue', opacity: 0 }])).layers.partId, 1);
  });

  test(`${name}: a part that is not there is named`, async () => {
    await assert.rejects(drawn([{ node: 'back' }, { node: 'lining*' }], quality), {
      code: 'E_FRAME',
      pointer: '/ghost/1',
      message: /shot\.ghost\[1\]: the model draws no node .*lining\*/,
    });
  });
}

test('a ghost is part of what identifies a picture, and of a shot that is checked', async () => {
  const [plain, ghost] = [await drawn([], 'draft'), await drawn([{ node: 'back' }], 'draft')];
  assert.notEqual(plain.info.key, ghost.info.key);
  assert.deepEqual(ghost.info.shot.ghost, [{ node: 'back', opacity: 0.25 }]);
  await assert.rejects(drawn([{ node: 'back', opacity: 2 }], 'draft'), { code: 'E_SHOT', pointer: '/ghost/0/opacity' });
});
