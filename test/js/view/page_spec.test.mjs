import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { strip } from '../api/support/strip.mjs';
import { apart, cameraOf, clickAt, lengthIn, look, marksOf, measured, overlaps, placeOf, rectangleOf, rowsOf, save, seenOn, tool } from './spec_support.mjs';
import { changing, HANGS_AFTER_MS, launchChromium, onRoute, openView, settled, withBody } from './support.mjs';

// A spec made by clicks, in real headless Chromium on the real renderer: a strip of half a metre a side, folded by a right angle at
// x = 0.5, whose node halves it. Each check runs on the sound page, and on one with a fault, which it has to find.

const folder = mkdtempSync(path.join(tmpdir(), 'telar-view-spec-'));
const MODEL = path.join(folder, 'strip.gltf');
const FILE = path.join(folder, 'strip.json');

/** A tenth of a millimetre. */
const EXACT = 1e-4;

const FRONT = { point: [0, 0, 0], normal: [0, 0, 1] };
const SIDE = { point: [0.5, 0, 0], normal: [1, 0, 0] };

const SPEC = {
  header: { style: 'ST-1', sizes: ['M'], baseSize: 'M' },
  views: [
    { name: 'front', view: 'front' },
    { name: 'right', view: 'right' },
  ],
  anchors: { corner: [0, 0, 0] },
  callouts: [{ view: 'front', point: [0.25, 0.5, 0], text: 'Top edge', side: 'left' }],
  measures: [{ code: 'A', description: 'Depth', points: ['corner', [0.5, 0, -0.5]], along: 'surface', tolerance: 0.5, values: { M: 100 } }],
  bill: [{ item: 'Cloth', supplier: 'Mill' }],
};

let view;
let browser;
/** The tab of all checks: each new one has a process of its own. Tabs hold nothing from one page to the next but the files that they have read. */
let page;
const said = [];
before(async () => {
  writeFileSync(MODEL, strip());
  writeFileSync(FILE, `${JSON.stringify(SPEC, null, 2)}\n`);
  const camera = JSON.stringify({ view: 'three-quarter', frame: { node: 'strip' } });
  // None of the checks looks at light, and each page would prefilter an environment.
  const options = ['--size', '128', '--set', `camera=${camera}`, '--set', 'environment=none', '--spec', FILE];
  [view, browser] = await Promise.all([openView(MODEL, options), launchChromium()]);
  page = await browser.newPage();
  page.setDefaultTimeout(30_000);
  page.on('pageerror', (error) => said.push(String(error)));
});
after(async () => {
  await browser?.close();
  await view?.stop();
  rmSync(folder, { recursive: true });
});

const specOf = () => JSON.parse(readFileSync(FILE, 'utf8'));

/** Two places on the one quad and the other. */
const A = [0.1, 0.1, 0];
const B = [0.5, 0.4, -0.3];

async function clicksGiveThePointThatIsSeen(page) {
  const camera = await cameraOf(page);
  await tool(page, 'callout');
  const expected = [
    seenOn(camera, await clickAt(page, placeOf(camera, A)), FRONT),
    // The server's picture takes clicks as well.
    seenOn(camera, await clickAt(page, placeOf(camera, B), '#server-picture'), SIDE),
  ];
  await save(page);
  const added = specOf().callouts.slice(1);
  assert.equal(added.length, 2);
  added.forEach(({ point }, i) => assert.ok(apart(point, expected[i]) < EXACT, `${point}, expected ${expected[i]}`));
  assert.deepEqual(
    added.map((callout) => callout.view),
    ['front', 'front'],
    'the view that looks most as the camera does; of equal ones the first',
  );
}

