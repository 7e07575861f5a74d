import { createHash } from 'node:crypto';
import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

// made.json beside the assets says which scripts made which bytes. A test compares it with both: making all takes over a minute.

const MAKE = fileURLToPath(new URL('.', import.meta.url));
export const MADE_FILE = 'made.json';
/** Draw pictures for the docs and make no asset. */
const OTHERS = ['pictures.mjs', 'cloths_picture.mjs', 'cloth_scenes.mjs', 'cloth_pages.mjs', 'blind.mjs', 'ltc.mjs', 'made.mjs'];
/** Packages whose versions may change the bytes. */
const PACKAGES = ['@gltf-transform/core', '@gltf-transform/extensions', 'delaunator', 'meshoptimizer', 'sharp'];

const sha256 = (...parts) => parts.reduce((hash, part) => hash.update(part), createHash('sha256')).digest('hex');

/** @param {string} [folder] - Of the scripts. @returns {Promise<string>} SHA-256 of the scripts' text and of the versions of what they call */
export async function sourcesHash(folder = MAKE) {
  const scripts = (await readdir(folder, { recursive: true })).filter((file) => file.endsWith('.mjs') && !OTHERS.includes(file)).sort();
  const texts = await Promise.all(scripts.map(async (file) => `${file}\0${await readFile(path.join(folder, file), 'utf8')}\0`));
  const { packages } = JSON.parse(await readFile(new URL('../../../package-lock.json', import.meta.url), 'utf8'));
  return sha256(...texts, ...PACKAGES.map((name) => `${name}@${packages[`node_modules/${name}`].version}\0`));
}

/** @param {string} folder - Of assets. @param {string[]} names @returns {Promise<Record<string, string>>} SHA-256 of each file */
export async function assetHashes(folder, names) {
  return Object.fromEntries(await Promise.all(names.map(async (name) => [name, sha256(await readFile(path.join(folder, name)))])));
}
