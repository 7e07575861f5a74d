// node test/fits/dfg_table.mjs [FILE]: writes renderer/brdf/dfg_table_32.inc, the split sum as three.js 0.181 tabulated it: 32 x 32
// half floats. With FILE, the source of that table in a release of three.js, it says how far the two are apart.
//
// The integral is exact in the limit of many samples; 4096 of them lose up to 5 % of the albedo at grazing, where a rare normal
// carries much of it, and what the release drew has that loss too. So the sum is over 4096 normals as well, on a lattice whose
// loss is alike.
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const SIZE = 32;
const SAMPLES = 4096;
const GOLDEN = (Math.sqrt(5) - 1) / 2;
const FILE = fileURLToPath(new URL('../../renderer/brdf/dfg_table_32.inc', import.meta.url));

/**
 * (A, B): the albedo of a GGX lobe with correlated Smith masking is f0 A + f90 B, by Schlick's fifth power.
 * src: Karis 2013, "Real Shading in Unreal Engine 4", normals drawn by D; Heitz 2014, eq. 99; golden ratio lattice: Korobov 1959
 * @param {number} roughness perceptual, (0, 1]
 * @param {number} NoV (0, 1]
 * @param {number} [samples] of the normals
 * @returns {[number, number]}
 */
export function splitSum(roughness, NoV, samples = SAMPLES) {
  const a2 = roughness ** 4;
  const sine = Math.sqrt(1 - NoV * NoV);
  const smith = (cosine) => Math.sqrt(a2 + (1 - a2) * cosine * cosine);
  let scale = 0;
  let bias = 0;
  for (let i = 0; i < samples; i += 1) {
    const u = (i + 1) / samples;
    const NoH = Math.sqrt((1 - u) / (1 - (1 - a2) * u));
    const VoH = Math.sqrt(1 - NoH * NoH) * sine * Math.cos(2 * Math.PI * ((i * GOLDEN) % 1)) + NoH * NoV;
    const NoL = 2 * VoH * NoH - NoV;
    if (!(NoL > 0)) continue;
    // V N.L over the density of l, D N.H / (4 V.H).
    const weight = (2 * NoL * VoH) / (NoH * (NoL * smith(NoV) + NoV * smith(NoL)));
    const grazing = (1 - VoH) ** 5;
    scale += weight * (1 - grazing);
    bias += weight * grazing;
  }
  return [scale / samples, bias / samples];
}

/** Bits of the nearest half float of a number in [0, 2). */
export function halfBits(x) {
  const exponent = Math.max(-14, Math.floor(Math.log2(Math.max(x, 2 ** -24))));
  const steps = Math.round(x / 2 ** (exponent - 10));
  return steps + (exponent > -14 ? (exponent + 14) * 1024 : 0);
}

/** The number that bits of a half float stand for. */
export const halfValue = (bits) => {
  const [exponent, steps] = [bits >> 10, bits & 1023];
  return exponent === 0 ? steps * 2 ** -24 : (1024 + steps) * 2 ** (exponent - 25);
};

/** Bits of the table, (A, B) a texel; x (fastest) = roughness, y = NoV, at the centres of texels. */
export const tableBits = (size = SIZE) =>
  Array.from({ length: size * size }, (_, i) => splitSum(((i % size) + 0.5) / size, (Math.floor(i / size) + 0.5) / size))
    .flat()
    .map(halfBits);

const HEADER = `// Written by test/fits/dfg_table.mjs: the split sum as three.js 0.181 tabulated it, ${SIZE} x ${SIZE}, ${SAMPLES} samples a texel.
// fp16 pairs (A, B): x (fastest) = perceptualRoughness, y = NoV, texel centres at (i + 0.5) / ${SIZE}.\n`;

export function tableText(bits) {
  const words = bits.map((word) => `0x${word.toString(16).padStart(4, '0')},`);
  const lines = Array.from({ length: words.length / 16 }, (_, i) => `    ${words.slice(16 * i, 16 * (i + 1)).join(' ')}\n`);
  return HEADER + lines.join('');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const bits = tableBits();
  const [source] = process.argv.slice(2);
  if (source) {
    const theirs = [...readFileSync(source, 'utf8').matchAll(/0x[0-9a-f]{4}/g)].map(([word]) => halfValue(Number(word)));
    const errors = bits.map((word, i) => Math.abs(halfValue(word) - theirs[i]));
    const mean = errors.reduce((sum, error) => sum + error, 0) / errors.length;
    console.log(`at most ${Math.max(...errors).toFixed(5)} apart, ${mean.toFixed(6)} on the mean, of ${theirs.length} numbers`);
  } else writeFileSync(FILE, tableText(bits));
}
