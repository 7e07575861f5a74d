import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { readEmbeddedShot } from '../../../js/compare/embedded_shot.mjs';
import { changing, CLI, countsOf, figuresOf, launchChromium, openView, pictures, settled, SHIRT } from './support.mjs';

// The page in real headless Chromium on the real renderer: the bundled garment, small.

const folder = mkdtempSync(path.join(tmpdir(), 'telar-view-page-'));
const at = (name) => path.join(folder, name);

let view;
let browser;
let page;
const said = [];
const asked = [];

before(async () => {
  [view, browser] = await Promise.all([openView(SHIRT, ['--size', '96']), launchChromium()]);
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, acceptDownloads: true });
  context.on('request', (request) => asked.push(request.url()));
  page = await context.newPage();
  page.on('pageerror', (error) => said.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) said.push(message.text());
  });
  await page.goto(view.url);
  await settled(page);
});
after(async () => {
  await browser?.close();
  await view?.stop();
  rmSync(folder, { recursive: true });
});

const shotOf = async () => JSON.parse(await page.locator('#shot').inputValue());
const verdict = () => page.locator('#verdict').textContent();

test('both pictures show the garment, and they are at parity', async () => {
  for (const selector of ['#client-canvas canvas', '#server-picture canvas']) {
    const { width, height, opaque, lit } = await countsOf(page, selector);
    assert.deepEqual([width, height], [96, 96]);
    assert.ok(opaque > 3000 && lit > 3000, `${selector}: ${opaque} ${lit}`);
  }
  assert.equal(await verdict(), 'Parity');
  const interior = await figuresOf(page, 'interior');
  assert.ok(interior.pixels > 3000 && interior.max <= 2 && interior['p99.9'] <= 1, JSON.stringify(interior));
  assert.match(await page.locator('#client-gl').textContent(), /^three\.js r187, /);
  assert.equal(await page.locator('#gl-hint').isVisible(), false, 'one GL draws both');
  assert.equal(await page.locator('#notes li').count(), 0, 'both sides resolved the shot alike');
});

test('every control is reached by Tab, has a name, and shows that it has the focus', async () => {
  await page.evaluate(() => document.activeElement?.blur());
  await page.locator('summary').evaluate((node) => (node.parentElement.open = true));
  const reached = [];
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    const focused = await page.evaluate(() => {
      const node = document.activeElement;
      const shown = node.matches('input[type=radio]') ? node.nextElementSibling : node;
      return { id: node.id || node.dataset.view || node.name || node.tagName, isBody: node === document.body, outline: getComputedStyle(shown).outlineStyle };
    });
    if (focused.isBody || focused.id === reached[0]) break;
    assert.notEqual(focused.outline, 'none', focused.id);
    reached.push(focused.id);
  }
  const wanted = [
    'help-button',
    'mode',
    'front',
    'three-quarter',
    'stage',
    'save-browser',
    'save-server',
    'variant',
    'projection',
    'fovY',
    'fit',
    'environment',
    'intensity',
    'rotation',
    'background',
    'ground',
    'shading',
    'toneMapping',
    'exposure',
    'width',
    'height',
    'quality',
    'shot',
    'apply-shot',
    'copy-shot',
  ];
  assert.deepEqual(
    wanted.filter((id) => !reached.includes(id)),
    [],
  );
  const nameless = await page
    .locator('button, input, select, textarea, [role=slider], [role=application]')
    .evaluateAll((nodes) =>
      nodes.filter((node) => !(node.labels?.length > 0 || node.getAttribute('aria-label') || node.textContent.trim())).map((node) => node.id || node.outerHTML),
    );
  assert.deepEqual(nameless, []);
});

