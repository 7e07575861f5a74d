import assert from 'node:assert/strict';
import { test } from 'node:test';
import { coresFor, priceOfMillion, scalePage } from './page.mjs';

const SETTINGS = { price: 0.04, busy: 0.5, command: 'npm run scale' };
const SHIRT = { cpu: 100, after: 5, redrawn: 70, mib: 250, bytes: 131_072, covered: 50_000 };
const line = { fixed: 12, each: 3.1449, r2: 0.99987 };
const TOLD = {
  machine: { cores: 2, cpu: 'a processor', gl: 'Mesa 22.3.6 llvmpipe', node: '20.0.0', load: 0.1, runs: 9 },
  pictures: { shirt: SHIRT, 'shirt, 256 x 256': { cpu: 40, after: 2, mib: 240, bytes: 30_000, covered: 12_000 } },
  peers: {
    pictures: [
      { name: 'shirt', telar: { cpu: 100, wall: 60 }, browser: { cpu: 400, wall: 300 } },
      { name: 'shirt, 256 x 256', telar: { cpu: 40, wall: 30 }, browser: { cpu: 80, wall: 90 } },
      { name: 'from the start', telar: { cpu: 500, wall: 400 }, browser: { cpu: 3000, wall: 2000 } },
    ],
    mebibytes: { telar: 300, browser: 600 },
  },
  growth: [{ axis: 'pixels', unit: 'megapixel', cpu: line, mib: line, points: [{ count: 16.7, cpu: 900, mib: 2048 }] }],
};
const page = (told = TOLD, settings = SETTINGS) => scalePage(told, settings);

test('cores and price follow from CPU time, the part that is busy, and the price', () => {
  assert.equal(coresFor(100, 100, 0.5), 20);
  assert.ok(Math.abs(priceOfMillion(100, SETTINGS) - 2.2222) < 1e-4);
  assert.match(page(), /^\| 100 \| telar \| 20 \| 5\.9 GiB \| 1 \|$/m);
  assert.match(page(), /^\| 10,000 \| Chromium \| 8,000 \| 4,688 GiB \| 125 \|$/m);
  assert.match(page(), /^\| 1 \| telar \| 0\.2 \| 300 MiB \| 1 \|$/m);
  assert.match(page(), /^\| shirt \| 2\.22 \| 8\.89 \| 6\.67 \|$/m);
  // Planted: cores that are never idle, and another price.
  assert.doesNotMatch(page(TOLD, { ...SETTINGS, busy: 1 }), /^\| 100 \| telar \| 20 \|/m);
  assert.doesNotMatch(page(TOLD, { ...SETTINGS, price: 0.05 }), /^\| shirt \| 2\.22 /m);
});

test('ratios are of the pictures that are drawn again', () => {
  assert.match(page(), /^\| shirt \| 100 ms \| 250 MiB \| 131,072 \| 400 ms \| 4\.0 \| 60 ms \| 300 ms \|$/m);
  assert.match(page(), /drawn again, mean: 3\.0\./);
  assert.match(page(), /1\.2 GiB of pictures leave each second/);
});

test('a GPU leaves what does not depend on pixels', () => {
  assert.match(page(), /^\| shirt \| 50,000 \| 100 ms \| 65 ms \| 35 ms \| 2\.9 \|$/m);
  assert.match(page(), /takes 0\.2 ms for/);
  assert.match(page(), /100 of the first picture a second still take 7\.0 of\nthem in place of 20\./);
  const slower = { ...TOLD, pictures: { ...TOLD.pictures, shirt: { ...SHIRT, redrawn: 4 } } };
  assert.match(page(slower), /^\| shirt \| 50,000 \| 100 ms \| 0 ms \| 100 ms \| 1\.0 \|$/m, 'never less than nothing');
});

test('growth has the fit, and a busy machine is told', () => {
  assert.match(page(), /^\| megapixel \| 3\.14 ms \| 3\.14 MiB \| 12 ms, 12 MiB \| 0\.9999, 0\.9999 \| 16\.7: 900 ms, 2\.0 GiB \|$/m);
  const flat = { ...TOLD, growth: [{ ...TOLD.growth[0], mib: { fixed: 120, each: 0.03, r2: 0.7 } }] };
  assert.match(page(flat), /^\| megapixel \| 3\.14 ms \| none \| 12 ms, 120 MiB \| 0\.9999, - \|/m, 'noise is no growth');
  assert.doesNotMatch(page(), /other work/);
  assert.match(page({ ...TOLD, machine: { ...TOLD.machine, load: 7 } }), /load of the machine\nat the start 7\.0, so that other work was there/);
});
