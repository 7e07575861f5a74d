import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { CONSTRUCTIONS } from '../../../js/assets/make/cloths/constructions.mjs';
import { PRESETS } from '../../../js/assets/make/cloths/index.mjs';
import { inspect } from '../../../js/index.mjs';

const FOLDER = new URL('../../../js/assets/cloths/', import.meta.url);
const NAMES = Object.keys(PRESETS);

// That the script makes these files is looked at in made.test.mjs.
test('each preset has a construction and a file, and nothing else lies there', async () => {
  assert.deepEqual(Object.keys(CONSTRUCTIONS).sort(), [...NAMES].sort());
  assert.deepEqual((await readdir(FOLDER)).sort(), NAMES.map((name) => `${name}.glb`).sort());
});

for (const name of NAMES) {
  test(`${name}: valid, small, a square of 10 cm`, async () => {
    const bytes = await readFile(new URL(`${name}.glb`, FOLDER));
    assert.ok(bytes.length <= 300_000, `${bytes.length} bytes`);
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    // Of the extensions it does not know telar's; tangents follow the texture coordinates.
    const known = ['MESH_PRIMITIVE_GENERATED_TANGENT_SPACE', 'UNSUPPORTED_EXTENSION'];
    assert.deepEqual(
      issues.messages.filter(({ severity, code }) => severity < 2 && !known.includes(code)),
      [],
    );
    const facts = await inspect(bytes, { shot: { shading: 'fabric' } });
    assert.deepEqual([facts.warnings, facts.materials.length, facts.size.map((metres) => Number(metres.toFixed(6)))], [[], 1, [0.1, 0.1, 0]]);
  });
}
