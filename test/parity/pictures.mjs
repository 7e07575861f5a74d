import { mkdirSync } from 'node:fs';
import path from 'node:path';
import sharp from 'sharp';
import { OUT } from './places.mjs';

/** Factor on differences in the difference picture: 1/255 becomes visible, 16/255 is full scale. */
export const GAIN = 16;

/** Of the PNGs; higher levels cost more time than their bytes are worth here. */
const COMPRESSION = 2;

/** Folder of the report's pictures. */
const FOLDER = path.join(OUT, 'pictures');

/**
 * Writes NAME.browser.png, NAME.telar.png, NAME.difference.png, and NAME.other.png where there is a second picture.
 * @param {string} name
 * @param {import('./metrics.mjs').Pictures} pictures
 * @param {Uint8Array} [second] - The browser's on another rasteriser.
 */
export async function writePictures(name, { expected, actual, width, height }, second) {
  mkdirSync(FOLDER, { recursive: true });
  const save = (pixels, kind) =>
    sharp(pixels, { raw: { width, height, channels: 4 } })
      .png({ compressionLevel: COMPRESSION })
      .toFile(path.join(FOLDER, `${name}.${kind}.png`));
  await save(straight(expected), 'browser');
  await save(straight(actual), 'telar');
  await save(amplified(expected, actual), 'difference');
  if (second) await save(straight(second), 'other');
}

function straight(premultiplied) {
  const result = new Uint8Array(premultiplied);
  for (let i = 0; i < result.length; i += 4) {
    const alpha = result[i + 3];
    if (alpha > 0 && alpha < 255) for (let c = 0; c < 3; c++) result[i + c] = Math.min(255, Math.round((result[i + c] * 255) / alpha));
  }
  return result;
}

/** Differences times GAIN, one of alpha as grey. */
function amplified(a, b) {
  const result = new Uint8Array(a.length);
  for (let i = 0; i < a.length; i += 4) {
    const alpha = Math.abs(a[i + 3] - b[i + 3]);
    for (let c = 0; c < 3; c++) result[i + c] = Math.min(255, Math.max(alpha, Math.abs(a[i + c] - b[i + c])) * GAIN);
    result[i + 3] = 255;
  }
  return result;
}
