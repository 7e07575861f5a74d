import { familyName, familyOf, REVISION } from '../../js/shot/three_terms.mjs';
import { CASES } from './cases.mjs';
import { differences } from './families.mjs';
import { revisionOf } from './releases.mjs';
import { BORDERS } from './slots.mjs';

/** Cases that have shown a slot at some border, by slot. */
function casesBySlot() {
  const cases = new Map();
  for (const { slots } of BORDERS) for (const { slot, cases: own } of slots) cases.set(slot, new Set([...(cases.get(slot) ?? []), ...own]));
  return cases;
}

/** As many as are worth a look: further down stand slots that share their cases with these. */
const MOST = 8;

/**
 * The slots that changed cases speak for: those of whose cases most changed first.
 * @param {string[]} changed - Names of cases.
 * @returns {{slot: string, changed: number, of: number}[]}
 */
export function suspects(changed) {
  const rows = [...casesBySlot()].map(([slot, cases]) => ({ slot, of: cases.size, changed: [...cases].filter((name) => changed.includes(name)).length }));
  const isHalf = (row) => row.changed * 2 >= row.of;
  return rows
    .filter((row) => row.changed > 0 && isHalf(row))
    .sort((a, b) => b.changed - a.changed || a.of - b.of)
    .slice(0, MOST);
}

const shareText = ({ slot, changed, of }) => `${slot} (${changed} of ${of} cases)`;

/**
 * What is known of one release, against the release before it.
 * @param {string} release
 * @param {import('./families.mjs').Family[]} families - Of releases that were drawn, the one before it too.
 * @param {string} before
 * @returns {string[]} Lines.
 */
export function verdictOf(release, families, before) {
  const [own, earlier] = [release, before].map((name) => families.find(({ releases }) => releases.includes(name)));
  const revision = revisionOf(release);
  const table = revision > REVISION ? 'the table ends before it' : `the table has it as ${familyName(familyOf(revision))}`;
  if (own === earlier) return [`${release} draws all ${CASES.length} cases as ${before} does, bit for bit: no new family; ${table}`];
  const changed = differences(earlier, own);
  const most = Math.max(0, ...changed.map(({ distance }) => Math.max(distance?.max ?? 0, distance?.edge ?? 0)));
  const within = most <= 2 ? ', within the bars of the gate' : '';
  const shown = changed.map(({ name, distance }) => (distance ? `${name} (${distance.mean.toFixed(2)}, at most ${distance.max})` : `${name} (not in both)`));
  return [
    `${release} is a new family after ${before}: ${changed.length} of ${CASES.length} cases change, at most by ${most}/255${within}; ${table}`,
    `  cases: ${shown.join(', ')}`,
    `  slots whose cases changed: ${
      suspects(changed.map(({ name }) => name))
        .map(shareText)
        .join(', ') || 'none that is known'
    }`,
  ];
}
