import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { drapeCloth, CLOTH } from '../../../js/assets/make/fabrics/drape_cloth.mjs';
import { FABRICS } from '../../../js/assets/make/fabrics/index.mjs';
import { inspect } from '../../../js/index.mjs';

const FILE = new URL('../../../js/assets/fabrics.glb', import.meta.url);

test('the drape: small, valid, a variant for each fabric, half a metre wide and stood on the ground', async () => {
  const bytes = new Uint8Array(await readFile(FILE));
  assert.ok(bytes.length < 200_000, `${bytes.length} bytes`);
  const { issues } = await validator.validateBytes(bytes);
  // Tangents would only serve a stretched highlight, which no fabric here has: the renderer makes the frame of the normal map.
  const faults = issues.messages.filter(({ severity, code }) => severity < 2 && code !== 'MESH_PRIMITIVE_GENERATED_TANGENT_SPACE');
  assert.deepEqual(faults, []);
  const facts = await inspect(FILE);
  assert.deepEqual([facts.variants, facts.warnings, facts.drawCalls], [Object.keys(FABRICS), [], 1]);
  assert.deepEqual(
    facts.materials.map(({ name, roughness }) => [name, Number(roughness.toFixed(6))]),
    Object.entries(FABRICS).map(([name, { roughness }]) => [name, roughness]),
  );
  assert.ok(Math.abs(facts.bounds.min[1]) < 1e-4 && facts.size.every((metres) => metres > 0.3 && metres < 0.6), JSON.stringify(facts.bounds));
});

test('cloth that falls over the ball comes to rest upon it, and stretches little', () => {
  const cloth = { ...CLOTH, intervals: 24, steps: 900 };
  const { positions, indices, uv } = drapeCloth(cloth);
  const [x, y, z] = [0, 1, 2].map((c) => positions.filter((_, i) => i % 3 === c));
  const top = Math.max(...y);
  const centre = top - cloth.ball - 0.0035;
  const inside = x.filter((_, i) => Math.hypot(x[i], y[i] - centre, z[i]) < cloth.ball * 0.98);
  assert.equal(inside.length, 0, 'no particle in the ball');
  assert.ok(top > 0.2, `corners hang ${top} m`);
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b] = [indices[t], indices[t + 1]];
    const rest = Math.hypot(uv[a * 2] - uv[b * 2], uv[a * 2 + 1] - uv[b * 2 + 1]);
    const length = Math.hypot(x[a] - x[b], y[a] - y[b], z[a] - z[b]);
    assert.ok(length / rest < 1.15 && length / rest > 0.6, `edge ${a} ${b}: ${length / rest}`);
  }
});
