// Woven cloth under a sky of radiance 1: drawn in qualities standard and high, path traced, and by evaluateShading. White cloth gives back
// all the light, a metal what its yarns cover.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { readFileSync } from 'node:fs';
import { createRenderer, evaluateShading } from '../../../js/index.mjs';
import { constantOne } from '../../fixtures/environment.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { png } from '../../fixtures/images.mjs';
import './support/real.mjs';

const MOST = 1.005; // of every shading that keeps its energy
const LEAST = 0.9; // of what the yarns cover
const AGREE = 0.02;
const SIZE = { width: 16, height: 16 };
const QUALITIES = { standard: 'standard', high: { samples: 16, environmentSamples: 256 }, reference: { preset: 'reference', samples: 64, seed: 7 } };
const PRESETS = JSON.parse(readFileSync(new URL('../../../js/assets/fabric_presets.json', import.meta.url)));

let renderer;
let sky;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  sky = constantOne();
});
after(() => renderer.close());

/** Numbers in [0, 1), the same on every machine. src: Steele & Vigna 2021, "Computationally easy, spectrally good multipliers", 32 bits */
function numbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 0xadb4a92d) + 1) >>> 0;
    return state / 2 ** 32;
  };
}

function randomWeave(unit) {
  const covered = unit() < 0.5 ? 1 : 1 - 0.5 * unit();
  const share = unit();
  const yarns = (coverage) => ({ coverage, roughnessFactor: unit(), anisotropyStrength: unit() });
  return { weave: { warp: yarns(covered * share), weft: yarns(covered * (1 - share)) }, metallic: Math.round(unit()), viewAngle: 1.4 * unit() };
}

const coverageOf = ({ weave: { warp, weft }, metallic }) => 1 - metallic * (1 - warp.coverage - weft.coverage);

/** A sheet that faces +z. @param {number[]} [texel] - RGBA of a weave map, [0, 1]: yarns that are turned and lean */
async function sheetOf({ weave, metallic }, texel) {
  const glb = new GlbBuilder();
  const textures = texel ? { weave: { image: await png(4, 4, () => texel) } } : {};
  glb.add(plane(1, 1), glb.material({ baseColor: [1, 1, 1, 1], metallic, layers: { fabric: { definition: { weave }, textures } } }), { name: 'sheet' });
  return glb.bytes();
}

/** Mean radiance of a picture that the sheet fills, seen from `viewAngle` to its right. */
async function drawn(glb, quality, viewAngle) {
  const { data } = await renderer.render(glb, {
    size: SIZE,
    shading: 'fabric',
    quality,
    toneMapping: 'none',
    environment: { map: sky, intensity: 1 },
    output: { format: 'raw', bitDepth: 32 },
    camera: { azimuth: (viewAngle * 180) / Math.PI, elevation: 0, projection: 'orthographic', fit: 0.99 },
  });
  const floats = new Float32Array(data.buffer, data.byteOffset, data.length / 4);
  let [sum, count] = [0, 0];
  for (let i = 0; i < floats.length; i += 4) {
    if (floats[i + 3] < 0.999) continue;
    sum += floats[i];
    count += 1;
  }
  assert.ok(count > 10, `${count} pixels of cloth`);
  return sum / count;
}

async function drawnInAll(glb, viewAngle) {
  const light = {};
  for (const [name, quality] of Object.entries(QUALITIES)) light[name] = await drawn(glb, quality, viewAngle);
  return light;
}

function check(light, covered, text) {
  const told = `${text}: ${JSON.stringify(light)}`;
  for (const value of Object.values(light)) assert.ok(value <= MOST && value >= LEAST * covered, told);
  assert.ok(Math.max(...Object.values(light)) - Math.min(...Object.values(light)) <= AGREE, told);
}

test('8 weaves at random reflect the same light drawn, traced and integrated, and never more than there is', async () => {
  const unit = numbers(1);
  for (let i = 0; i < 8; i += 1) {
    const cloth = randomWeave(unit);
    const material = { pbrMetallicRoughness: { metallicFactor: cloth.metallic }, extensions: { TELAR_materials_fabric: { weave: cloth.weave } } };
    const { albedo } = await evaluateShading({ material, shading: 'fabric', viewAngle: cloth.viewAngle, albedo: true });
    const light = { ...(await drawnInAll(await sheetOf(cloth), cloth.viewAngle)), albedo: albedo.total[0] };
    check(light, coverageOf(cloth), JSON.stringify(cloth));
  }
});

test('yarns that are turned and lean reflect the same light drawn and traced', async () => {
  const unit = numbers(2);
  for (let i = 0; i < 4; i += 1) {
    const cloth = randomWeave(unit);
    const turn = Math.PI * (unit() - 0.5);
    const texel = [0.5 + Math.cos(turn) / 2, 0.5 + Math.sin(turn) / 2, 0.05 + 0.9 * unit(), i % 2];
    check(await drawnInAll(await sheetOf(cloth, texel), cloth.viewAngle), coverageOf(cloth), JSON.stringify({ cloth, texel }));
  }
});

test('no preset in white, seen flat, makes light or loses more than a tenth of it', async () => {
  const viewAngle = 1.4; // seen flat, where fuzz and gloss add most
  for (const name of Object.keys(PRESETS)) {
    const through = PRESETS[name].material.extensions?.KHR_materials_diffuse_transmission?.diffuseTransmissionFactor ?? 0;
    const material = { pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 1] }, extensions: { TELAR_materials_fabric: { preset: name } } };
    const { albedo, albedoError } = await evaluateShading({ material, shading: 'fabric', viewAngle, albedo: true });
    const { total, diffuse } = albedo;
    // What goes through the cloth is not reflected: it is this share of all that enters it.
    const light = total[0] + (diffuse[0] * through) / (1 - through);
    assert.ok(light <= MOST + albedoError.total[0] && light >= LEAST, `${name}: ${light}`);
  }
});
