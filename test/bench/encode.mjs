/**
 * CPU time and size of telar's encoders against sharp and against OpenImageIO at its defaults; medians.
 *
 *   node test/bench/encode.mjs [IMAGE]             IMAGE: a drawn garment to encode instead of the synthetic one
 *   node test/bench/encode.mjs --efforts [IMAGE]   telar's alone, at every output.effort: the table of js/docs/figures.md
 *
 * What the default effort of renderer/image was chosen by (2 shared cores of an EPYC server, one thread, drawn cloth spheres
 * at 256 x 256, milliseconds and kilobytes; L = libdeflate's level):
 *
 *   PNG filter    L1         L3         L6          chosen: the cheaper of Sub and Up for each row, L1. Paeth and all
 *   none          1.3  90.6  1.3  90.7  1.4  91.1   five filters save 0 to 4 % more and take 1.3 to 2 times as long;
 *   Sub           1.2  69.1  1.5  71.3  1.8  70.2   higher levels save less than 2 %.
 *   Sub or Up     1.6  66.8  1.9  68.8  2.2  67.1
 *   Paeth         1.6  64.7  2.1  66.0  2.8  64.5
 *   all five      2.7  64.3  3.2  65.5  5.3  64.1
 *
 *   WebP lossless, 512 x 512: level 0 7 ms 203 KB, level 1 21 ms 123 KB (chosen), level 2 34 ms 117 KB, level 6 71 ms
 *   105 KB
 *   WebP quality 90, 512 x 512: method 0 7 ms 23 KB, method 2 9 ms 17 KB (chosen), method 4 19 ms 17 KB
 */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import sharp from 'sharp';
import { imageTool } from '../js/image/image_tool.mjs';

sharp.concurrency(1);
sharp.cache(false);

/** A shape in the middle of a transparent square, with folds, a weave and grain: to deflate it looks like a thumbnail. */
function syntheticGarment(size) {
  const pixels = Buffer.alloc(size * size * 4);
  let state = 1;
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const [u, v] = [((x + 0.5) / size) * 2 - 1, ((y + 0.5) / size) * 2 - 1];
      const body = Math.max(Math.abs(u) / (v < -0.2 && v > -0.7 ? 0.8 : 0.45), Math.abs(v) / 0.8);
      const alpha = Math.min(1, Math.max(0, ((1 - body) * size) / 4));
      if (!alpha) continue;
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      const fold = 0.6 + 0.25 * Math.sin(u * 9 + 2 * Math.sin(v * 4)) + 0.1 * Math.sin(v * 17 + u * 3);
      const weave = 0.06 * Math.sin(x * 2.1) * Math.sin(y * 2.3) + 0.03 * (state / 2 ** 32 - 0.5);
      const shade = Math.min(1, Math.max(0, fold + weave));
      pixels.set([200 * shade, 60 * shade + 20, 70 * shade + 10, 255 * alpha], (y * size + x) * 4);
    }
  }
  return pixels;
}

const words = process.argv.slice(2);
const isEfforts = words[0] === '--efforts';
const image = words[isEfforts ? 1 : 0];

async function frameOf(size) {
  if (!image) return syntheticGarment(size);
  return sharp(image).resize(size, size, { fit: 'fill' }).ensureAlpha().raw().toBuffer();
}

async function sharpMedian(pixels, size, method, options, repeat) {
  const times = [];
  let bytes = 0;
  const raw = { width: size, height: size, channels: 4 };
  for (let i = 0; i < repeat; i++) {
    const start = process.cpuUsage();
    bytes = (await sharp(pixels, { raw })[method](options).toBuffer()).length;
    const { user, system } = process.cpuUsage(start);
    times.push((user + system) / 1000);
  }
  return { ms: times.sort((a, b) => a - b)[repeat >> 1], bytes };
}

function run(program, args) {
  const [ms, bytes] = execFileSync(program, args, { encoding: 'utf8' }).trim().split(' ').map(Number);
  return { ms, bytes };
}

