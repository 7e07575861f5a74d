import { CASES } from './cases.mjs';
import { distance } from './distance.mjs';

/** Release that the page compares with: the one of package.json, which shading "three" is equal to. */
export const LAST = '0.187.0';

/**
 * Releases that follow each other and draw every case alike, bit for bit.
 * @typedef {object} Family
 * @property {string[]} releases - Oldest first.
 * @property {Record<string, import('./draw.mjs').Picture>} pictures - By name of the case.
 *
 * How far one family is from another on a case that differs.
 * @typedef {object} Differing
 * @property {string} name - Of the case.
 * @property {{mean: number, max: number, edge: number} | null} distance - Null where one of them has no such picture.
 */

const alike = (a, b) => CASES.every(({ name }) => (a[name].absent ? Boolean(b[name].absent) : a[name].image === b[name].image));

/**
 * @param {Map<string, Record<string, import('./draw.mjs').Picture>>} pictures - By release, oldest first.
 * @returns {Family[]} Oldest first.
 */
export function familiesOf(pictures) {
  const families = [];
  for (const [release, drawn] of pictures) {
    const last = families.at(-1);
    if (last && alike(last.pictures, drawn)) last.releases.push(release);
    else families.push({ releases: [release], pictures: drawn });
  }
  return families;
}

/** "0.165.0 to 0.180.0" */
export const rangeOf = ({ releases }) => (releases.length > 1 ? `${releases[0]} to ${releases.at(-1)}` : releases[0]);

/**
 * The cases that two families draw differently.
 * @param {Family} from
 * @param {Family} to
 * @returns {Differing[]}
 */
export function differences(from, to) {
  return CASES.filter(({ name }) => from.pictures[name].image !== to.pictures[name].image).map((item) => ({
    name: item.name,
    distance: distance(item, from.pictures[item.name], to.pictures[item.name]),
  }));
}
