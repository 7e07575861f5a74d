import { createHash } from 'node:crypto';
import { encodePng, readImage } from '../compare/index.mjs';
import { TelarError } from '../error/index.mjs';
import { pathText, pointerText, shown } from '../shot/complain.mjs';
import { ABOUT } from './read.mjs';

/** Images that a spec names: decoded by the checked decoders of textures, and handed to the layout engine as PNG of ours. */

/** Pixels of one: 300 ppi over an A3 page are 17 million. */
const PIXELS_MAX = 20_000_000;

/** The images that a spec names, with where. */
function namesIn(spec) {
  const lists = ['bill', 'labels', 'artwork'].flatMap((list) => spec[list].map(({ image }, i) => ({ name: image, path: [list, i, 'image'] })));
  return [{ name: spec.header.logo, path: ['header', 'logo'] }, ...lists].filter(({ name }) => name !== undefined);
}

/**
 * @param {object} spec of readSpec
 * @param {{resolve?: (name: string) => unknown, limits?: object, signal?: AbortSignal}} options resolve gives the bytes of a name, or null
 * @returns {Promise<Map<string, {file: string, data: Buffer, width: number, height: number}>>} by name
 * @throws {TelarError} E_SPEC for what is not there, E_IMAGE_*, L_IMAGE_*
 */
export async function readImages(spec, { resolve, limits, signal }) {
  const images = new Map();
  for (const { name, path } of namesIn(spec)) {
    if (images.has(name)) continue;
    const pointer = pointerText(path);
    const bytes = await resolve?.(name);
    if (!bytes)
      throw new TelarError(ABOUT.code, `${pathText(path, ABOUT)}: there is no image ${shown(name)}${resolve ? '' : '; give the option resolve'}`, { pointer });
    try {
      const image = await readImage(bytes, { limits: { L_IMAGE_PIXELS: PIXELS_MAX, ...limits }, signal });
      const data = await encodePng(image, { signal });
      images.set(name, { file: `${createHash('sha256').update(data).digest('hex').slice(0, 16)}.png`, data, width: image.width, height: image.height });
    } catch (cause) {
      if (!(cause instanceof TelarError)) throw cause;
      throw new TelarError(cause.code, `${pathText(path, ABOUT)}: ${cause.message}`, { ...cause.toJSON(), pointer, cause });
    }
  }
  return images;
}
