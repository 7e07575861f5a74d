import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FABRICS } from '../../../js/assets/make/fabrics/index.mjs';
import { createRenderer, evaluateShading } from '../../../js/index.mjs';
import './support/real.mjs';

const LOBES = ['diffuse', 'specular', 'sheen', 'coat', 'total'];
const near = (actual, expected, tolerance, text) => assert.ok(Math.abs(actual - expected) <= tolerance, `${text ?? ''}: ${actual}, expected ${expected}`);

const materialOf = ({ color = [1, 1, 1], roughness = 1, metallic = 0, ...extensions }) => ({
  pbrMetallicRoughness: { baseColorFactor: [...color, 1], metallicFactor: metallic, roughnessFactor: roughness },
  extensions,
});
const LAMBERT = materialOf({ color: [1, 0.5, 0.25], KHR_materials_specular: { specularFactor: 0 } });
const at = (elevation, azimuth) => [Math.sin(elevation) * Math.cos(azimuth), Math.sin(elevation) * Math.sin(azimuth), Math.cos(elevation)];

test('the albedo of a Lambert surface is its colour, from every side', async () => {
  for (const cosine of [1, 0.5, 0.1, 0.02]) {
    const { albedo, radiance } = await evaluateShading({ material: LAMBERT, viewAngle: Math.acos(cosine), albedo: true });
    LAMBERT.pbrMetallicRoughness.baseColorFactor.slice(0, 3).forEach((value, c) => near(albedo.diffuse[c] / value, 1, 1e-6, `NoV ${cosine}`));
    assert.deepEqual([albedo.specular, albedo.sheen, albedo.coat, radiance], [[0, 0, 0], [0, 0, 0], [0, 0, 0], []]);
  }
});

/** GGX with height-correlated Smith and Schlick's Fresnel: the BRDF of a metal times NoL, as Walter 2007 and Heitz 2014 write it. */
function ggx(l, v, f0, roughness) {
  const a2 = roughness ** 4;
  const h = l.map((x, i) => x + v[i]);
  const length = Math.hypot(...h);
  const [NoH, LoH] = [h[2] / length, h.reduce((sum, x, i) => sum + (x / length) * l[i], 0)];
  const d = a2 / (Math.PI * (NoH * NoH * (a2 - 1) + 1) ** 2);
  const smith = (NoX) => Math.sqrt(a2 + (1 - a2) * NoX * NoX);
  const visibility = 0.5 / (l[2] * smith(v[2]) + v[2] * smith(l[2]));
  const schlick = 2 ** ((-5.55473 * LoH - 6.98316) * LoH);
  return (f0 * (1 - schlick) + schlick) * visibility * d * l[2];
}

test('the lobe of a metal is that of the formula, but for the factor of the bounces between facets', async () => {
  const [roughness, viewAngle, f0] = [0.4, 0.7, 0.6];
  const directions = [at(0.7, Math.PI), at(0.5, 2.8), at(0.2, 0.4), at(1.2, 3), at(1.4, -2)];
  const material = materialOf({ color: [f0, f0, f0], metallic: 1, roughness });
  const { radiance } = await evaluateShading({ material, viewAngle, directions });
  const v = at(viewAngle, 0);
  const factors = radiance.map(({ specular }, i) => specular[0] / ggx(directions[i], v, f0, roughness));
  // The factor depends on the viewer alone.
  for (const factor of factors) near(factor / factors[0], 1, 1e-6);
  assert.ok(factors[0] > 1 && factors[0] < 1.2, String(factors[0]));
  assert.deepEqual(
    radiance.map(({ diffuse }) => diffuse),
    directions.map(() => [0, 0, 0]),
  );
});

test('lobes add up to the total, below the horizon is nothing, and a coat takes from what lies beneath', async () => {
  const directions = [at(0.3, 1), at(1, 2.5), at(2, 0)];
  const coated = materialOf({
    color: [0.4, 0.3, 0.2],
    roughness: 0.5,
    KHR_materials_clearcoat: { clearcoatFactor: 1, clearcoatRoughnessFactor: 0.2 },
    KHR_materials_sheen: { sheenColorFactor: [0.5, 0.5, 0.5], sheenRoughnessFactor: 0.4 },
  });
  const { radiance, albedo } = await evaluateShading({ material: coated, viewAngle: 1, directions, albedo: true });
  for (const lobes of [...radiance, albedo]) {
    const sum = LOBES.slice(0, 4).reduce((all, lobe) => all + lobes[lobe][0], 0);
    near(lobes.total[0], sum, 1e-12);
  }
  assert.ok(radiance[0].coat[0] > 0 && radiance[0].sheen[0] > 0);
  assert.deepEqual(radiance[2].total, [0, 0, 0]);
  const bare = structuredClone(coated);
  delete bare.extensions.KHR_materials_clearcoat;
  const plain = await evaluateShading({ material: bare, viewAngle: 1, directions });
  assert.ok(radiance[0].diffuse[0] < plain.radiance[0].diffuse[0]);
});

