// node test/families/run.mjs [--no-page] [--kept] [release...]
// Fetches releases of three.js from npm, all from 0.150 on or those that are named, draws the cases with each in headless Chromium, and says
// which of them draw the same: families. Then puts older terms into newer releases (slots.mjs) and asks that they draw as the older ones.
// Writes js/docs/families.md when all releases were looked at.
// Releases and pictures are kept in out/families. Exit code 1 when a border between families is not explained by its slots.
//   --no-page  families alone: no slots, no page
//   --kept     only releases whose pictures are kept from before; the page says which it leaves out
import { existsSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { CASES } from './cases.mjs';
import { drawRelease, pageStamp } from './draw.mjs';
import { differences, familiesOf, LAST, rangeOf } from './families.mjs';
import { familiesPage } from './page.mjs';
import { PAGE, PICTURES } from './places.mjs';
import { compareReleases, fetchRelease, listReleases } from './releases.mjs';
import { BORDERS } from './slots.mjs';
import { verdictOf } from './verdict.mjs';
import { verifyBorder } from './verify.mjs';

const { values: options, positionals: wanted } = parseArgs({
  allowPositionals: true,
  options: { 'no-page': { type: 'boolean', default: false }, kept: { type: 'boolean', default: false } },
});
const stamp = pageStamp();
const all = await listReleases();
const unknown = wanted.find((release) => !all.includes(release));
if (unknown) throw new Error(`npm has no three@${unknown}: expected one of ${all.join(' ')}`);

/** A named release is told by the one before it, and by the last known one. */
const before = (release) => all[all.indexOf(release) - 1] ?? release;
const named = wanted.length > 0 ? [...new Set([...wanted, ...wanted.map(before), LAST])].sort(compareReleases) : all;
const releases = options.kept ? named.filter((release) => existsSync(path.join(PICTURES, `${release}.json`))) : named;
const pictures = new Map();
for (const release of releases) {
  const folder = await fetchRelease(release);
  const begin = performance.now();
  const warnings = new Set();
  pictures.set(release, await drawRelease({ name: release, folder }, CASES, stamp, (line) => warnings.add(line)));
  console.log(`${release}  ${((performance.now() - begin) / 1000).toFixed(1)} s`);
  for (const line of warnings) console.log(`  ${line.slice(0, 200)}`);
}

for (const [name, { absent }] of Object.entries(pictures.get(LAST))) if (absent) throw new Error(`three.js ${LAST} does not draw ${name}: ${absent}`);

const families = familiesOf(pictures);
for (const release of wanted) for (const line of verdictOf(release, families, before(release))) console.log(line);
for (const [i, family] of wanted.length > 0 ? [] : families.entries()) {
  console.log(`${rangeOf(family)}`);
  if (i + 1 < families.length) console.log(`  the next differs in ${namesOf(differences(family, families[i + 1]))}`);
}
if (wanted.length === 0 && !options['no-page']) {
  const proofs = [];
  for (const border of BORDERS) proofs.push({ border, ...(await verifyBorder(border, { pictures, stamp, log: () => {} })) });
  writeFileSync(PAGE, familiesPage({ families, proofs, omitted: all.filter((release) => !releases.includes(release)) }));
  for (const { border, left } of proofs) {
    if (left.length > 0) console.log(`${border.older} to ${border.newer} is not explained in ${left.map(({ name }) => name).join(', ')}`);
    else console.log(`${border.older} to ${border.newer} is explained by ${border.slots.map(({ slot }) => slot).join(', ')}`);
  }
  if (proofs.some(({ left }) => left.length > 0)) process.exitCode = 1;
}

function namesOf(differing) {
  const shown = differing.map(({ name, distance }) => (distance ? `${name} (${distance.mean.toFixed(2)}, at most ${distance.max})` : `${name} (not in both)`));
  return `${differing.length} cases: ${shown.join(', ')}`;
}
