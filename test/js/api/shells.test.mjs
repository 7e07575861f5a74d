// The path tracer where the shells of a cloth pass through each other: the outer one is seen through the back of the inner one.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

const TSHIRT = readFileSync(new URL('../../../js/assets/tshirt.glb', import.meta.url));
const reference = (transport) => ({ preset: 'reference', transport, samples: 16 });

let renderer;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
});
after(() => renderer.close());

async function pixelsOf(model, shot) {
  const { data } = await renderer.render(model, { output: { format: 'raw', bitDepth: 32 }, ...shot });
  const floats = new Float32Array(data.buffer, data.byteOffset, data.length / 4);
  return Array.from({ length: floats.length / 4 }, (_, i) => Array.from(floats.subarray(4 * i, 4 * i + 4)));
}

/** A sheet of 1 x 1 m that faces the camera, and before it, so many metres, others that face away and are not drawn. */
async function sheets(...distances) {
  const glb = new GlbBuilder();
  const white = glb.material({ baseColor: [0.8, 0.8, 0.8, 1], roughness: 1 });
  glb.add(plane(1, 1), white);
  for (const distance of distances) glb.add(plane(1, 1), white, { translation: [0, 0, distance], rotation: [0, 1, 0, 0] });
  return glb.bytes();
}

const FACING = { projection: 'orthographic', height: 0.5, position: [0, 0, 2], target: [0, 0, 0], near: 0.1, far: 5 };

/** Mean radiance in the middle of the sheet. */
async function lightOf(model, { position, transport }) {
  const shot = {
    size: { width: 16, height: 16 },
    camera: FACING,
    environment: 'none',
    lights: [{ type: 'directional', position }],
    quality: reference(transport),
  };
  const pixels = await pixelsOf(model, shot);
  return pixels.reduce((sum, [r]) => sum + r, 0) / pixels.length;
}

for (const transport of ['occlusion', 'global']) {
  test(`${transport}: a shell that lies closely behind the back of another has its light, from aside too`, async () => {
    for (const position of [
      [0, 0, 1],
      [1, 0.5, 1],
    ]) {
      const alone = await lightOf(await sheets(), { position, transport });
      const behind = await lightOf(await sheets(0.004), { position, transport });
      assert.ok(Math.abs(behind / alone - 1) < 0.01, `${behind} behind the other, ${alone} alone`);
    }
  });
}

test('a wall farther off hides its light, behind a shell too', async () => {
  for (const distances of [[0.1], [0.004, 0.3]]) assert.equal(await lightOf(await sheets(...distances), { position: [0, 0, 1], transport: 'occlusion' }), 0);
});

test('the bundled T-shirt has no black armpits', async () => {
  const camera = { fovY: 12, position: [0.5, 0.55, 1.2], target: [0.22, 0.48, 0], near: 0.1, far: 5 };
  for (const transport of ['occlusion', 'global']) {
    const pixels = await pixelsOf(TSHIRT, { size: { width: 96, height: 96 }, camera, quality: reference(transport) });
    const cloth = pixels.filter(([, , , alpha]) => alpha === 1);
    const black = cloth.filter(([r]) => r < 0.02).length;
    assert.ok(cloth.length > 4000);
    assert.equal(black, 0, `${black} of ${cloth.length} pixels are black with transport ${transport}`);
  }
});
