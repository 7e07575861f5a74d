import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { TelarError } from '../error/index.mjs';
import { nearest, shown } from '../shot/complain.mjs';

/**
 * What is looked at: a fabric of the bundled drape, or a model of the user's.
 * @typedef {object} Target
 * @property {string} name
 * @property {string | Uint8Array} source - Path or bytes.
 * @property {object} shot - Keys of the shot that show it.
 */

/** Material variants of the bundled drape (js/assets/make/fabrics). */
export const FABRICS = ['leather', 'wool', 'towel', 'velvet'];

const DRAPE = fileURLToPath(new URL('../assets/fabrics.glb', import.meta.url));
/** Shows the top of the drape, its folds and its hem. */
const DRAPE_CAMERA = { azimuth: 25, elevation: 22 };

/**
 * @param {string[]} names of FABRICS
 * @returns {Target[]}
 * @throws {TelarError} E_USAGE
 */
export function fabricTargets(names) {
  const unknown = names.find((name) => !FABRICS.includes(name));
  if (unknown !== undefined) {
    const near = nearest(unknown, FABRICS);
    throw new TelarError('E_USAGE', `--fabrics: expected some of ${FABRICS.join(', ')}, got ${shown(unknown)}${near ? `; did you mean ${near}?` : ''}`);
  }
  return names.map((name) => ({ name, source: DRAPE, shot: { camera: DRAPE_CAMERA, variant: name } }));
}

/** Names as they are, those that occur more than once with a number that makes no other name: their place in the list, or a later one. @param {string[]} names */
export function numbered(names) {
  const taken = new Set(names);
  return names.map((name, i) => {
    if (names.filter((each) => each === name).length === 1) return name;
    let number = i + 1;
    while (taken.has(`${name} ${number}`)) ++number;
    taken.add(`${name} ${number}`);
    return `${name} ${number}`;
  });
}

/** Models or lights, those with one name told apart by number. */
export function toldApart(list) {
  const names = numbered(list.map(({ name }) => name));
  return list.map((each, i) => ({ ...each, name: names[i] }));
}

/**
 * @param {string[]} files
 * @returns {Target[]} named after their files, told apart by number where two have one name
 */
export function modelTargets(files) {
  return toldApart(files.map((source) => ({ name: path.basename(source).replace(/\.(glb|gltf)$/i, ''), source, shot: {} })));
}
