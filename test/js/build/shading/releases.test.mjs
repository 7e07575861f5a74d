import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { shaderFiles } from '../../../../js/build/material/glsl.mjs';
import { included, withoutComments } from '../../../../js/build/shading/preprocess.mjs';
import { THREE_SLOTS } from '../../../../js/shot/three_terms.mjs';
import { threeDefine } from '../../../../js/three/shading/terms.mjs';

// The surface program by release of three.js: what its preprocessor leaves.

const SHADERS = new URL('../../../../shaders/', import.meta.url);
const written = shaderFiles();
const text = withoutComments(included('#include "surface.frag"', (file) => written[file] ?? readFileSync(new URL(file, SHADERS), 'utf8'))).replace(
  /^#extension.*$/gm,
  '',
);

/** Everything on that a term may stand in. */
const FEATURES = [
  ...['SHADING_THREE', 'ENVIRONMENT', 'AMBIENT', 'DIRECTIONAL_LIGHTS', 'RECT_LIGHTS', 'OCCLUSION_MAP', 'TRANSMISSION'],
  ...['SPECULAR', 'CLEARCOAT', 'SHEEN', 'ANISOTROPY', 'IRIDESCENCE'],
];

/** Lines that are left of a text. A name that is not defined is 0. */
function compiled(source, terms = {}) {
  const defines = {
    ...Object.fromEntries(FEATURES.map((name) => [name, 1])),
    ...Object.fromEntries(Object.keys(THREE_SLOTS).map((slot) => [threeDefine(slot), 0])),
    ...terms,
  };
  const options = Object.entries(defines).map(([name, value]) => `-D${name}=${value}`);
  const out = execFileSync('cpp', ['-P', '-undef', '-w', '-x', 'c', ...options], { input: source, encoding: 'utf8', maxBuffer: 1 << 26 });
  return new Set(out.split('\n').map((line) => line.trim()));
}

/** slot: its position of a term, and what only that term computes. */
const OLDER = {
  reflectionDirection: [1, 'vec3 direction = dominantReflectionByAlpha(perceptualRoughness, n, v);'],
  dfg: [2, 'vec2 splitSum(float perceptualRoughness, float NoV) { return dfgKaris(perceptualRoughness, NoV); }'],
  environmentMetal: [1, 'whole = blendedScattering(s);'],
  directMultiscatter: [1, 'sum.specular += irradiance * addedLobe(s, NoL);'],
  sheenAlbedo: [1, 'return sheenAlbedoInRanges(s.sheenRoughness, cosine);'],
  sheenEnergy: [1, 'radiance = base * underSheenOfColor(s.sheenColor) + (direct.sheen + indirect.sheen);'],
  filmMetal: [1, 'dielectric = metal = F_Iridescence(m.iridescenceIor, m.iridescenceThickness, s.NoV, s.f0);'],
  filmEnvironment: [1, 's.filmF0Metal = metal;'],
  anisotropicVisibility: [2, 'visibility = saturate(visibility);'],
  anisotropyDirection: [1, 's.b = frame[1] * direction.x + frame[0] * direction.y;'],
  roughnessMin: [1, 'm.roughness = max(m.roughness, PERCEPTUAL_ROUGHNESS_MIN_R186);'],
  rectF90: [1, 'lobes.base.albedo = ltcAlbedoToWhite(s.f0, texture(ltcAlbedoMap, ltcCoordinates(s.perceptualRoughness, s.NoV)).rg);'],
  glassAlpha: [1, 'baseColor.a *= glassOpacityWithTenth(transmitted.a, transmission);'],
  neutralToneMapping: [1, 'return toneMapNeutralWhite(radiance, exposure);'],
};

/** What 0.187 computes and an older term leaves out. */
const NEWER = {
  rectCoat: [1, 'sum.coat += light.color * lobes.coat.albedo * formFactor(lobes.coat.toLobe, light, p);'],
  layerOcclusion: [1, 'indirect.coat *= occlusion;'],
};

test('a scene of 0.187 compiles no term of another release', () => {
  const today = compiled(text);
  for (const [slot, [, line]] of Object.entries(OLDER)) assert.ok(!today.has(line), slot);
  const names = [...readFileSync(new URL('brdf/three_releases.glsl', SHADERS), 'utf8').matchAll(/^\w+ (?:\w+ )?(\w+)[(= ]/gm)].map((match) => match[1]);
  assert.ok(names.length >= 8, 'the names of older terms are read');
  const all = [...today].join('\n');
  for (const name of names) assert.ok(!new RegExp(`\\b${name}\\b`).test(all), name);
});

test('each slot compiles its own term', () => {
  for (const [slot, [term, line]] of Object.entries(OLDER)) assert.ok(compiled(text, { [threeDefine(slot)]: term }).has(line), slot);
  for (const [slot, [term, line]] of Object.entries(NEWER)) {
    assert.ok(compiled(text).has(line), slot);
    assert.ok(!compiled(text, { [threeDefine(slot)]: term }).has(line), slot);
  }
});

test('a term that is left in is found', () => {
  const careless = text.replace('ALL_TERMS || THREE_SHEEN_ENERGY_TERM == THREE_SHEEN_ENERGY_CONSTANT)', 'ALL_TERMS || 1)');
  assert.notEqual(careless, text);
  assert.ok(compiled(careless).has(OLDER.sheenEnergy[1]));
});