/** What to press on each control, and which key of the shot it changes. */
const PRESSED = [
  ['#variant', ['ArrowDown', 'ArrowDown'], 'variant'],
  ['#projection', ['ArrowDown'], 'camera'],
  ['#projection', ['ArrowUp'], 'camera'],
  ['#fovY', ['PageUp', 'PageUp'], 'camera'],
  ['#fit', ['PageDown', 'PageDown'], 'camera'],
  ['#intensity', ['PageUp'], 'environment'],
  ['#rotation', ['PageUp', 'PageUp'], 'environment'],
  ['#environment', ['ArrowDown'], 'environment'],
  ['#environment', ['ArrowUp'], 'environment'],
  ['#shading', ['ArrowDown'], 'shading'],
  ['#shading', ['ArrowDown'], 'shading'],
  ['#shading', ['ArrowDown'], 'shading'],
  ['#shading', ['Home'], 'shading'],
  ['#toneMapping', ['End'], 'toneMapping'],
  ['#exposure', ['PageUp'], 'exposure'],
  ['#background', ['ArrowDown'], 'background'],
  ['#blur', ['PageUp', 'PageUp'], 'background'],
  ['#background', ['ArrowDown'], 'background'],
  ['#ground', ['ArrowDown'], 'ground'],
  ['#opacity', ['PageDown', 'PageDown'], 'ground'],
  ['#quality', ['ArrowDown'], 'quality'],
  // draft merges quads, which three.js does not: what follows is compared as standard.
  ['#quality', ['ArrowUp'], 'quality'],
  ['#width', ['ArrowDown', 'Tab'], 'size'],
  ['#height', ['ArrowUp', 'Tab'], 'size'],
  ['#stage', ['ArrowRight', 'ArrowUp', '+'], 'camera'],
];

for (const [selector, keys, key] of PRESSED) {
  test(`keys alone: ${selector} ${keys.join(' ')} changes the shot's ${key} and both pictures`, async () => {
    const [shotBefore, before] = [await shotOf(), await pictures(page)];
    await page.focus(selector);
    await changing(page, async () => {
      for (const pressed of keys) await page.keyboard.press(pressed);
    });
    const [shotAfter, now] = [await shotOf(), await pictures(page)];
    assert.notDeepEqual(shotAfter[key], shotBefore[key]);
    assert.deepEqual(
      Object.keys(shotAfter).filter((name) => JSON.stringify(shotAfter[name]) !== JSON.stringify(shotBefore[name])),
      [key],
    );
    assert.notEqual(now[0], before[0], "the browser's");
    assert.notEqual(now[1], before[1], "the server's");
    assert.equal(await verdict(), 'Parity', JSON.stringify(await figuresOf(page, 'interior')));
    assert.equal(await page.locator('#alert').isVisible(), false);
  });
}

test('the silhouette before a background is judged apart, as without one', async () => {
  await page.focus('#background');
  await changing(page, () => page.keyboard.press('Home'));
  const transparent = (await figuresOf(page, 'edge')).pixels;
  await changing(page, () => page.keyboard.press('End'));
  const edge = (await figuresOf(page, 'edge')).pixels;
  // A background shows on both sides of the silhouette.
  assert.ok(transparent > 100 && edge > 1.5 * transparent && edge < 2.5 * transparent, `${edge} ${transparent}`);
  assert.equal((await figuresOf(page, 'frame')).pixels, 95 * 97);
});

test('view keys frame the model, and the view that is shown is marked', async () => {
  await page.evaluate(() => document.activeElement?.blur());
  for (const [key, name] of [
    ['2', 'Back'],
    ['7', 'Three-quarter'],
    ['1', 'Front'],
  ]) {
    await changing(page, () => page.keyboard.press(key));
    assert.deepEqual(await page.locator('#views [aria-pressed=true]').allTextContents(), [name]);
  }
  assert.equal((await shotOf()).camera.view, 'front');
});

test('a drag orbits', async () => {
  const before = await pictures(page);
  const box = await page.locator('#client-canvas').boundingBox();
  await changing(page, async () => {
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 260, box.y + 215, { steps: 8 });
    await page.mouse.up();
  });
  const { camera } = await shotOf();
  assert.ok(camera.position[0] < -0.1, `the camera went to the left: ${camera.position}`);
  assert.equal(camera.view, undefined);
  (await pictures(page)).forEach((picture, i) => assert.notEqual(picture, before[i]));
  assert.equal(await verdict(), 'Parity');
});

test('the server draws when the camera rests, not at every move', async () => {
  const draws = () => asked.filter((url) => url.endsWith('/draw')).length;
  const drawn = draws();
  const { camera } = await shotOf();
  // In one turn of the page's event loop, so that no timer runs between two moves however slow this machine is.
  await changing(page, () =>
    page.locator('#stage').evaluate((stage) => {
      for (let i = 0; i < 8; i++) stage.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true, cancelable: true }));
    }),
  );
  assert.notDeepEqual((await shotOf()).camera, camera);
  assert.equal(draws(), drawn + 1);
});

