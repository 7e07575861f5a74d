import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { inflateRawSync } from 'node:zlib';
import { createRenderer } from '../../js/index.mjs';
import { resolveThree } from '../../js/shot/three_terms.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { withMap } from '../parity/tool.mjs';
import { shot } from '../parity/shot.mjs';
import { ReleaseBrowser } from './draw.mjs';
import { fetchRelease, versionOf } from './releases.mjs';

// The atlas that a release prefilters an environment to, and telar's of the same release, texel by texel.

/**
 * An atlas as RGB halfs.
 * @typedef {{width: number, height: number, rgb: Float32Array}} Atlas
 */

const ball = MODELS.ball;

const HEAD_BYTES = 144;

/** @param {Buffer} file - As renderer/ibl/half_file.h packs it. @returns {Atlas} */
function unpacked(file) {
  if (file.toString('latin1', 0, 4) !== 'TPMA') throw new Error('this is no atlas');
  const face = file.readUInt32LE(8);
  const [width, height] = [3 * Math.max(face, 112), 4 * face];
  const planes = inflateRawSync(file.subarray(HEAD_BYTES));
  const count = width * height * 3;
  const rgb = new Float32Array(count);
  const last = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    last[i % 3] = (last[i % 3] + (planes[i] << 8) + planes[count + i]) & 0xffff;
    rgb[i] = halfOf(last[i % 3]);
  }
  return { width, height, rgb };
}

function halfOf(bits) {
  const [exponent, mantissa] = [(bits >> 10) & 31, bits & 1023];
  const size = exponent === 31 ? (mantissa ? Number.NaN : Infinity) : exponent ? (1 + mantissa / 1024) * 2 ** (exponent - 15) : mantissa * 2 ** -24;
  return bits & 0x8000 ? -size : size;
}

/** Any shot that an environment lights. */
const LIT = { ...shot(), size: { width: 8, height: 8 }, toneMapping: 'reinhard' };

/**
 * @param {Uint8Array | 'studio'} environment - .hdr bytes.
 * @param {number} revision
 * @param {object} [swaps] - Slots in place of the release's own.
 * @returns {Promise<Atlas>} Telar's, as it keeps it on disk.
 */
export async function atlasOfTelar(environment, revision, swaps = {}) {
  const cacheDirectory = mkdtempSync(path.join(os.tmpdir(), 'telar-atlas-'));
  const renderer = await createRenderer({ cacheDirectory });
  try {
    const shading = resolveThree({ base: 'three', revision, ...swaps });
    await renderer.render(await ball(), withMap({ ...LIT, shading }, environment));
    const [file, ...more] = readdirSync(cacheDirectory);
    if (!file || more.length > 0) throw new Error(`expected one file in the cache, there are ${file ? more.length + 1 : 0}`);
    return unpacked(readFileSync(path.join(cacheDirectory, file)));
  } finally {
    await renderer.close();
    rmSync(cacheDirectory, { recursive: true });
  }
}

/**
 * A release in Chromium.
 * @param {number} revision
 * @param {import('../parity/browser/chromium.mjs').Browser} [beside] - Whose Chromium it shares.
 * @returns {Promise<{browser: import('../parity/browser/chromium.mjs').Browser, atlas: (environment: Uint8Array) => Promise<Atlas>}>}
 */
export async function openRelease(revision, beside) {
  const name = versionOf(revision);
  const browser = await new ReleaseBrowser({ name, folder: await fetchRelease(name), stamp: '', log: console.error }).start(beside);
  return {
    browser,
    async atlas(environment) {
      const [{ size, height, values }] = await browser.prefilter({ shot: LIT, environment });
      return { width: size, height, rgb: values.filter((_, i) => i % 4 !== 3) };
    },
  };
}

/** Levels of an atlas with the rectangle of each, the sharpest first. */
export function levelsOf({ height }) {
  const face = height / 4;
  const sharp = Math.log2(face) - 3;
  return Array.from({ length: sharp + 6 }, (_, level) => {
    const edge = Math.max(face >> level, 16);
    return { level, x: 3 * edge * Math.max(level - sharp + 1, 0), y: 4 * (face - edge), width: 3 * edge, height: 2 * edge };
  });
}

/** Radiance as a picture shows it, by Reinhard's curve and a gamma of 2, in 1/255. */
const asShown = (radiance) => 255 * Math.sqrt(radiance / (1 + radiance));

/**
 * How far two atlases are apart, by level.
 * @param {Atlas} a
 * @param {Atlas} b
 * @returns {{level: number, equal: number, relative: number, shown: number}[]} Share of channels that are equal, largest relative
 *   difference, and the largest as a picture shows it, in 1/255.
 */
export function distances(a, b) {
  if (a.width !== b.width || a.height !== b.height) throw new Error(`${a.width} x ${a.height} against ${b.width} x ${b.height}`);
  return levelsOf(a).map(({ level, x, y, width, height }) => {
    const worst = { level, equal: 0, relative: 0, shown: 0 };
    for (let row = y; row < y + height; row++) {
      for (let i = (row * a.width + x) * 3; i < (row * a.width + x + width) * 3; i++) {
        const [p, q] = [a.rgb[i], b.rgb[i]];
        if (p === q) worst.equal++;
        else {
          worst.relative = Math.max(worst.relative, Math.abs(p - q) / Math.max(Math.abs(p), Math.abs(q)));
          worst.shown = Math.max(worst.shown, Math.abs(asShown(p) - asShown(q)));
        }
      }
    }
    worst.equal /= width * height * 3;
    return worst;
  });
}
