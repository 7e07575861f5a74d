import assert from 'node:assert/strict';
import { readFile, readdir, stat } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { before, test } from 'node:test';
import { NodeIO } from '@gltf-transform/core';
import { KHRMaterialsVariants, KHRTextureTransform } from '@gltf-transform/extensions';
import validator from 'gltf-validator';

const assets = fileURLToPath(new URL('../../../js/assets/', import.meta.url));
const PARTS = ['back', 'front', 'hem_bottom', 'hem_sleeve_left', 'hem_sleeve_right', 'neck_label', 'neck_rib', 'neck_tape', 'sleeve_left', 'sleeve_right'];
let bytes;
let root;

before(async () => {
  bytes = await readFile(path.join(assets, 'tshirt.glb'));
  root = (await new NodeIO().registerExtensions([KHRMaterialsVariants, KHRTextureTransform]).readBinary(new Uint8Array(bytes))).getRoot();
});

const primitiveOf = (part) =>
  root
    .listNodes()
    .find((node) => node.getName() === part)
    .getMesh()
    .listPrimitives()[0];

/** Length in texture coordinates over length in space, for every triangle edge of a part, sorted. */
function edgeScales(part) {
  const primitive = primitiveOf(part);
  const [position, uv, indices] = [
    primitive.getAttribute('POSITION').getArray(),
    primitive.getAttribute('TEXCOORD_0').getArray(),
    primitive.getIndices().getArray(),
  ];
  const scales = [];
  for (let t = 0; t < indices.length; t += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [indices[t + k], indices[t + ((k + 1) % 3)]];
      const inSpace = Math.hypot(...[0, 1, 2].map((c) => position[a * 3 + c] - position[b * 3 + c]));
      const onPattern = Math.hypot(...[0, 1].map((c) => uv[a * 2 + c] - uv[b * 2 + c]));
      if (inSpace > 0.003) scales.push(onPattern / inSpace);
    }
  }
  return scales.sort((a, b) => a - b);
}

test('the validator has nothing to say against the T-shirt', async () => {
  const { issues } = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 20 });
  assert.deepEqual({ errors: issues.numErrors, warnings: issues.numWarnings }, { errors: 0, warnings: 0 }, JSON.stringify(issues.messages, null, 1));
});

test('the T-shirt stays under 3 MB, all bundled assets under 4 MB', async () => {
  assert.ok(bytes.length < 3e6, `${bytes.length} bytes`);
  const sizes = await Promise.all(
    (await readdir(assets, { withFileTypes: true })).filter((entry) => entry.isFile()).map(async (entry) => (await stat(path.join(assets, entry.name))).size),
  );
  assert.ok(sizes.reduce((a, b) => a + b) < 4e6);
});

test('every part of the garment is a node of its own, with a name', () => {
  const parts = root
    .listNodes()
    .filter((node) => node.getMesh())
    .map((node) => node.getName())
    .sort();
  assert.deepEqual(parts, PARTS);
});

test('it is a size M in metres that stands on the origin and faces +Z', () => {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const part of PARTS) {
    const position = primitiveOf(part).getAttribute('POSITION');
    position.getMin([]).forEach((value, c) => {
      low[c] = Math.min(low[c], value);
    });
    position.getMax([]).forEach((value, c) => {
      high[c] = Math.max(high[c], value);
    });
  }
  assert.ok(Math.abs(low[1]) < 1e-6 && high[1] > 0.66 && high[1] < 0.76, `height ${low[1]}..${high[1]}`);
  assert.ok(high[0] - low[0] > 0.6 && high[0] - low[0] < 0.85 && Math.abs(high[0] + low[0]) < 1e-6);
  const middle = (part, c) => (primitiveOf(part).getAttribute('POSITION').getMin([])[c] + primitiveOf(part).getAttribute('POSITION').getMax([])[c]) / 2;
  assert.ok(middle('front', 2) > middle('back', 2) + 0.08);
  assert.ok(middle('sleeve_left', 0) > 0.2 && middle('sleeve_right', 0) < -0.2);
});

for (const part of ['front', 'back', 'sleeve_left', 'sleeve_right']) {
  test(`a metre on the pattern of ${part} is a metre of cloth`, () => {
    const scales = edgeScales(part);
    const at = (share) => scales[Math.floor((scales.length - 1) * share)];
    assert.ok(Math.abs(at(0.5) - 1) < 0.02, `median ${at(0.5)}`);
    assert.ok(at(0.05) > 0.9 && at(0.95) < 1.1, `5 % ${at(0.05)}, 95 % ${at(0.95)}`);
  });
}

test('the knit repeats every 20 mm and its wales stand upright', () => {
  for (const material of root.listMaterials()) {
    const transform = material.getBaseColorTextureInfo().getExtension('KHR_texture_transform');
    if (material.getName() === 'label') continue;
    assert.ok(transform.getScale().every((scale) => Math.abs(scale - 50) < 1e-6));
    assert.equal(transform.getRotation(), 0);
  }
  const primitive = primitiveOf('front');
  const [position, uv] = [primitive.getAttribute('POSITION').getArray(), primitive.getAttribute('TEXCOORD_0').getArray()];
  let [product, square] = [0, 0];
  const mean = [0.36, -0.36];
  for (let i = 0; i < uv.length / 2; i++) {
    product += (position[i * 3 + 1] - mean[0]) * (uv[i * 2 + 1] - mean[1]);
    square += (uv[i * 2 + 1] - mean[1]) ** 2;
  }
  assert.ok(product / square < -0.8, 'v runs down the garment');
});

test('three colourways, each with a material for every part', () => {
  const list = root.listExtensionsUsed().find((extension) => extension.extensionName === 'KHR_materials_variants');
  assert.ok(list);
  for (const part of PARTS) {
    const mappings = primitiveOf(part).getExtension('KHR_materials_variants').listMappings();
    assert.deepEqual(
      mappings.flatMap((mapping) => mapping.listVariants().map((variant) => variant.getName())),
      ['natural', 'terracotta', 'indigo'],
    );
    assert.equal(primitiveOf(part).getMaterial(), mappings[0].getMaterial(), 'the first colourway is the default');
    const distinct = new Set(mappings.map((mapping) => mapping.getMaterial())).size;
    assert.equal(distinct, part === 'neck_label' ? 1 : 3);
  }
});

test("the drape's occlusion lies on the second coordinates, which stay inside of the picture", () => {
  for (const material of root.listMaterials()) assert.equal(material.getOcclusionTextureInfo().getTexCoord(), 1);
  for (const part of PARTS) {
    const atlas = primitiveOf(part).getAttribute('TEXCOORD_1').getArray();
    assert.ok(atlas.every((value) => value > 0 && value < 1));
  }
});

test('the file says whose it is', () => {
  assert.match(root.getAsset().copyright, /telar/);
});
