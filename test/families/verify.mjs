import { CASES } from './cases.mjs';
import { distance } from './distance.mjs';
import { drawRelease } from './draw.mjs';
import { editedFiles } from './edits.mjs';
import { folderOf } from './releases.mjs';

/**
 * What a slot's older term does to the newer release, on one case.
 * @typedef {object} Shown
 * @property {string} name - Of the case.
 * @property {{mean: number, max: number, edge: number}} moved - From the newer release's picture to that with the older term.
 * @property {{mean: number, max: number, edge: number}} left - From there to the older release's.
 */

/** Draws a release whose sources are edited. */
const drawEdited = (version, name, edits, cases, { stamp, log }) =>
  drawRelease({ name: `${version} ${name}`, folder: folderOf(version), edited: editedFiles(version, edits) }, cases, stamp, log);

const named = (names) =>
  names.map((name) => {
    const item = CASES.find((candidate) => candidate.name === name);
    if (!item) throw new Error(`there is no case ${name}`);
    return item;
  });

/**
 * Puts the older terms into the newer release: each by itself on its own cases, and all together on every case that differs.
 * @param {import('./slots.mjs').Border} border
 * @param {{pictures: Map<string, Record<string, import('./draw.mjs').Picture>>, stamp: string, log: Function}} drawn - `pictures` by release.
 * @returns {Promise<{slots: {slot: string, shown: Shown[]}[], left: Shown[]}>} `left`: cases that are not the older release's with all of them.
 */
export async function verifyBorder({ older, newer, everyCase = false, slots }, { pictures, ...how }) {
  const [before, after] = [older, newer].map((version) => pictures.get(version));
  const show = (edited, cases) =>
    cases.map((item) => ({
      name: item.name,
      moved: distance(item, after[item.name], edited[item.name]),
      left: distance(item, before[item.name], edited[item.name]),
    }));
  const rows = [];
  for (const { slot, edits, cases } of slots) {
    const own = named(cases);
    rows.push({ slot, shown: show(await drawEdited(newer, everyCase ? `${slot}, every case` : slot, edits, everyCase ? CASES : own, how), own) });
  }
  const changed = CASES.filter((item) => before[item.name].image !== after[item.name].image && !before[item.name].absent);
  const name = everyCase ? 'all, every case' : 'all';
  const together = await drawEdited(
    newer,
    name,
    slots.flatMap(({ edits }) => edits),
    everyCase ? CASES : changed,
    how,
  );
  return { slots: rows, left: show(together, changed).filter(({ left }) => !left || left.max > 0 || left.edge > 0) };
}
