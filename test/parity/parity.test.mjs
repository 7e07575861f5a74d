// A fast subset of the parity cases as tests; `node test/parity/run.mjs` draws them all and writes a report.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { Browser } from './browser/chromium.mjs';
import { CASES } from './cases.mjs';
import { drawBoth } from './draw_both.mjs';
import { openServer } from './server.mjs';

describe('telar draws what three.js shows in Chromium', () => {
  let browser;
  let server;
  before(async () => {
    browser = await Browser.start();
    server = await openServer();
  });
  after(async () => {
    await browser?.close();
    await server?.close();
  });

  for (const item of CASES.filter(({ fast }) => fast)) {
    test(item.name, async () => {
      const { interior, pass } = (await drawBoth(item, browser, server)).difference;
      assert.ok(pass, `interior: ${JSON.stringify(interior)}; see node test/parity/run.mjs ${item.name}`);
    });
  }
});
