import assert from 'node:assert/strict';
import { test } from 'node:test';
import { proposedPreset } from '../../../js/api/proposed_preset.mjs';
import { inspect } from '../../../js/index.mjs';
import { CLOTHS } from '../../../js/shot/table/cloths.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

test('a name suggests the cloth that it says, in whole words', () => {
  const said = {
    Body_Denim_v2: 'denim',
    'jeans front': 'denim',
    bodyVelvet: 'velvet',
    'Terciopelo rojo': 'velvet',
    'sequin thread': 'sequin-thread',
    'waxed cotton': 'waxed-cotton',
  };
  for (const [name, preset] of Object.entries(said)) assert.equal(proposedPreset(name), preset, name);
  for (const name of ['', 'Material.001', 'Cabinet', 'silken', 'interlacing', '布料']) assert.equal(proposedPreset(name), null, name);
});

test('every preset is suggested by its own name', () => {
  for (const preset of CLOTHS) assert.equal(proposedPreset(`Fabric ${preset.replaceAll('-', ' ')} 3`), preset);
});

test('inspect tells the size of texture coordinates: a squeezed patch changes nothing', async () => {
  const builder = new GlbBuilder();
  const scaled = (width, height, u, v) => {
    const square = plane(width, height, { cells: 4 });
    return { ...square, uvs: square.uvs.map((x, i) => x * (i % 2 === 0 ? u : v)) };
  };
  const denim = builder.material({ name: 'denim' });
  const bare = builder.material({ name: 'bare' });
  builder.add(scaled(0.6, 0.3, 2, 3), denim, { name: 'front' });
  builder.add(scaled(0.1, 0.1, 500, 0), denim, { name: 'squeezed' });
  builder.add(scaled(0.1, 0.1, 7, 9), denim, { name: 'small', scale: [0.5, 0.5, 0.5] });
  const { uvs, ...without } = plane(0.1, 0.1);
  assert.ok(uvs);
  builder.add(without, bare, { name: 'bare' });
  const { materials } = await inspect(await builder.bytes());
  const [u, v] = materials[0].metresPerUv;
  assert.ok(Math.abs(u - 0.3) < 1e-6 && Math.abs(v - 0.1) < 1e-6, `${u} ${v}`);
  assert.deepEqual(
    materials.map(({ metresPerUv, proposedPreset: proposed }) => [metresPerUv === null, proposed]),
    [
      [false, 'denim'],
      [true, null],
    ],
  );
});

test('inspect names the preset that a material has, and none that there is not', async () => {
  const builder = new GlbBuilder();
  for (const preset of ['velvet', 'no such cloth', undefined]) {
    const material = builder.material({ layers: { fabric: { definition: { preset }, textures: {} } } });
    builder.add(plane(0.1, 0.1), material);
  }
  const { materials } = await inspect(await builder.bytes());
  assert.deepEqual(
    materials.map(({ preset }) => preset),
    ['velvet', null, null],
  );
});
