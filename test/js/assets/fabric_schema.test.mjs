import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { z } from 'zod';
import { cppFiles } from '../../../js/build/material/cpp.mjs';
import { FABRIC_MODELS } from '../../fixtures/index.mjs';

const read = (file) => readFileSync(new URL(`../../../${file}`, import.meta.url), 'utf8');
const SCHEMA = JSON.parse(read('js/assets/TELAR_materials_fabric.schema.json'));
const PRESETS = JSON.parse(read('js/assets/fabric_presets.json'));
const NAME = 'TELAR_materials_fabric';

const fabric = z.fromJSONSchema(SCHEMA);

/** Names of the properties at any depth. */
const namesIn = ({ properties = {}, $ref }) => [
  ...Object.entries(properties).flatMap(([key, node]) => [key, ...namesIn(node)]),
  ...($ref && !$ref.endsWith('textureInfo') ? namesIn(SCHEMA.$defs[$ref.split('/').at(-1)]) : []),
];

test('every preset is what the schema says, and tells where its numbers are from', () => {
  assert.ok(Object.keys(PRESETS).length >= 13);
  for (const [name, { summary, why, material }] of Object.entries(PRESETS)) {
    assert.ok(summary && why.length > 0, name);
    const own = material.extensions?.[NAME];
    if (own) fabric.parse(own);
    const { warp, weft } = own?.weave ?? {};
    if (warp) assert.ok(warp.coverage + weft.coverage <= 1, name);
    const { metallicFactor, roughnessFactor } = material.pbrMetallicRoughness;
    assert.ok([0, 1].includes(metallicFactor) && roughnessFactor > 0, name);
  }
});

test('the schema takes the examples of the docs and refuses other types', () => {
  const examples = [...read('js/docs/fabric.md').matchAll(/```json\n([\s\S]*?)```/g)].map(([, text]) => JSON.parse(text));
  assert.ok(examples.length > 20);
  for (const example of examples) if (example.extensions?.[NAME]) fabric.parse(example.extensions[NAME]);
  const wrong = [
    { preset: 1 },
    { flatness: 2 },
    { weave: { threadsPerUv: [1] } },
    { weave: { warp: { coverage: -1 } } },
    { back: { baseColorFactor: [1, 1] } },
    { weave: { weaveTexture: {} } },
  ];
  for (const value of wrong) assert.equal(fabric.safeParse(value).success, false, JSON.stringify(value));
});

test('the loader reads the properties of the schema and no other', () => {
  const rules = cppFiles()
    ['asset/layer_rules.inc'].split('\n')
    .filter((line) => line.startsWith('constexpr Field TELAR_MATERIALS_FABRIC'))
    .join('\n');
  const inLoader = new Set([...rules.matchAll(/"(\w+)"/g)].map(([, name]) => name));
  assert.deepEqual([...inLoader].sort(), [...new Set(namesIn(SCHEMA))].sort());
});

test('every preset has a cloth among the fixtures, whose file names it', async () => {
  assert.deepEqual(
    Object.keys(FABRIC_MODELS).sort(),
    Object.keys(PRESETS)
      .map((name) => `fabric-${name}`)
      .sort(),
  );
  const glb = Buffer.from(await FABRIC_MODELS['fabric-denim']());
  const { materials } = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)));
  assert.equal(materials[0].extensions[NAME].preset, 'denim');
  fabric.parse(materials[0].extensions[NAME]);
});
