import { createRequire } from 'node:module';
import { TelarError } from '../error/index.mjs';

/** AVIF, by the package sharp where the user has installed it. It encodes on threads of its own, and decodes nothing here. */

const PACKAGE = 'sharp';
export const AVIF_TYPE = 'image/avif';

/** Whether there is one to load. */
export function hasSharp() {
  try {
    createRequire(import.meta.url).resolve(PACKAGE);
    return true;
  } catch {
    return false;
  }
}

async function load() {
  try {
    return (await import(PACKAGE)).default;
  } catch (cause) {
    throw new TelarError('X_LIBRARY_MISSING', `AVIF is encoded by ${PACKAGE}, which is not installed or does not load: npm install ${PACKAGE}`, { cause });
  }
}

/**
 * @param {{data: Uint8Array, width: number, height: number}} pixels RGBA, 8 bits, sRGB, straight alpha
 * @param {{quality?: number}} [how] quality 1 to 100; sharp's own default otherwise
 * @returns {Promise<Buffer>}
 * @throws {TelarError} X_LIBRARY_MISSING, X_OUTPUT
 */
export async function encodeAvif({ data, width, height }, { quality } = {}) {
  const sharp = await load();
  try {
    const image = sharp(data, { raw: { width, height, channels: 4 } });
    return await image.avif({ ...(quality !== undefined && { quality }) }).toBuffer();
  } catch (cause) {
    throw new TelarError('X_OUTPUT', `the picture cannot be encoded as AVIF (${cause.message.split('\n')[0]})`, { cause });
  }
}
