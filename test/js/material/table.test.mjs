import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import * as THREE from 'three';
import { cppFiles } from '../../../js/build/material/cpp.mjs';
import { shaderFiles } from '../../../js/build/material/glsl.mjs';
import { LAYERS, texturesOf, textureName, upper } from '../../../js/material/table.mjs';

const threeText = Object.values(THREE.ShaderChunk).join('\n');

test('what the table says three.js calls a property is one, and a define of its shaders', () => {
  const material = new THREE.MeshPhysicalMaterial();
  const derived = ['anisotropyVector'];
  for (const layer of LAYERS.filter(({ three }) => three)) {
    assert.match(threeText, new RegExp(`\\b${layer.three}\\b`));
    for (const { three } of layer.rows) assert.ok(!three || three in material, three);
    for (const { three } of texturesOf(layer)) {
      assert.ok(`${three}Map` in material, three);
      assert.match(threeText, new RegExp(`\\bUSE_${upper(three)}MAP\\b`));
    }
    for (const { three, name } of layer.derived ?? []) assert.ok(derived.includes(name) || three.match(/\w+/g).some((word) => word in material), three);
  }
});

test('no two textures have one name, and every texture has its uniform, its varying and its transform', () => {
  const textures = LAYERS.flatMap(texturesOf);
  assert.equal(new Set(textures.map(textureName)).size, textures.length);
  const { 'material/layer_declarations.glsl': declarations, 'material/uv_varyings.glsl': varyings, 'material/uv_transforms.glsl': transforms } = shaderFiles();
  for (const texture of textures) {
    const name = textureName(texture);
    assert.match(declarations, new RegExp(`#if ${upper(name)}_MAP\\nuniform sampler2D ${name}Map;`));
    assert.ok(
      varyings.includes(`uniform mat3 ${name}UvTransform;`) && transforms.includes(`${name}UvTransform * vec3(${upper(name)}_UV1 == 1 ? uv1 : uv0, 1.0)`),
      name,
    );
  }
});

test('the schema of cloth has the ranges and defaults of the table', () => {
  const schema = JSON.parse(readFileSync(new URL('../../../js/assets/TELAR_materials_fabric.schema.json', import.meta.url), 'utf8'));
  const resolved = (node) => (node?.$ref ? { ...schema.$defs[node.$ref.split('/').at(-1)], ...node } : node);
  let compared = 0;
  for (const row of LAYERS.flatMap((layer) => layer.rows.filter(({ extension = layer.extension, type }) => extension === schema.title && type !== 'name'))) {
    const path = [...(row.within?.split('/') ?? []), row.key];
    const node = path.reduce((object, key) => resolved(object?.properties?.[key]), schema);
    assert.ok(node, path.join('/'));
    const { minimum, maximum } = row.type ? resolved(node.items) : node;
    assert.deepEqual([minimum, maximum], [row.min ?? 0, row.max ?? 1], path.join('/'));
    const [fallback] = [node.default ?? row.default ?? 0].flat();
    assert.equal(fallback, row.default ?? 0, path.join('/'));
    compared++;
  }
  assert.ok(compared >= 11, `${compared}`);
});

test('a range is read as the row has it, and a texture only where its layer shows', () => {
  const readers = cppFiles()['asset/physical_readers.inc'];
  assert.match(readers, /out\.dispersion = in\.factor\("dispersion", 0, 0, 40\);/);
  assert.match(readers, /if \(l\.clearcoatFactor > 0\) \{\n {4}out\.clearcoatTexture = in\.texture\("clearcoatTexture"\);/);
  assert.match(readers, /\n {2}out\.specularTexture = in\.texture\("specularTexture"\);/);
});