const CASES = [
  ['png', [], { method: 'png', options: {} }, 'png'],
  ['jpeg', ['quality=90'], { method: 'jpeg', options: { quality: 90, chromaSubsampling: '4:4:4' } }],
  ['webp', ['quality=90'], { method: 'webp', options: { quality: 90 } }],
  ['webp', ['quality=100'], { method: 'webp', options: { lossless: true } }],
  ['png', ['icc=1'], null, 'png'],
  ['tiff', [], { method: 'tiff', options: { compression: 'deflate', predictor: 'horizontal' } }],
];

/** What effort changes; EXR takes floats. */
const EFFORT_CASES = [
  ['png', []],
  ['png', ['icc=1']],
  ['jpeg', ['quality=90']],
  ['webp', ['quality=90']],
  ['webp', ['quality=100']],
  ['tiff', []],
  ['exr', ['bits=16']],
];
const EFFORTS = [...Array(10).keys()];

const folder = mkdtempSync(join(tmpdir(), 'telar-encode-'));
const tool = imageTool();
const oiio = join(dirname(tool), 'encode_oiio');
const cell = (result) => (result ? `${result.ms.toFixed(1)} ms  ${(result.bytes / 1000).toFixed(0)} KB` : '').padStart(22);
const ratio = (ours, other) => (other ? `${(other.ms / ours.ms).toFixed(1)}x` : '').padStart(8);

/** Premultiplied radiance of bytes, as the renderer hands it to EXR. */
function radianceOf(pixels) {
  const out = new Float32Array(pixels.length);
  for (let i = 0; i < pixels.length; i++) out[i] = i % 4 === 3 ? pixels[i] / 255 : ((pixels[i] / 255) ** 2.2 * pixels[i - (i % 4) + 3]) / 255;
  return Buffer.from(out.buffer);
}

/** A line of Markdown a format: milliseconds and kilobytes of each effort, at 512 x 512. */
async function printEfforts() {
  const size = 512;
  const pixels = await frameOf(size);
  console.log(`| ms, KB | ${EFFORTS.join(' | ')} |\n|${' --- |'.repeat(EFFORTS.length + 1)}`);
  for (const [format, options] of EFFORT_CASES) {
    const frame = join(folder, 'frame');
    writeFileSync(frame, format === 'exr' ? radianceOf(pixels) : pixels);
    const cells = EFFORTS.map((effort) => {
      const { ms, bytes } = run(tool, [
        'encode',
        `frame=${frame}`,
        `width=${size}`,
        `height=${size}`,
        `format=${format}`,
        'repeat=9',
        `effort=${effort}`,
        ...options,
      ]);
      return `${ms.toFixed(1)}, ${(bytes / 1000).toFixed(0)}`;
    });
    console.log(`| ${[format, ...options].join(' ')} | ${cells.join(' | ')} |`);
  }
}

async function printPeers() {
  const heads = ['telar', 'sharp', 'OIIO default'].map((name) => name.padStart(22)).join('');
  console.log(`${''.padEnd(24)}${heads}${'sharp/'.padStart(8)}${'OIIO/'.padStart(8)}`);
  for (const size of [512, 2048]) {
    const pixels = await frameOf(size);
    const frame = join(folder, 'frame');
    writeFileSync(frame, pixels);
    const repeat = size === 512 ? 9 : 3;
    for (const [format, options, peer, oiioFormat] of CASES) {
      const ours = run(tool, ['encode', `frame=${frame}`, `width=${size}`, `height=${size}`, `format=${format}`, `repeat=${repeat}`, ...options]);
      const theirs = peer ? await sharpMedian(pixels, size, peer.method, peer.options, repeat) : undefined;
      const plain = oiioFormat && existsSync(oiio) ? run(oiio, [frame, size, size, oiioFormat, repeat].map(String)) : undefined;
      const name = `${size} ${format} ${options.join(' ')}`.padEnd(24);
      console.log(name + cell(ours) + cell(theirs) + cell(plain) + ratio(ours, theirs) + ratio(ours, plain));
    }
  }
}

try {
  await (isEfforts ? printEfforts() : printPeers());
} finally {
  rmSync(folder, { recursive: true, force: true });
}
