import assert from 'node:assert/strict';
import { test } from 'node:test';
import { difference } from './metrics.mjs';
import { rasterizerDistances } from './rasterizers.mjs';
import { figuresText, reportPage } from './report_page.mjs';

const SIZE = 32;

/** Opaque grey square within a transparent frame; `change` writes into it. */
function picture(change = () => {}) {
  const pixels = new Uint8Array(SIZE * SIZE * 4);
  for (let y = 4; y < 28; y++) for (let x = 4; x < 28; x++) pixels.set([100, 100, 100, 255], (y * SIZE + x) * 4);
  change(pixels, (x, y) => (y * SIZE + x) * 4);
  return pixels;
}

const pictures = (actual) => ({ expected: picture(), actual, mask: picture(), width: SIZE, height: SIZE, background: false });

test('telar may be a tenth farther from the client on the other rasteriser than the client itself', () => {
  /** 20 interior pixels of 400 off by 10. */
  const other = picture((pixels, at) => {
    for (let x = 6; x < 26; x++) pixels[at(x, 10)] = 110;
  });
  const offBy = (more) =>
    picture((pixels, at) => {
      for (let x = 6; x < 26; x++) pixels[at(x, 10)] = 100 - more;
    });
  const judged = (actual) => rasterizerDistances(pictures(actual), other);
  const same = judged(picture());
  assert.deepEqual([same.client.mean, same.telar.mean, same.client.p999, same.pass], [0.5, 0.5, 10, true]);
  assert.deepEqual([judged(offBy(1)).telar.p999, judged(offBy(1)).pass], [11, true]);
  assert.equal(judged(offBy(2)).pass, false, 'p99.9 of 12 is above 11');
  const spread = picture((pixels, at) => {
    for (let y = 12; y < 17; y++) for (let x = 6; x < 26; x++) pixels[at(x, y)] = 101;
  });
  assert.deepEqual([judged(spread).telar.p999, judged(spread).telar.mean, judged(spread).pass], [10, 0.75, false]);
});

const row = (name, actual, more) => {
  const found = difference(pictures(actual));
  return { name, pass: found.pass, difference: found, ...more };
};
const wrong = picture((pixels, at) => pixels.set([200, 100, 100, 255], at(12, 13)));
const page = (rows) =>
  reportPage(rows, {
    summary: '2 cases',
    knownDifferences: [{ name: 'sheen < 0', three: 'NaN', telar: 'finite', source: 'sheen.glsl', cases: ['known'] }],
    knownRows: [{ name: 'known', pass: true }],
  });

test('a line of figures names what is over the bar', () => {
  assert.match(
    figuresText(row('a', wrong)),
    /^interior 400 px max 100 at 12 13 p99\.9 100 .*OVER: interior max 100\/255, at most 2\/255 \| OVER: interior p99\.9/,
  );
  assert.doesNotMatch(figuresText(row('a', picture())), /OVER/);
});

test('the page: those over the bar first, their pixel traced, and nothing from a network', () => {
  const trace = {
    pixel: [12, 13],
    cause: 'f0 < is the first',
    first: 'f0',
    terms: [
      { term: 'n', browser: [0, 0, 1], telar: [0, 0, 1], difference: 0, differs: false },
      { term: 'f0', browser: [0.04, 0.04, 0.04], telar: null, difference: Infinity, differs: true },
      { term: 'unused', browser: null, telar: null, difference: 0, differs: false },
    ],
  };
  const html = page([row('good', picture()), row('bad', wrong, { trace }), { name: 'gone', pass: false, error: 'Error: <lost>' }]);
  assert.deepEqual(
    [...html.matchAll(/<h2 id="case-(\w+)" class="(\w+)"/g)].map(([, name, pass]) => [name, pass]),
    [
      ['bad', 'over'],
      ['gone', 'over'],
      ['good', 'within'],
    ],
  );
  assert.match(html, /Pixel 12 13 through both shaders: f0 &#60; is the first/);
  assert.match(html, /<tr class="over"><th scope="row">f0<\/th><td>0\.04 0\.04 0\.04<\/td><td><\/td>/);
  assert.ok(!html.includes('unused') && html.includes('&#60;lost&#62;') && html.includes('sheen &#60; 0'));
  assert.doesNotMatch(html, /<script|https?:|src="\//);
  assert.deepEqual([...html.matchAll(/src="([^"]+)"/g)].map(([, file]) => file).slice(0, 3), [
    'pictures/bad.browser.png',
    'pictures/bad.telar.png',
    'pictures/bad.difference.png',
  ]);
  assert.ok(html.includes('src="pictures/known.telar.png"'));
  for (const [, id] of html.matchAll(/href="#([^"]+)"/g)) assert.ok(html.includes(`id="${id}"`), id);
});
