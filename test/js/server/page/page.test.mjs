import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launchChromium } from '../../view/support.mjs';
import { openPool, serve } from '../support.mjs';

// The page to try the service, in real headless Chromium.

const SHIRT = fileURLToPath(new URL('../../../../js/assets/tshirt.glb', import.meta.url));

let pool, service, browser, page;
const [said, asked] = [[], []];
before(async () => {
  [pool, browser] = await Promise.all([openPool(), launchChromium()]);
  service = await serve({ pool });
  page = await browser.newPage();
  page.on('pageerror', (error) => said.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) said.push(message.text());
  });
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(new URL('/try', service.url).href);
  await page.waitForSelector('#files input');
});
after(async () => {
  await browser?.close();
  await service.drain();
  await pool.close();
});

const answered = () => page.waitForFunction(() => /^\d{3}, /.test(document.getElementById('status').textContent));

test('a thumbnail is drawn and shown, and the curl line asks for the same', async () => {
  await page.locator('#files input[name=model]').setInputFiles(SHIRT);
  await page.locator('#keys').fill('{"shot": {"size": {"width": 40, "height": 30}}}');
  await page.locator('#request button').click();
  await answered();
  assert.match(await page.locator('#status').textContent(), /^200, image\/png, \d+ bytes/);
  await page.waitForFunction(() => document.getElementById('picture').naturalWidth > 0);
  assert.deepEqual(await page.locator('#picture').evaluate(({ naturalWidth, naturalHeight }) => [naturalWidth, naturalHeight]), [40, 30]);
  assert.match(await page.locator('#curl').textContent(), /-F 'model=@tshirt\.glb' [\s\S]*shot=\{"size":\{"width":40,"height":30\}\}'/u);
});

test('a problem is shown as it is told', async () => {
  await page.locator('#keys').fill('{"shot": {"exposure": -1}}');
  await page.locator('#request button').click();
  await page.waitForFunction(() => document.getElementById('status').textContent.startsWith('400'));
  assert.equal(JSON.parse(await page.locator('#text').textContent()).code, 'E_SHOT');
});

test('every route is there with its files, and nothing comes from elsewhere', async () => {
  const routes = await page.locator('#route option').allTextContents();
  assert.deepEqual(routes, ['/v1/thumbnails', '/v1/inspect', '/v1/compare', '/v1/sheets']);
  await page.locator('#route').selectOption('/v1/compare');
  assert.deepEqual(await page.locator('#files input').evaluateAll((inputs) => inputs.map(({ name }) => name)), ['expected', 'actual']);
  assert.ok(asked.length > 5 && asked.every((address) => address.startsWith(`${service.url}/`) || address.startsWith('blob:')), asked.join('\n'));
  assert.deepEqual(
    said.filter((line) => !line.includes('status of 400')),
    [],
  );
});