test('a newer shot cancels the drawing of an older one', async () => {
  const failed = [];
  const onFailed = (request) => failed.push(request.failure().errorText);
  page.on('requestfailed', onFailed);
  let held = 0;
  await page.route('**/draw', async (route) => {
    if (held++ === 0) await new Promise((resolve) => setTimeout(resolve, 1500));
    await route.continue().catch(() => {}); // the page no longer waits
  });
  await page.evaluate(() => document.activeElement?.blur());
  await changing(page, async () => {
    const asking = page.waitForRequest('**/draw');
    await page.keyboard.press('3');
    await asking;
    await page.keyboard.press('4');
  });
  await page.unroute('**/draw');
  page.off('requestfailed', onFailed);
  assert.deepEqual(failed, ['net::ERR_ABORTED']);
  assert.equal((await shotOf()).camera.view, 'right');
  assert.equal(await verdict(), 'Parity');
});

test("the slider is ARIA's: keys and pointer move it", async () => {
  await page.keyboard.press('w');
  const handle = page.getByRole('slider', { name: "Share of the browser's picture" });
  const state = () =>
    handle.evaluate((node) => [
      Number(node.getAttribute('aria-valuenow')),
      node.getAttribute('aria-valuetext'),
      getComputedStyle(document.getElementById('server-picture')).clipPath,
    ]);
  await handle.focus();
  for (const [key, value] of [
    ['Home', 0],
    ['ArrowRight', 2],
    ['PageUp', 12],
    ['ArrowLeft', 10],
    ['End', 100],
    ['ArrowUp', 100],
    ['PageDown', 90],
  ]) {
    await page.keyboard.press(key);
    assert.deepEqual(
      await state(),
      [value, `browser ${value} %, server ${100 - value} %`, value === 0 ? 'inset(0px 0px 0px 0%)' : `inset(0px 0px 0px ${value}%)`],
      key,
    );
  }
  const stage = await page.locator('#stage').boundingBox();
  const [shot, box] = [await shotOf(), await handle.boundingBox()];
  await page.mouse.move(box.x + box.width / 2, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(stage.x + stage.width / 2, box.y + 200, { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs((await state())[0] - 50) <= 1, String(await state()));
  assert.deepEqual(await shotOf(), shot, 'the model stays as it was');
});

test('blinking shows one, then the other; Space stops it', async () => {
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press('b');
  /** Which picture is said to be shown, and which ones are visible. */
  const shown = () =>
    page.evaluate(() => [
      document.getElementById('stage').dataset.shown,
      ...['client-picture', 'server-picture'].filter((id) => getComputedStyle(document.getElementById(id)).visibility === 'visible'),
    ]);
  const VISIBLE = { browser: ['browser', 'client-picture'], server: ['server', 'server-picture'] };
  for (const side of ['server', 'browser', 'server']) {
    await page.waitForSelector(`#stage[data-shown=${side}]`);
    const seen = await shown();
    assert.deepEqual(seen, VISIBLE[seen[0]]);
  }
  await page.keyboard.press(' ');
  const stopped = await shown();
  await page.waitForTimeout(1000);
  assert.deepEqual(await shown(), stopped);
  await page.keyboard.press(' ');
  await page.waitForSelector(`#stage[data-shown=${stopped[0] === 'browser' ? 'server' : 'browser'}]`);
});

test('a difference is seen in both maps and in the verdict', async (t) => {
  const wrong = (route) => route.continue({ postData: JSON.stringify({ ...route.request().postDataJSON(), exposure: 4 }) });
  await page.route('**/draw', wrong);
  t.after(() => page.unroute('**/draw', wrong));
  await changing(page, () => page.keyboard.press('1'));
  assert.equal(await verdict(), 'Over the gate');
  assert.ok((await figuresOf(page, 'interior')).max > 10);
  assert.match(await page.locator('#notes').textContent(), /resolved the shot differently: exposure is .* in the browser, 4 on the server/);
  await page.keyboard.press('x');
  const difference = await countsOf(page, '#map-picture canvas');
  await page.keyboard.press('f');
  const flip = await countsOf(page, '#map-picture canvas');
  await page.unroute('**/draw', wrong);
  // The garment takes a quarter of a frame that holds its shadow on the ground as well.
  for (const map of [difference, flip]) assert.ok(map.opaque === map.width * map.height && map.lit > 0.2 * map.opaque, JSON.stringify(map));
  await changing(page, () => page.keyboard.press('2'));
  assert.equal(await verdict(), 'Parity');
  await page.keyboard.press('x');
  assert.equal(await page.locator('#map-picture figcaption').textContent(), 'Difference ×16: none');
  assert.equal((await countsOf(page, '#map-picture canvas')).lit, 0);
});

test('the shot as text: what is applied is drawn, what is wrong is told and changes nothing', async () => {
  const before = await shotOf();
  await page.locator('#shot-text').evaluate((details) => (details.open = true));
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await page.click('#copy-shot');
  assert.deepEqual(JSON.parse(await page.evaluate(() => navigator.clipboard.readText())), before);
  await page.fill(
    '#shot',
    JSON.stringify({ ...before, background: 'transparent', lights: [{ type: 'directional', color: 'red', intensity: 3, position: [1, 1, 1] }] }),
  );
  await changing(page, () => page.click('#apply-shot'));
  assert.equal(await verdict(), 'Parity');
  const [red] = await pictures(page);
  await page.fill('#shot', JSON.stringify({ ...before, exposure: 'bright' }));
  await page.click('#apply-shot');
  assert.match(await page.locator('#alert').textContent(), /shot\.exposure: expected .*"bright".*E_SHOT/);
  assert.equal((await pictures(page))[0], red);
  await page.fill('#shot', '{');
  await page.click('#apply-shot');
  assert.match(await page.locator('#alert').textContent(), /JSON/);
  await page.fill('#shot', JSON.stringify({ camera: { view: 'three-quarter' }, size: before.size }));
  await changing(page, () => page.click('#apply-shot'));
  assert.equal(await page.locator('#alert').isVisible(), false);
});

test('help lists the keys, and turns single keys off', async () => {
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press('?');
  assert.equal(await page.locator('#help').isVisible(), true);
  assert.match(await page.locator('#help').innerText(), /telar compare --gate parity: browser expected/);
  await page.uncheck('#single-keys');
  await page.keyboard.press('Escape');
  await page.keyboard.press('d');
  assert.equal(await page.locator('#stage').getAttribute('data-mode'), 'difference');
  await page.click('#help-button');
  await page.check('#single-keys');
  await page.keyboard.press('Escape');
  await page.keyboard.press('d');
  assert.equal(await page.locator('#stage').getAttribute('data-mode'), 'side');
});

test('pictures are saved with their shot inside, and telar compare takes them', async () => {
  const saved = {};
  for (const [side, key] of [
    ['browser', 's'],
    ['server', 'Shift+S'],
  ]) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.keyboard.press(key)]);
    assert.equal(download.suggestedFilename(), `tshirt-${side}.png`);
    saved[side] = at(download.suggestedFilename());
    await download.saveAs(saved[side]);
    const shot = readEmbeddedShot(readFileSync(saved[side]));
    assert.deepEqual([shot.size, shot.environment.map, shot.camera.projection], [{ width: 95, height: 97 }, 'studio', 'perspective']);
  }
  const { status, stdout, stderr } = spawnSync(process.execPath, [CLI, 'compare', saved.browser, saved.server, '--gate', 'parity', '--json'], {
    encoding: 'utf8',
  });
  assert.equal(status, 0, stderr);
  const { interior, width, height } = JSON.parse(stdout);
  assert.deepEqual([width, height, interior.max], [95, 97, (await figuresOf(page, 'interior')).max]);
  const again = spawnSync(process.execPath, [CLI, 'compare', saved.browser, '--model', SHIRT, '--gate', 'parity'], { encoding: 'utf8' });
  assert.equal(again.status, 0, again.stderr);
});

test('no request left this machine, and nothing was said against the page', () => {
  assert.ok(asked.length > 30);
  assert.deepEqual(
    asked.filter((url) => !/^(http:\/\/127\.0\.0\.1:\d+\/|blob:http:\/\/127\.0\.0\.1:|data:)/.test(url)),
    [],
  );
  assert.deepEqual(said, []);
});

test('the page tells when telar view has ended', async () => {
  const [code, signal] = await view.stop();
  assert.deepEqual([code, signal], [null, 'SIGINT'], 'ended by the signal, as a shell expects');
  await page.keyboard.press('3');
  await page.waitForSelector('body[data-phase=error]');
  assert.match(await page.locator('#alert').textContent(), /it has ended/);
});
