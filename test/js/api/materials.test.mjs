import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

const clothFile = (name) => readFile(new URL(`../../../js/assets/cloths/${name}.glb`, import.meta.url));

/** Squares of 10 cm side by side: node and material of each by name; `uv` stretches its texture coordinates about `origin`. */
async function squares(list) {
  const builder = new GlbBuilder();
  for (const [i, { node, material, uv = [1, 1], origin = 0, ...rest }] of list.entries()) {
    const geometry = plane(0.1, 0.1);
    const uvs = geometry.uvs.map((x, at) => (x - origin) * uv[at % 2]);
    const made = builder.material({ name: material, doubleSided: true, roughness: 1, ...rest });
    builder.add({ ...geometry, uvs }, made, { name: node, translation: [0.12 * i, 0, 0] });
  }
  return renderer.load(await builder.bytes());
}

const SHOT = { size: { width: 96, height: 96 }, shading: 'fabric', output: { format: 'raw' } };
const CLOSE = { ...SHOT, camera: { projection: 'orthographic', height: 0.04, view: 'front', frame: 'scene' } };
const OVERHEAD = { position: [0, 0, 1], target: [0, 0, 0], projection: 'orthographic', height: 0.03, near: 0.1, far: 2 };
const draw = async (model, shot) => (await renderer.render(model, { ...CLOSE, camera: OVERHEAD, ...shot })).data;
const furthest = (a, b) => a.reduce((most, x, i) => Math.max(most, Math.abs(x - b[i])), 0);

test('a cloth has its true size, whatever texture coordinates the garment has', async () => {
  // White, and of a class whose picture and sheen are left to it: the square itself is what is wanted.
  const wanted = await draw(await renderer.load(await clothFile('sequin-thread')), {});
  for (const uv of [
    [1, 1],
    [7, 3],
    [0.25, 12],
  ]) {
    const garment = await squares([{ node: 'front', material: 'plain', uv }]);
    const dressed = (changes) => draw(garment, { materials: { plain: { preset: 'sequin-thread', color: [1, 1, 1], ...changes } } });
    assert.ok(furthest(await dressed({}), wanted) <= 2, `${uv}: ${furthest(await dressed({}), wanted)}`);
    assert.ok(furthest(await dressed({ scale: 1.1 }), wanted) > 20, 'another scale shows');
    assert.ok(furthest(await dressed({ rotation: 20 }), wanted) > 20, 'another grain line shows');
  }
});

test('a garment whose size is stated wears the cloth in that, along u and along v', async () => {
  const garment = await squares([{ node: 'front', material: 'plain', uv: [4, 2] }]); // a unit of u is 2.5 cm, one of v 5 cm
  const dressed = (changes) => draw(garment, { materials: { plain: { preset: 'sequin-thread', color: [1, 1, 1], ...changes } } });
  const measured = await dressed({});
  assert.ok(furthest(await dressed({ metresPerUv: [0.025, 0.05] }), measured) <= 2, 'as it is');
  assert.ok(furthest(await dressed({ metresPerUv: 0.05 }), measured) > 20, 'twice as many discs along u');
  const halved = await dressed({ scale: 0.5 });
  assert.ok(furthest(await dressed({ metresPerUv: [0.05, 0.1] }), halved) <= 2, 'a garment of twice the size');
});

test('a rotation turns the cloth counter-clockwise', async () => {
  // Denim's twill runs one way; a quarter turn of the cloth is a quarter turn of the camera the other way.
  const garment = await squares([{ node: 'front', material: 'plain', uv: [3, 2], origin: 0.5 }]); // turned about what is seen
  const shot = { camera: { ...OVERHEAD, height: 0.012 }, layers: ['albedo'] };
  const albedo = async (materials, camera) =>
    (
      await renderer.render(garment, {
        ...SHOT,
        ...shot,
        camera: { ...shot.camera, ...camera },
        materials,
        output: { format: 'raw', layers: { format: 'raw' } },
      })
    ).layers.albedo;
  const floats = (bytes) => new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
  const cloth = { preset: 'denim', color: [0.1, 0.1, 0.1] };
  const turned = floats(await albedo({ plain: { ...cloth, rotation: 90 } }, {}));
  // Up is where the cloth's up went: to the left.
  const followed = floats(await albedo({ plain: cloth }, { up: [1, 0, 0] }));
  const straight = floats(await albedo({ plain: cloth }, {}));
  const mean = (a, b) => a.reduce((sum, x, i) => sum + Math.abs(x - b[i]), 0) / a.length;
  assert.ok(mean(turned, followed) < 0.25 * mean(turned, straight), `${mean(turned, followed)} against ${mean(turned, straight)}`);
});

