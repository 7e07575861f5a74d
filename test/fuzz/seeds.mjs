import { readFileSync } from 'node:fs';
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
const SHOTS = new URL('../cpp/shot/resolved_shots.json', import.meta.url);

async function images() {
  const side = { width: 24, height: 16 };
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
    uastcKtx2(picture()),
    etc1sKtx2(picture(64, 64), { alpha: true }),
    rawKtx2(picture()),
    rawFormatKtx2('rgba16f', picture(), { zstd: true }),
    blockKtx2('bc7-srgb', picture()),
  ]);
}

async function models() {
  const made = await Promise.all(Object.values(MODELS).map((make) => make()));
  return [...makeCases().map(({ bytes }) => bytes), meshoptTorus(), ...made];
}

const shots = async () => Object.values(JSON.parse(readFileSync(SHOTS, 'utf8'))).map((shot) => Buffer.from(JSON.stringify(shot)));

/** Seeds by target. @type {Record<string, () => Promise<Uint8Array[]>>} */
export const SEEDS = Object.fromEntries(
  Object.entries({ model: models, image: images, shot: shots }).map(([name, make]) => [
    name,
    async () => (await make()).filter(({ length }) => length <= MOST_BYTES),
  ]),
);