async function lengthsAreThoseOfTheStrip(page) {
  const camera = await cameraOf(page);
  for (const way of ['straight', 'surface']) {
    await tool(page, way);
    await clickAt(page, placeOf(camera, A));
    assert.match(await page.locator('#tool-hint').textContent(), /where it ends/);
    await clickAt(page, placeOf(camera, B));
    await tool(page, 'turn');
  }
  await measured(page);
  const rows = await rowsOf(page, 'measures');
  assert.deepEqual(
    rows.map(({ code, along }) => [code, along]),
    [
      ['A', 'surface'],
      ['B', 'straight'],
      ['C', 'surface'],
    ],
  );
  await save(page);
  const [, straight, surface] = specOf().measures;
  const [a, b] = straight.points;
  const flat = Math.hypot(0.5 - a[0] - b[2], b[1] - a[1]);
  // The text has a tenth of a centimetre.
  const near = (text, metres) => assert.ok(Math.abs(lengthIn(text) - 1000 * metres) <= 0.5 + 1e-6, `${text}, expected ${metres} m`);
  near(rows[0].length, 1);
  near(rows[1].length, apart(a, b));
  near(rows[2].length, flat);
  assert.ok(flat - apart(a, b) > 0.05, 'the two ways differ by more than a line of text shows');
  // The server's ends of the way are the places that were clicked.
  const answer = await page.evaluate(async (measure) => {
    const body = JSON.stringify({ measure, index: 0 });
    return (await fetch('measure', { method: 'POST', headers: { 'content-type': 'application/json' }, body })).json();
  }, surface);
  assert.ok(apart(answer.path[0], a) < EXACT && apart(answer.path.at(-1), b) < EXACT, JSON.stringify(answer.path));
  assert.ok(Math.abs(answer.millimetres / 1000 - flat) < EXACT, `${answer.millimetres} mm, expected ${flat} m`);
  // Its line is drawn over the fold.
  const fold = [0.5, a[1] + ((b[1] - a[1]) * (0.5 - a[0])) / (0.5 - a[0] - b[2]), 0];
  const { line } = (await marksOf(page)).find(({ label }) => label.startsWith('C'));
  const { width } = await rectangleOf(page);
  const off = Math.min(...line.map((place) => apart(place, placeOf(camera, fold)) * width));
  assert.ok(line.length >= 3 && off < 1, `${off} pixels off the fold`);
}

async function marksFollowTheCamera(page) {
  for (const name of ['front', 'right', 'three-quarter']) {
    await look(page, name);
    const camera = await cameraOf(page);
    for (const picture of ['#client-picture', '#server-picture']) {
      const { width } = await rectangleOf(page, picture);
      const [callout] = await marksOf(page, picture);
      const off = apart(callout.places[0], placeOf(camera, SPEC.callouts[0].point)) * width;
      assert.ok(off < 0.5, `${name}, ${picture}: ${off} pixels off`);
    }
  }
  await page.setViewportSize({ width: 900, height: 800 });
  const camera = await cameraOf(page);
  const [callout] = await marksOf(page);
  assert.ok(apart(callout.places[0], placeOf(camera, SPEC.callouts[0].point)) < 0.01, 'pictures of another size');
}

async function labelsStandApart(page) {
  const camera = await cameraOf(page);
  for (const x of [0.1, 0.4]) {
    await tool(page, 'straight');
    for (const place of [A, [x, 0.4, 0]]) await clickAt(page, placeOf(camera, place));
    await measured(page);
  }
  assert.deepEqual(await overlaps(page), []);
}

async function fieldsAreEditedUndoneAndDeleted(page) {
  const type = async (label, text) => {
    await page.getByLabel(label, { exact: true }).fill(text);
    await page.keyboard.press('Tab');
  };
  await type('Code of point of measure 1', '10.1');
  await type('Description of point of measure 1', 'Depth along the cloth');
  await type('Tolerance, cm of point of measure 1', '0.25');
  await type('M, cm of point of measure 1', '99.5');
  await page.getByLabel('Way of point of measure 1').selectOption('straight');
  await type('Text of call-out 1', 'Raw edge');
  await page.getByLabel('Side of call-out 1').selectOption('');
  await page.getByLabel('View of call-out 1').selectOption('right');
  await page.locator('#stage').focus();
  await page.keyboard.press('c');
  await page.keyboard.press('Enter');
  await page.getByLabel('Delete call-out 2').click();
  assert.equal((await rowsOf(page, 'callouts')).length, 1);
  await page.locator('#stage').focus();
  await page.keyboard.press('Control+z');
  assert.equal((await rowsOf(page, 'callouts')).length, 2, 'what was deleted is back');
  await page.keyboard.press('Control+z');
  assert.equal((await rowsOf(page, 'callouts')).length, 1);
  await save(page);
  const { side: _side, ...callout } = SPEC.callouts[0];
  assert.deepEqual(specOf(), {
    ...SPEC,
    callouts: [{ ...callout, text: 'Raw edge', view: 'right' }],
    measures: [{ ...SPEC.measures[0], code: '10.1', description: 'Depth along the cloth', tolerance: 0.25, values: { M: 99.5 }, along: 'straight' }],
  });
  for (let i = 0; i < 8; i++) await page.locator('#undo').click();
  assert.equal(await page.locator('#undo').isDisabled(), true);
  await save(page);
  assert.equal(readFileSync(FILE, 'utf8'), `${JSON.stringify(SPEC, null, 2)}\n`, 'everything undone, the file is what it was');
}

