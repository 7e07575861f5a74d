// telar's text of stock three.js within three.js: what js/three puts a shading's text into, apart from what a shading does.
// `npm run parity -- --own-text` draws every case of the gate so.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Browser } from './browser/chromium.mjs';
import { GATE_CASES } from './cases.mjs';
import { Comparer } from './comparer.mjs';
import { drawCases } from './draw_cases.mjs';
import { openOwnText } from './own_text.mjs';
import { figuresText } from './report_page.mjs';

/** What the text reads of three.js: maps, lights, shadows, layers, skins, instances, transmission. */
const CASES = [
  'sweep-sun',
  'cloth-env',
  'lights-many',
  'shadow-everything',
  'physical-everything-lights',
  'anisotropy-map-tangents-env',
  'rect-everything',
  'transmission-layers-lit',
  'morph-and-skin-0-0.6',
  'instances-colors-rest',
];

test("telar's text of stock three.js draws what stock three.js draws", async (t) => {
  const browser = await Browser.start();
  const sides = { browser, server: openOwnText(browser), comparer: new Comparer() };
  t.after(() => Promise.all(Object.values(sides).map((side) => side.close())));
  const cases = CASES.map((name) => GATE_CASES.find((item) => item.name === name));
  for await (const result of drawCases(cases, sides)) {
    await t.test(result.item.name, () => {
      if (result.error) throw result.error;
      assert.ok(result.difference.pass, figuresText(result));
    });
  }
});
