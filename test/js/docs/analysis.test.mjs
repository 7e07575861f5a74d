import assert from 'node:assert/strict';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { FABRICS, LIGHTS, swapsBetween } from '../../../js/analyse/index.mjs';
import { assertWellFormed } from '../analyse/support.mjs';

const DOCS = new URL('../../../js/docs/', import.meta.url);
const page = readFileSync(new URL('analysis.md', DOCS), 'utf8');
const files = readdirSync(new URL('analysis/', DOCS));

test('the page ranks every term that differs today, and names every light and fabric', () => {
  for (const { slot, from, to } of swapsBetween('three-r115', 'disney-2012').terms)
    assert.ok(page.includes(`| **${slot}** | ${from} → ${to} |`), `${slot}: run npm run analysis`);
  for (const light of Object.keys(LIGHTS)) assert.ok(page.includes(`\`${light}\` (`), light);
  for (const fabric of FABRICS) assert.ok(page.includes(`\n### ${fabric}\n`), fabric);
});

test('its pictures are there, all of them used, small and whole', () => {
  const linked = [...page.matchAll(/\]\(analysis\/([^)]+)\)/g)].map(([, file]) => file);
  assert.deepEqual(linked.sort(), files.sort());
  const sizes = files.map((file) => statSync(new URL(`analysis/${file}`, DOCS)).size);
  assert.ok(sizes.reduce((sum, size) => sum + size, 0) < 400_000, String(sizes));
  for (const file of files.filter((name) => name.endsWith('.svg'))) assertWellFormed(readFileSync(fileURLToPath(new URL(`analysis/${file}`, DOCS)), 'utf8'));
});