async function dragsTurnAndMakeNothing(page) {
  await tool(page, 'callout');
  const { x, y, width, height } = await rectangleOf(page);
  await changing(page, async () => {
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x + width / 2 + 40, y + height / 2, { steps: 4 });
    await page.mouse.up();
  });
  assert.equal((await rowsOf(page, 'callouts')).length, 1);
  await clickAt(page, [0.02, 0.02]);
  assert.equal((await rowsOf(page, 'callouts')).length, 1);
  assert.equal(await page.locator('#alert').textContent(), 'There is no garment at this place.');
}

/** Two further places on the strip, and one between A and B. */
const WAY = [A, [0.3, 0.4, 0], [0.5, 0.1, -0.1], B];

async function waysOfManyPointsAreEnded(page) {
  const camera = await cameraOf(page);
  const clickAll = async () => {
    await tool(page, 'surface');
    for (const place of WAY) await clickAt(page, placeOf(camera, place));
  };
  const ends = [
    () => page.keyboard.press('Enter'),
    // A click on the last point again, as the second of a double click is.
    () => clickAt(page, placeOf(camera, B)),
    () => tool(page, 'turn'),
  ];
  for (const end of ends) {
    await clickAll();
    await end();
  }
  await clickAll();
  await page.locator('#stage').focus();
  await page.keyboard.press('Escape');
  await measured(page);
  await save(page);
  const added = specOf().measures.slice(1);
  assert.deepEqual(
    added.map(({ points, along }) => [points.length, along]),
    ends.map(() => [WAY.length, 'surface']),
  );
  for (const { points } of added) points.forEach((point, i) => assert.ok(apart(point, WAY[i]) < 0.01, `${point}, clicked at ${WAY[i]}`));
  // Over the strip laid flat.
  const flat = WAY.map(([x, y, z]) => [x - z, y, 0]);
  const length = flat.slice(1).reduce((sum, point, i) => sum + apart(point, flat[i]), 0);
  const rows = await rowsOf(page, 'measures');
  for (const row of rows.slice(1)) assert.ok(Math.abs(lengthIn(row.length) - 1000 * length) < 8, `${row.length}, expected about ${length} m`);
}

async function whatTheGarmentHidesIsPale(page) {
  const camera = await cameraOf(page);
  await tool(page, 'callout');
  for (const place of [A, B]) await clickAt(page, placeOf(camera, place));
  const hidden = async () => (await marksOf(page)).filter(({ places }) => places.length === 1).flatMap(({ isHidden }) => isHidden);
  // The first call-out is on the upper edge, beside which the other half ends.
  assert.deepEqual((await hidden()).slice(1), [false, false]);
  // From behind and the side the one half stands before the other.
  const behind = { azimuth: 135, elevation: 0, frame: { node: 'strip' } };
  const shot = JSON.stringify({ camera: behind, environment: 'none', size: { width: 128, height: 128 } });
  const apply = (text) => {
    document.querySelector('#shot').value = text;
    document.querySelector('#apply-shot').click();
  };
  await changing(page, () => page.evaluate(apply, shot));
  assert.deepEqual((await hidden()).slice(1), [true, false]);
}

async function aLengthThatComesLeavesTypedText(page) {
  let release;
  const released = new Promise((resolve) => {
    release = resolve;
  });
  await page.route('**/measure', async (route) => {
    await released;
    await route.continue();
  });
  await page.getByLabel('Way of point of measure 1').selectOption('straight');
  await page.getByLabel('Code of point of measure 1').fill('10.1');
  release();
  await measured(page);
  await page.keyboard.press('Tab');
  assert.equal((await rowsOf(page, 'measures'))[0].code, '10.1');
  await save(page);
  assert.equal(specOf().measures[0].code, '10.1');
}

