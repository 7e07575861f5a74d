import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { etc1sKtx2 } from '../fixtures/etc1s.mjs';
import { blockKtx2 } from '../fixtures/gpu_blocks.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { rawKtx2 } from '../fixtures/ktx2.mjs';
import { rawFormatKtx2 } from '../fixtures/raw_formats.mjs';
import { meshoptTorus } from '../fixtures/scenes_decoders.mjs';
import { uastcKtx2 } from '../fixtures/uastc.mjs';
import { picture } from '../robust/decoder_cases.mjs';
import { makeCases } from '../robust/make_cases.mjs';

// What a fuzzer starts from: small files of each kind, good ones and the hostile ones of test/robust.

const MOST_BYTES = 65_536;
const EXR_SEEDS = fileURLToPath(new URL('../../out/fuzz/bin/exr_seeds', import.meta.url));
const SHOTS = new URL('../cpp/shot/resolved_shots.json', import.meta.url);

const side = { width: 24, height: 16 };

async function images() {
  const noise = Buffer.from(Array.from({ length: 24 * 16 * 4 }, (_, i) => (Math.imul(i, 2654435761) >>> 24) & 255));
  const base = () => sharp(noise, { raw: { ...side, channels: 4 } });
  return Promise.all([
    base().png().toBuffer(),
    base().png({ palette: true }).toBuffer(),
    base().png({ progressive: true }).toBuffer(),
    base().jpeg().toBuffer(),
    base().jpeg({ progressive: true, chromaSubsampling: '4:4:4' }).toBuffer(),
    base().greyscale().jpeg().toBuffer(),
    base().webp().toBuffer(),
    base().webp({ lossless: true }).toBuffer(),
  ]);
}

const ktx2 = () =>
  Promise.all([
    uastcKtx2(picture()),
    etc1sKtx2(picture(64, 64), { alpha: true }),
    rawKtx2(picture()),
    rawFormatKtx2('rgba16f', picture(), { zstd: true }),
    blockKtx2('bc7-srgb', picture()),
  ]);

async function models() {
  const made = await Promise.all(Object.values(MODELS).map((make) => make()));
  return [...makeCases().map(({ bytes }) => bytes), meshoptTorus(), ...made];
}

const shots = async () => Object.values(JSON.parse(readFileSync(SHOTS, 'utf8'))).map((shot) => Buffer.from(JSON.stringify(shot)));

const made = (names) => Promise.all(names.map((name) => MODELS[name]()));
const draco = () => made(Object.keys(MODELS).filter((name) => name.startsWith('draco')));
const meshopt = async () => [meshoptTorus(), meshoptTorus({ extension: 'KHR_meshopt_compression' })];

/** The same texels in flat rows and in runs. */
function environments() {
  const { width, height } = side;
  const head = Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`);
  const flat = Buffer.from(Array.from({ length: width * height * 4 }, (_, i) => (i % 4 === 3 ? 128 : 40 + (i % 200))));
  const row = Buffer.from([2, 2, 0, width, ...[200, 100, 50, 129].flatMap((value) => [128 + 20, value, 4, 1, 2, 3, 4])]);
  return [Buffer.concat([head, flat]), Buffer.concat([head, ...Array(height).fill(row)])];
}

/** By a program that the fuzzers' build makes: every compression of OpenEXR. */
async function exrs() {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-exr-'));
  try {
    execFileSync(EXR_SEEDS, [folder]);
    return readdirSync(folder).map((name) => readFileSync(path.join(folder, name)));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Seeds by target. @type {Record<string, () => Promise<Uint8Array[]>>} */
export const SEEDS = Object.fromEntries(
  Object.entries({ model: models, draco, meshopt, image: images, ktx2, environment: environments, exr: exrs, shot: shots }).map(([name, make]) => [
    name,
    async () => (await make()).filter(({ length }) => length <= MOST_BYTES),
  ]),
);