test('its colour is the mean of what it shows', async () => {
  const garment = await squares([{ node: 'front', material: 'plain' }]);
  const color = [0.2, 0.1, 0.05];
  for (const preset of ['denim', 'towel']) {
    const { layers } = await renderer.render(garment, {
      ...SHOT,
      camera: { ...OVERHEAD, height: 0.08 },
      layers: ['albedo'],
      materials: { plain: { preset, color } },
      output: { format: 'raw', layers: { format: 'raw' } },
    });
    const floats = new Float32Array(layers.albedo.buffer.slice(layers.albedo.byteOffset, layers.albedo.byteOffset + layers.albedo.byteLength));
    const mean = [0, 1, 2].map((c) => floats.filter((_, i) => i % 3 === c).reduce((sum, x) => sum + x, 0) / (floats.length / 3));
    // A pixel reads a level of 8 bits in sRGB.
    mean.forEach((x, c) => assert.ok(Math.abs(x / color[c] - 1) < 0.02, `${preset}: ${mean}`));
  }
});

test("the sheen of a preset takes the cloth's colour, whoever gives it", async () => {
  const red = [0.4, 0.02, 0.002];
  const velvet = (color, sheen) => {
    const builder = new GlbBuilder();
    const { uvs, ...bare } = plane(0.1, 0.1);
    assert.ok(uvs);
    const layers = { fabric: { definition: { preset: 'velvet' }, textures: {} }, ...(sheen && { sheen: { sheenColorFactor: sheen } }) };
    const material = builder.material({ name: 'plain', baseColor: [...color, 1], doubleSided: true, layers });
    material.setMetallicFactor(1).setRoughnessFactor(1); // left to the preset
    builder.add(bare, material, { name: 'front' });
    return builder.bytes();
  };
  const grazing = { camera: { ...OVERHEAD, position: [0, -1, 0.15] }, lights: [{ type: 'directional', position: [0, 1, 0.15], intensity: 3 }] };
  const wanted = await draw(await velvet(red), grazing);
  const blue = await velvet([0.02, 0.04, 0.5]);
  const recolored = await draw(blue, { ...grazing, materials: { plain: { color: red } } });
  const worn = await draw(await velvet([1, 1, 1]), { ...grazing, materials: { plain: { preset: 'velvet', color: red } } });
  assert.ok(furthest(recolored, wanted) <= 1, `recoloured: ${furthest(recolored, wanted)}`);
  assert.ok(furthest(worn, wanted) <= 1, `worn: ${furthest(worn, wanted)}`);
  // The undyed sheen, which each of the three would show if its colour were forgotten, is told from it.
  assert.ok(furthest(await draw(await velvet(red, [1, 1, 1]), grazing), wanted) > 20, 'white rims');
});

test("light that passes through a preset's cloth takes its colour, whoever gives it", async () => {
  const red = [0.5, 0.03, 0.01];
  const jersey = (color, diffuseTransmission) => {
    const builder = new GlbBuilder();
    const { uvs, ...bare } = plane(0.1, 0.1);
    assert.ok(uvs);
    const layers = { fabric: { definition: { preset: 'cotton-jersey' }, textures: {} }, ...(diffuseTransmission && { diffuseTransmission }) };
    const material = builder.material({ name: 'plain', baseColor: [...color, 1], doubleSided: true, layers });
    material.setMetallicFactor(1).setRoughnessFactor(1); // left to the preset
    builder.add(bare, material, { name: 'front' });
    return builder.bytes();
  };
  const behind = { environment: 'none', lights: [{ type: 'directional', position: [0, 0, -1], intensity: 6 }], toneMapping: 'none' };
  const mean = (pixels, c) => pixels.filter((_, i) => i % 4 === c).reduce((sum, x) => sum + x, 0) / (pixels.length / 4);
  const wanted = await draw(await jersey(red), behind);
  assert.ok(mean(wanted, 0) > 60 && mean(wanted, 1) < 0.45 * mean(wanted, 0), `${mean(wanted, 0)} ${mean(wanted, 1)}`);
  const recolored = await draw(await jersey([0.02, 0.04, 0.5]), { ...behind, materials: { plain: { color: red } } });
  const worn = await draw(await jersey([1, 1, 1]), { ...behind, materials: { plain: { preset: 'cotton-jersey', color: red } } });
  assert.ok(furthest(recolored, wanted) <= 1 && furthest(worn, wanted) <= 1, `${furthest(recolored, wanted)} ${furthest(worn, wanted)}`);
  // White light through, which a file may say, is told from it.
  const white = await draw(await jersey(red, { diffuseTransmissionFactor: 0.2, diffuseTransmissionColorFactor: [1, 1, 1] }), behind);
  assert.ok(mean(white, 1) > 0.9 * mean(white, 0), `${mean(white, 0)} ${mean(white, 1)}`);
});

