// node test/parity/run.mjs [--browser-only | --self] [--fast] [filter...]
// Draws every case with three.js in headless Chromium and with telar, prints a table, writes out/parity/index.html.
// Exit code 1 when a case is over the bar. --self: three.js on another rasteriser (SwiftShader) in telar's place.
import { parseArgs } from 'node:util';
import { Browser } from './browser/chromium.mjs';
import { selectCases } from './cases.mjs';
import { drawBoth, drawInBrowser } from './draw_both.mjs';
import { Report } from './report.mjs';
import { openSecondBrowser, openServer } from './server.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    'browser-only': { type: 'boolean' },
    fast: { type: 'boolean' },
    self: { type: 'boolean' },
  },
});

const cases = selectCases(positionals).filter((item) => !values.fast || item.fast);
const browser = await Browser.start();
const server = values['browser-only'] ? null : await (values.self ? openSecondBrowser() : openServer());
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
  if (!server) {
    const { facts } = (await drawInBrowser(item, browser)).expected;
    console.log(`${item.name}  load ${facts.loadMs.toFixed()} ms, draw ${facts.drawMs.toFixed()} ms`);
    return;
  }
  try {
    const { expected, ...result } = await drawBoth(item, browser, server);
    console.log(report.add(item, expected, result));
  } catch (error) {
    // A picture that cannot be drawn is a failed case, not the end of the run.
    console.log(report.add(item, null, { error }));
  }
}
