// The gate's own test: with a fault planted in telar's rendering it fails, without it passes, and the trace names where.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { number } from '../../js/compare/figures.mjs';
import { Browser } from './browser/chromium.mjs';
import { GATE_CASES } from './cases.mjs';
import { FAULTS } from './faults.mjs';
import { loadInputs } from './inputs.mjs';
import { difference } from './metrics.mjs';
import { QUANTITY_NAMES } from './quantities.mjs';
import { openTool } from './server.mjs';
import { traceOf, traceText } from './trace.mjs';

const BUILD = path.resolve(fileURLToPath(new URL('../..', import.meta.url)), process.env.TELAR_BUILD_DIR ?? 'out/dev');
process.env.TELAR_LIBRARY_DIR ??= path.join(BUILD, 'addon');

let browser;
let folder;
before(async () => {
  browser = await Browser.start();
  folder = mkdtempSync(path.join(tmpdir(), 'telar-faults-'));
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/** telar with changed shaders, as it would be with the fault in shaders/. No fault changes how environments are filtered. */
function openEdited(edits) {
  const file = path.join(folder, 'edits.json');
  writeFileSync(file, JSON.stringify(edits));
  return openTool(path.join(BUILD, 'bin/telar_draw'), ['--shader-edits', file, '--cache', path.join(folder, 'cache')]);
}

/** telar that draws another shot than it is asked for. */
function openMisled(change) {
  const server = openEdited([]);
  const changed = (input) => ({ ...input, shot: change(input.shot) });
  return { draw: (input) => server.draw(changed(input)), debug: (input, names) => server.debug(changed(input), names) };
}

const references = new Map();

/** The browser's picture of a case, drawn once. */
async function referenceOf(name) {
  if (!references.has(name)) {
    const item = GATE_CASES.find((candidate) => candidate.name === name);
    assert.ok(item, `the gate has a case ${name}`);
    const inputs = await loadInputs(item);
    references.set(name, { item, inputs, expected: await browser.draw({ shot: item.shot, ...inputs }) });
  }
  return references.get(name);
}

async function judge({ item, inputs, expected }, server) {
  const actual = await server.draw({ shot: item.shot, ...inputs });
  const { image, mask, width, height } = expected;
  const background = item.shot.background !== 'transparent';
  return { item, inputs, difference: difference({ expected: image, actual, mask, width, height, background }) };
}

describe('the gate catches', () => {
  for (const fault of FAULTS) {
    test(fault.name, async (t) => {
      const reference = await referenceOf(fault.item);
      reference.clean ??= (await judge(reference, openEdited([]))).difference;
      assert.ok(reference.clean.pass, `${fault.item} passes without the fault`);

      const server = fault.shot ? openMisled(fault.shot) : openEdited(fault.edits);
      const result = await judge(reference, server);
      const { checks, pass } = result.difference.verdict;
      const figures = checks.map(({ region, figure, value, limit }) => `${region} ${figure} ${number(value)} (bar ${limit})`).join(', ');
      t.diagnostic(`${fault.item}: ${figures}`);
      assert.ok(!pass, `${fault.item} fails with the fault: ${figures}`);

      const trace = await traceOf(result, { browser, server }, { through: fault.first });
      assert.equal(trace.first, fault.first, traceText(trace));
    });
  }
});

/** Pixels of materials with every layer, and how many quantities are there. */
const SOUND = [
  ['physical-everything-env', [110, 89], QUANTITY_NAMES.length - 1],
  ['transmission-layers-lit', [95, 108], QUANTITY_NAMES.length],
];

for (const [name, pixel, count] of SOUND) {
  test(`without a fault the trace of ${name} names nothing`, async () => {
    const trace = await traceOf(await referenceOf(name), { browser, server: openEdited([]) }, { pixel });
    assert.equal(trace.first, null, traceText(trace));
    assert.equal(trace.terms.filter((term) => term.browser && term.telar).length, count, traceText(trace));
  });
}

test('an edit that does not fit the shaders is an error, not a fault that is not there', async () => {
  const { item, inputs } = await referenceOf('light-directional');
  for (const find of ['this text is nowhere', 'float']) {
    const server = openEdited([{ file: 'brdf/roughness.glsl', find, replace: '' }]);
    await assert.rejects(server.draw({ shot: item.shot, ...inputs }), /does not hold|more than once/);
  }
});