async function refusalsAreTold(page) {
  await page.getByLabel('Tolerance, cm of point of measure 1').fill('-1');
  await page.keyboard.press('Tab');
  await page.locator('#save-spec').click();
  await page.waitForSelector('#alert:not([hidden]), #sheet[data-saved=true]', { timeout: HANGS_AFTER_MS });
  assert.match((await page.locator('#alert').textContent()) ?? '', /spec\.measures\[0\]\.tolerance: expected .*got -1 \[E_SPEC\]/);
  assert.equal(readFileSync(FILE, 'utf8'), `${JSON.stringify(SPEC, null, 2)}\n`);
  assert.equal(await page.locator('#save-spec').isEnabled(), true);
}

/** A check, and a fault that it has to find: of the page's own code before it runs, or of its requests. */
const CHECKS = [
  {
    check: clicksGiveThePointThatIsSeen,
    fault: 'a click that counts from the frame of the picture, one pixel off',
    plant: (page) =>
      page.addInitScript(() => {
        const original = HTMLCanvasElement.prototype.getBoundingClientRect;
        HTMLCanvasElement.prototype.getBoundingClientRect = function () {
          const { left, top, width, height } = original.call(this);
          return new DOMRect(left - 1, top, width, height);
        };
      }),
  },
  {
    check: lengthsAreThoseOfTheStrip,
    fault: 'every way measured straight',
    plant: onRoute(
      'measure',
      withBody(({ measure }) => {
        measure.along = 'straight';
      }),
    ),
  },
  {
    check: marksFollowTheCamera,
    fault: 'marks that are drawn once',
    plant: (page) =>
      page.addInitScript(() => {
        const original = SVGElement.prototype.replaceChildren;
        SVGElement.prototype.replaceChildren = function (...nodes) {
          if (this.childNodes.length === 0) original.apply(this, nodes);
        };
      }),
  },
  {
    check: labelsStandApart,
    fault: 'labels without a width',
    plant: (page) =>
      page.addInitScript(() => {
        SVGTextContentElement.prototype.getComputedTextLength = () => 0;
      }),
  },
  {
    check: fieldsAreEditedUndoneAndDeleted,
    fault: 'a save that loses the tolerance',
    plant: onRoute(
      'spec',
      withBody(({ measures }) => {
        for (const measure of measures) delete measure.tolerance;
      }),
    ),
  },
  {
    check: dragsTurnAndMakeNothing,
    fault: 'a drag that counts as a click',
    plant: (page) =>
      page.addInitScript(() => {
        const original = Math.hypot;
        Math.hypot = (...parts) => (parts.length === 2 ? 0 : original(...parts));
      }),
  },
  {
    check: waysOfManyPointsAreEnded,
    fault: 'a server that measures from the first point to the last',
    plant: onRoute(
      'measure',
      withBody(({ measure }) => {
        measure.points = [measure.points[0], measure.points.at(-1)];
      }),
    ),
  },
  {
    check: whatTheGarmentHidesIsPale,
    fault: 'a garment that is nowhere',
    plant: (page) => page.addInitScript(() => (WebGL2RenderingContext.prototype.readPixels = () => {})),
  },
  {
    check: aLengthThatComesLeavesTypedText,
    fault: 'a page that does not hear what is typed',
    plant: (page) => page.addInitScript(() => addEventListener('input', (event) => event.stopImmediatePropagation(), true)),
  },
  {
    check: refusalsAreTold,
    fault: 'a server that takes everything',
    plant: onRoute('spec', (route) => route.fulfill({ json: { version: 'x' } })),
  },
];

for (const { check, fault, plant } of CHECKS) {
  const run = async (prepare) => {
    writeFileSync(FILE, `${JSON.stringify(SPEC, null, 2)}\n`);
    said.length = 0;
    await page.setViewportSize({ width: 1280, height: 900 });
    const planted = await prepare?.(page);
    try {
      await page.goto(view.url);
      await settled(page);
      await check(page);
      assert.deepEqual(said, []);
    } finally {
      await planted?.dispose();
      await page.unrouteAll({ behavior: 'ignoreErrors' });
    }
  };
  test(`${check.name.replaceAll(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`)}`, () => run());
  test(`planted fault: ${fault}`, () => assert.rejects(run(plant), assert.AssertionError));
}
