import { CASES } from './cases.mjs';
import { differences, LAST, rangeOf } from './families.mjs';
import { REVISION, REVISION_MIN, termsOfRevision } from '../../js/shot/three_terms.mjs';
import { compareReleases, versionOf } from './releases.mjs';
import { SLOT_TERMS } from './slot_terms.mjs';

const INTRO = `# Families of three.js releases

What three.js shows changed with its releases. This page says where: every release from 0.150 on draws ${CASES.length} pictures of 128 pixels,
in headless Chromium on Mesa llvmpipe, set up by \`applyShot\`. Releases that draw all of them alike, bit for bit, are a family. \`npm run families\` measures it again and
writes this page; \`npm run families -- 0.188.0\` says of one release whether it is a new family, and in which cases.

\`applyShot\` does what an older release asks for: it writes \`outputEncoding\` and gives an sRGB background (to 0.151), turns legacy lights off (to 0.154), turns
the texels of an environment (to 0.161), and sets \`envMapIntensity\` on each material (to 0.162). With legacy lights, which 0.150 to 0.154 have on by default, no light has the units of a shot.

Figures are differences of the channel that differs most, in 1/255, inside of the model and before a drawn background: mean / largest. Pictures that differ only along silhouettes have 0.00 / 0.`;

const LAST_FAMILY = (families) => families.find(({ releases }) => releases.includes(LAST));

const figure = (distance) => (distance ? `${distance.mean.toFixed(2)} / ${distance.max}` : '-');

/** The short head of a column. */
const headOf = ({ releases }) =>
  [releases[0], releases.length > 1 ? releases.at(-1) : undefined]
    .filter(Boolean)
    .map((release) => release.replace('0.', '').replace(/\.0$/, ''))
    .join('-');

function familyRows(families) {
  const last = LAST_FAMILY(families);
  return families.map((family, i) => {
    const next = families[i + 1];
    const off = differences(last, family).filter(({ distance }) => distance);
    const mean = off.reduce((sum, { distance }) => sum + distance.mean, 0) / CASES.length;
    const most = Math.max(0, ...off.map(({ distance }) => distance.max));
    const changed = next && differences(family, next);
    const worst = changed && Math.max(0, ...changed.map(({ distance }) => distance?.max ?? 0));
    const near = changed?.every(({ distance }) => distance && distance.max <= 2 && distance.edge <= 2) ? ', near' : '';
    return `| ${rangeOf(family)} | ${off.length} | ${mean.toFixed(2)} / ${most} | ${changed ? `${changed.length}, at most ${worst}${near}` : ''} |`;
  });
}

function caseRows(families) {
  const last = LAST_FAMILY(families);
  const byFamily = families.map((family) => new Map(differences(last, family).map(({ name, distance }) => [name, figure(distance)])));
  return CASES.map(({ name }) => `| ${name} | ${byFamily.map((cells) => cells.get(name) ?? '').join(' | ')} |`);
}

/** Cases that showed a slot at a border, most first. */
const shownText = (shown) =>
  shown
    .filter(({ moved }) => moved && moved.max + moved.edge > 0)
    .sort((a, b) => b.moved.mean - a.moved.mean)
    .map(({ name, moved }) => `${name} ${moved.mean.toFixed(2)} / ${moved.max}`)
    .join(', ');

const IS_ABSENT = 'absent';

/**
 * What a shot calls a term of a slot.
 * @param {import('./slot_terms.mjs').SlotTerms} row
 * @param {import('./slot_terms.mjs').Term} term
 * @returns {string} '' where a shot cannot name it: no slot of its own, or of a patch that is drawn as a later one.
 */
export function nameOfTerm({ key }, { from = `0.${REVISION_MIN}.0`, to, what }) {
  if (!key || what === IS_ABSENT) return '';
  const isWithin = (version) => compareReleases(from, version) <= 0 && (to === undefined || compareReleases(version, to) <= 0);
  for (let revision = REVISION_MIN; revision <= REVISION; revision++) if (isWithin(versionOf(revision))) return termsOfRevision(revision)[key];
  return '';
}

const quoted = (name) => (name ? `\`${name}\`` : '');

/** The columns of a slot's table that are known without drawing: up to what a term computes. */
export function slotCells(row, i) {
  const { slot, key, terms } = row;
  const { from = '', to = '', what } = terms[i];
  const head = i === 0 ? `**${slot}**${key ? ` ${quoted(key)}` : ''}` : '';
  return [head, quoted(nameOfTerm(row, terms[i])), from, to, what.replaceAll(/\s+/g, ' ').replaceAll('|', '\\|')];
}

function slotRows(proofs) {
  return SLOT_TERMS.flatMap((row) =>
    row.terms.map(({ to = '' }, i) => {
      const proof = proofs.find(({ border }) => border.older === to)?.slots.find(({ slot }) => slot === row.slot);
      const cells = [...slotCells(row, i), proof ? shownText(proof.shown) : '', i === 0 ? (row.source ?? '') : ''];
      return `| ${cells.join(' | ')} |`;
    }),
  );
}

function proofRows(proofs) {
  return proofs.map(({ border: { older, newer }, slots, left }) => {
    const rest = left.map(({ name, left: distance }) => `${name} ${figure(distance)}`).join(', ');
    return `| ${older} | ${newer} | ${slots.map(({ slot }) => slot).join(', ')} | ${rest || 'nothing: every case is that of the older release, bit for bit'} |`;
  });
}

/**
 * The page.
 * @param {object} measured
 * @param {import('./families.mjs').Family[]} measured.families
 * @param {({border: import('./slots.mjs').Border} & Awaited<ReturnType<typeof import('./verify.mjs').verifyBorder>>)[]} measured.proofs
 * @param {string[]} [measured.omitted] - Releases that were not looked at.
 * @returns {string} Markdown.
 */
export function familiesPage({ families, proofs, omitted = [] }) {
  return `${[
    INTRO,
    ...(omitted.length > 0 ? [`Not looked at yet: ${omitted.join(', ')}.`] : []),
    `## Families

Off ${LAST}: cases that differ, the mean of all ${CASES.length}, and the largest. A border is near where no case changes by more than 2/255, silhouettes too.

| releases | cases off ${LAST} | mean / largest | cases that change to the next |
|---|---|---|---|
${familyRows(families).join('\n')}`,
    `## Slots

What changed, as terms: r is the perceptual roughness, F0 and F90 the reflectances at 0 and 90 degrees, A and B the parts of DFG, E = A + B, m = 1 - E. The cases stand by the older term, with what putting it into
the next release changes. Terms without cases were read in the sources. Names in code are those of a shot: \`shading: {base: "three", revision: 180, dfg: "table-16"}\`. What has none
is a client's own setting, a fault that is not drawn, or a patch that is drawn as the one after it.

| slot | term | from | to | computes | cases that show it | source |
|---|---|---|---|---|---|---|
${slotRows(proofs).join('\n')}`,
    `## Proofs

The older terms of all slots, put into the newer release in memory, make it draw the older one's pictures. What is left:

| older | newer | slots | left |
|---|---|---|---|
${proofRows(proofs).join('\n')}`,
    `## Cases

Distance of each family from ${LAST}; nothing where they are equal, - where the release cannot show the case.

| case | ${families.map(headOf).join(' | ')} |
|---|${families.map(() => '---|').join('')}
${caseRows(families).join('\n')}`,
  ].join('\n\n')}\n`;
}
