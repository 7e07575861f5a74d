import { nearestRevision, resolveThree, families, termsOfRevision, THREE_SLOTS } from '../../js/shot/three_terms.mjs';
import { TONE_MAPPINGS } from '../../js/shot/table/tone_mappings.mjs';
import { CASES } from './cases.mjs';
import { GATE_CASES } from './cases_gate.mjs';
import { pageStamp, ReleaseBrowser } from './draw.mjs';
import { fetchRelease, versionOf } from './releases.mjs';

// The gate of older releases: real ones in Chromium on one side, telar with shading {base: "three", revision} on the other.

/** Oldest release whose pictures telar must equal. */
export const FIRST_GATED = 155;

/** The newest release of each family but the last, oldest first: the gate itself draws that one. */
export const GATED_REVISIONS = families()
  .map(({ to }) => to)
  .filter((revision) => revision >= FIRST_GATED)
  .slice(0, -1);

/** What `npm test` draws: the environment, layers, direct light with highlights, shadows, and glass. */
export const FAST = ['env-lamps', 'everything', 'light-directional', 'shadow-spot', 'transmission-color'];

/** The first release that reads an index of refraction of 0 as a large one; before it, what such glass refracts is no number. */
const IOR_0_SINCE = 184;

/** What a release cannot show of a model, or telar as it. @type {Record<string, (revision: number) => boolean>} */
const UNSHOWN = {
  // Where no program compiles there is nothing to compare.
  'morph-colors': (revision) => termsOfRevision(revision).morphColors === 'no-program',
  // Mesa rounds what vertices move by to half floats there; telar moves them before it knows the release.
  morph: (revision) => termsOfRevision(revision).samplerPrecision === 'lowp',
  'ior-0': (revision) => revision < IOR_0_SINCE,
  // No number along silhouettes, which is drawn black.
  anisotropy: (revision) => termsOfRevision(revision).anisotropicVisibility === 'unbounded',
};

/**
 * @param {number} revision
 * @returns {(item: import('../parity/cases.mjs').Case) => boolean} Whether this release can draw a case, and telar as it.
 */
export const isShown =
  (revision) =>
  ({ name, traits = [name], shot, settings }) =>
    !traits.some((trait) => UNSHOWN[trait]?.(revision)) &&
    // telar has the default of three.js alone, PCFShadowMap.
    settings === undefined &&
    !(revision < TONE_MAPPINGS[shot.toneMapping]?.since);

/**
 * What both sides draw for a release.
 * @param {number} revision
 * @returns {import('../parity/cases.mjs').Case[]} Named REVISION-CASE; their shots name stock three.js alone.
 */
export const casesOf = (revision) => [...CASES, ...GATE_CASES].filter(isShown(revision)).map((item) => ({ ...item, name: `${revision}-${item.name}` }));

/**
 * Slots put in place of a release's own, as planted faults.
 * @param {string[]} texts - "slot=term".
 * @returns {Record<string, string>}
 */
export function parseSwaps(texts = []) {
  return Object.fromEntries(
    texts.map((text) => {
      const [slot, term] = text.split('=');
      const terms = Object.keys(THREE_SLOTS[slot] ?? {});
      if (!terms.includes(term))
        throw new Error(`--swap ${text}: expected ${terms.length ? `${slot}=${terms.join('|')}` : `one of ${Object.keys(THREE_SLOTS).join(' ')}`}`);
      return [slot, term];
    }),
  );
}

/** Fetches releases one after the other, while others are drawn. */
export async function fetchAhead(revisions) {
  // One that fails is told by the round that wants it.
  for (const revision of revisions) await fetchRelease(versionOf(nearestRevision(revision))).catch(() => {});
}

/**
 * Both sides of a release.
 * @param {number} revision
 * @param {{server: import('../parity/server.mjs').Server, swaps?: Record<string, string>, log?: (line: string) => void}} options - The
 *   server stays open when the sides close.
 * @returns {Promise<{browser: ReleaseBrowser, shading: object, server?: {draw: Function}}>} `shading`: what this server draws with.
 */
export async function sidesOf(revision, { server, swaps = {}, log = () => {} }) {
  const name = versionOf(nearestRevision(revision));
  const browser = new ReleaseBrowser({ name, folder: await fetchRelease(name), stamp: pageStamp(), log });
  const shading = resolveThree({ base: 'three', revision, ...swaps });
  return { browser, shading, server: server && { draw: (input) => server.draw({ ...input, shot: { ...input.shot, shading } }) } };
}
