// A fast subset of the parity cases as tests; `npm run parity` draws them all and writes a report.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Browser } from './browser/chromium.mjs';
import { CASES } from './cases.mjs';
import { Comparer } from './comparer.mjs';
import { drawCases } from './draw_cases.mjs';
import { figuresText } from './report_page.mjs';
import { openServer } from './server.mjs';

test('telar draws what three.js shows in Chromium', async (t) => {
  const [browser, server] = await Promise.all([Browser.start(), openServer()]);
  const sides = { browser, server, comparer: new Comparer() };
  t.after(() => Promise.all(Object.values(sides).map((side) => side.close())));
  for await (const result of drawCases(
    CASES.filter(({ fast }) => fast),
    sides,
  )) {
    await t.test(result.item.name, () => {
      if (result.error) throw result.error;
      assert.ok(result.difference.pass, `${figuresText(result)}; see node test/parity/run.mjs ${result.item.name}`);
    });
  }
});
