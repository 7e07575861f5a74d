// node test/parity/run.mjs [--browser-only] [--fast] [--rasterizer mesa|swiftshader] [filter...]
// Draws every case with three.js in headless Chromium and with telar, prints a table, writes out/parity/index.html.
// Exit code 1 when a case is over the bar.
import { parseArgs } from 'node:util';
import { Browser } from './browser/chromium.mjs';
import { selectCases } from './cases.mjs';
import { saveReference } from './files.mjs';
import { loadInputs } from './inputs.mjs';
import { Report } from './report.mjs';
import { openServer } from './server.mjs';
import { difference, premultiply } from './metrics.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    'browser-only': { type: 'boolean' },
    fast: { type: 'boolean' },
    rasterizer: { type: 'string', default: 'mesa' },
  },
});

const cases = selectCases(positionals).filter((item) => !values.fast || item.fast);
const browser = await Browser.start({ rasterizer: values.rasterizer });
const server = values['browser-only'] ? null : await openServer();
const report = new Report();
try {
  for (const item of cases) await runCase(item);
} finally {
  await browser.close();
  await server?.close();
}
if (server) console.log(await report.finish());
process.exitCode = report.failed ? 1 : 0;

async function runCase(item) {
  const inputs = await loadInputs(item);
  const expected = await browser.draw({ shot: item.shot, ...inputs });
  saveReference(item, inputs, expected);
  if (!server) {
    console.log(`${item.name}  load ${expected.facts.loadMs.toFixed()} ms, draw ${expected.facts.drawMs.toFixed()} ms`);
    return;
  }
  const result = await drawOnServer(item, inputs, expected);
  console.log(report.add(item, expected, result));
}

/** A picture that cannot be drawn is a failed case, not the end of the run. */
async function drawOnServer(item, inputs, expected) {
  try {
    const actual = premultiply(await server.draw({ shot: item.shot, ...inputs }));
    const background = item.shot.background !== 'transparent';
    return { actual, difference: difference({ ...expected, expected: expected.image, actual, background }) };
  } catch (error) {
    return { error };
  }
}