/** Rows of published or tabulated albedos, at cosines between normal and viewer. */
const COSINES = [0.02, 0.1, 0.3, 0.6, 1];
const WHITE_SHEEN = { KHR_materials_sheen: { sheenColorFactor: [1, 1, 1], sheenRoughnessFactor: 0.5 } };
const ROWS = [
  ['Disney diffuse, roughness 1', 'disney-2012', materialOf({}), 'diffuse', [1.52, 1.38, 1.15, 1.04, 1.04]],
  ['Disney diffuse, roughness 0.5', 'disney-2012', materialOf({ roughness: 0.5 }), 'diffuse', [1.01, 1.02, 1.02, 1.01, 1.01]],
  ['Disney diffuse, roughness 0', 'disney-2012', materialOf({ roughness: 0 }), 'diffuse', [0.54, 0.69, 0.89, 0.97, 0.98]],
  ['Frostbite diffuse, roughness 1', { base: 'disney-2012', diffuse: 'frostbite' }, materialOf({}), 'diffuse', [1.01, 0.91, 0.76, 0.69, 0.69]],
  ['Disney sheen', 'disney-2012', materialOf(WHITE_SHEEN), 'sheen', [0.084, 0.066, 0.034, 0.01, 0]],
  ['r115 diffuse', 'three-r115', materialOf({}), 'diffuse', [1, 1, 1, 1, 1]],
];

test('albedos of the principled shadings are those of their models', async () => {
  for (const [name, shading, material, lobe, expected] of ROWS) {
    for (const [i, cosine] of COSINES.entries()) {
      const { albedo } = await evaluateShading({ shading, material, viewAngle: Math.acos(cosine), albedo: true });
      // The rows are rounded to two or three digits.
      near(albedo[lobe][0], expected[i], 0.0051, `${name}, NoV ${cosine}`);
    }
  }
});

test('one term swapped changes its own lobe and no other', async () => {
  const material = materialOf({ color: [0.4, 0.3, 0.2], roughness: 0.5, ...WHITE_SHEEN });
  const lobesOf = async (shading) => (await evaluateShading({ shading, material, viewAngle: 0.9, directions: [at(0.6, 2)] })).radiance[0];
  const [plain, diffuse, sheen] = await Promise.all(
    ['disney-2012', { base: 'disney-2012', diffuse: 'lambert' }, { base: 'disney-2012', sheen: 'zeltner' }].map(lobesOf),
  );
  const changed = (lobes) => LOBES.filter((lobe) => Math.abs(lobes[lobe][0] - plain[lobe][0]) > 1e-12);
  assert.deepEqual(
    [changed(diffuse), changed(sheen)],
    [
      ['diffuse', 'total'],
      ['sheen', 'total'],
    ],
  );
});

test('shading fabric takes a material with its preset: yarns stretch the highlight of satin, and white cloth loses little', async () => {
  const satin = { pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 1] }, extensions: { TELAR_materials_fabric: { preset: 'satin' } } };
  const directions = [at(0.5, 0), at(0.5, Math.PI / 2)];
  const { radiance, albedo } = await evaluateShading({ material: satin, shading: 'fabric', directions, albedo: true });
  assert.ok(radiance[0].specular[0] > 5 * radiance[1].specular[0], 'light along the weft, which runs across the smooth warp');
  // The rest goes through: satin's preset lets 12 % of the diffuse light pass.
  assert.ok(albedo.total[0] > 0.85 && albedo.total[0] <= 0.9, String(albedo.total));
  const plain = await evaluateShading({ material: satin, directions, albedo: true });
  assert.equal(plain.albedo.diffuse[0], 0, 'the other shadings see a metal, as glTF says of a material without factors');
});

test('a material of a loaded model gives what the same material alone does', async () => {
  const renderer = await createRenderer();
  const model = await renderer.load(new URL('../../../js/assets/fabrics.glb', import.meta.url));
  await renderer.close();
  const material = model.facts.materials.findIndex(({ name }) => name === 'velvet');
  const directions = [at(0.5, 1), at(1.3, 3)];
  const own = await evaluateShading({ model, material, viewAngle: 0.8, directions });
  const { baseColor: color, roughness, sheen } = FABRICS.velvet;
  const same = materialOf({ color, roughness, KHR_materials_sheen: { sheenColorFactor: sheen.color, sheenRoughnessFactor: sheen.roughness } });
  assert.deepEqual(own, await evaluateShading({ material: same, viewAngle: 0.8, directions }));
});

test('wrong options and materials are refused by name', async () => {
  for (const [options, code, message] of [
    [{}, 'E_OPTION', /options\.material: expected a material/],
    [{ material: { name: 1n } }, 'E_OPTION', /^options\.material: expected plain data as in JSON \(.*BigInt.*\), got \{"name"\}$/],
    [{ material: { name: 'x'.repeat(7e7) } }, 'L_FILE_BYTES', /L_FILE_BYTES/],
    [{ material: LAMBERT, viewAngle: 1.6 }, 'E_OPTION', /options\.viewAngle/],
    [{ material: LAMBERT, directions: [[0, 0, 2]] }, 'E_OPTION', /options\.directions\[0\]: expected a unit vector/],
    [{ material: LAMBERT, directions: new Array(65537) }, 'E_OPTION', /at most 65536/],
    [{ material: LAMBERT, shading: 'phong' }, 'E_SHOT', /shading/],
    [{ material: LAMBERT, view: 1 }, 'E_OPTION', /view/],
    [{ material: 0, model: {} }, 'E_OPTION', /options\.model/],
  ])
    await assert.rejects(evaluateShading(options), (error) => error.code === code && message.test(error.message), JSON.stringify(Object.keys(options)));
  await assert.rejects(evaluateShading({ material: LAMBERT, albedo: true, signal: AbortSignal.abort() }), { name: 'AbortError' });
});
