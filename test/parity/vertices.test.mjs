// Bits of what vertices carry: the same operations on floats in the same order as in the browser's vertex stage. Where light is steep (a narrow
// highlight, a rectangle light at grazing angles) a last bit of a normal is many steps of the picture.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Browser } from './browser/chromium.mjs';
import { CASES } from './cases.mjs';
import { loadInputs } from './inputs.mjs';
import { openServer } from './server.mjs';

/** Normals through joints, targets, instances and nodes, of integers, and of a bump map. */
const NORMALS = [
  'skin-0-0.3',
  'skin-tangents-0-0.4',
  'skin-bytes-rest',
  'skin-shorts-rest',
  'skin-scaled-rest',
  'morph-0-0.25',
  'morph-and-skin-0-0.6',
  'instances-rest',
  'animated-nodes-0-0.75',
  'draco-quantized-sun',
  'meshopt-torus-sun',
  'bump-map-sun',
];
const COLORS = ['morph-colors-rest', 'instances-colors-rest'];

/** Below the last bit of what is not 0 here: a turn by matrices leaves 3e-17 in place of 0. */
const ZERO = 1e-12;

/** Pixels whose values differ, of those that both sides draw. */
function differing(expected, actual) {
  let [drawn, differ] = [0, 0];
  for (let i = 0; i < actual.length; i += 4) {
    if (actual[i + 3] !== 1 || expected[i + 3] !== 1) continue;
    drawn++;
    differ += [0, 1, 2].some((c) => Math.abs(actual[i + c] - expected[i + c]) > ZERO);
  }
  return { drawn, differ };
}

test('normals and colours of vertices have the bits of the browser', async (t) => {
  const [browser, server] = await Promise.all([Browser.start(), openServer()]);
  t.after(() => Promise.all([browser.close(), server.close()]));
  for (const [quantity, names] of Object.entries({ n: NORMALS, baseColor: COLORS })) {
    for (const name of names) {
      await t.test(`${quantity} of ${name}`, async () => {
        const item = CASES.find((candidate) => candidate.name === name);
        const input = { shot: item.shot, ...(await loadInputs(item)) };
        const [expected, actual] = await Promise.all([browser.terms({ ...input, terms: [quantity] }), server.debug(input, [quantity])]);
        const { drawn, differ } = differing(expected[quantity], actual[quantity]);
        assert.ok(drawn > 1000, `${drawn} pixels are drawn by both`);
        assert.equal(differ, 0, `${differ} of ${drawn} pixels have other bits: vertices are read, moved or rounded otherwise than by three.js`);
      });
    }
  }
});