test('the rest of the model stays as it was, and a node comes before a material', async () => {
  const list = ['left', 'right'].map((node) => ({ node, material: 'plain', baseColor: [0.6, 0.6, 0.6, 1] }));
  const garment = await squares(
    [
      { node: 'left', material: 'a' },
      { node: 'right', material: 'b' },
    ].map((item, i) => ({ ...list[i], ...item })),
  );
  const at = (x) => ({ camera: { ...OVERHEAD, position: [x, 0, 1], target: [x, 0, 0] } });
  const [left, right] = [at(0), at(0.12)];
  const plain = { left: await draw(garment, left), right: await draw(garment, right) };
  const red = { color: [0.5, 0.02, 0.02] };
  const blue = { color: [0.02, 0.02, 0.5] };
  assert.deepEqual(await draw(garment, { ...right, materials: { a: red } }), plain.right);
  assert.notDeepEqual(await draw(garment, { ...left, materials: { a: red } }), plain.left);
  const wanted = await draw(garment, { ...left, materials: { a: red } });
  assert.deepEqual(await draw(garment, { ...left, materials: { left: red, a: blue } }), wanted, 'of a node');
  assert.deepEqual(await draw(garment, { ...left, materials: { a: blue, '*a*': red } }), wanted, 'the later one');
  assert.deepEqual(await draw(garment, { ...left, materials: { left: red } }), wanted);
});

test('the path tracer puts on the same', async () => {
  const garment = await squares([{ node: 'front', material: 'plain', uv: [2, 3] }]);
  const shot = {
    ...SHOT,
    camera: { ...OVERHEAD, height: 0.02 },
    layers: ['albedo'],
    materials: { plain: { preset: 'denim', color: [0.2, 0.1, 0.05], rotation: 30 } },
  };
  const output = { format: 'raw', layers: { format: 'raw' } };
  const draws = [{ samples: 1 }, { preset: 'reference', samples: 1 }].map((quality) => renderer.render(garment, { ...shot, quality, output }));
  const [raster, traced] = (await Promise.all(draws)).map(({ layers: { albedo } }) => new Float32Array(albedo.buffer.slice(albedo.byteOffset)));
  const means = [raster, traced].map((floats) => floats.reduce((sum, x) => sum + x, 0) / floats.length);
  assert.ok(Math.abs(means[0] / means[1] - 1) < 0.01, `${means}`);
});

test('a part without texture coordinates wears the cloth without its maps, with a warning', async () => {
  const builder = new GlbBuilder();
  const { uvs, ...bare } = plane(0.1, 0.1);
  builder.add(bare, builder.material({ name: 'plain' }), { name: 'front' });
  assert.ok(uvs);
  const { info } = await renderer.render(await builder.bytes(), { ...SHOT, materials: { plain: { preset: 'denim' } } });
  assert.deepEqual(
    info.warnings.map(({ code }) => code),
    ['W_CLOTH_UV'],
  );
});

test('shots share what is dressed alike, keys tell them apart, and nothing of the GPU is left', async () => {
  // A renderer of its own: models of the tests before go when their finalizers run.
  const own = await createRenderer();
  const garment = await squares([{ node: 'front', material: 'plain' }]);
  const materials = { plain: { preset: 'towel' } };
  const shots = [{ materials }, { materials }, { materials: { plain: { preset: 'satin' } } }, {}].map((shot) => ({ ...CLOSE, camera: OVERHEAD, ...shot }));
  const frames = await own.renderAll(garment, shots);
  assert.deepEqual(frames[0].data, frames[1].data);
  assert.equal(new Set(frames.map(({ info }) => info.key)).size, 3);
  assert.deepEqual(frames[3].data, await draw(garment, {}));
  // Programs stay.
  const objects = await own.liveObjects();
  await own.renderAll(garment, shots);
  assert.equal(await own.liveObjects(), objects);
  await own.close();
});

test('what the model does not have is told', async () => {
  const garment = await squares([{ node: 'front', material: 'plain' }]);
  await assert.rejects(draw(garment, { materials: { sleeve: { preset: 'denim' } } }), { code: 'E_CLOTH', pointer: '/materials/sleeve' });
});
