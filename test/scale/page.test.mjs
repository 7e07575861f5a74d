import assert from 'node:assert/strict';
import { test } from 'node:test';
import { coresFor, priceOfMillion, scalePage } from './page.mjs';

const SETTINGS = { price: 0.04, busy: 0.5, command: 'npm run scale' };
const SHIRT = { mib: 250, bytes: 131_072 };
const times = (wall, cpu) => ({ wall, cpu });
const side = (renderer, version, rate) => ({
  gl: { renderer, version },
  starts: [
    { sinceStart: 2 * rate, compile: 50, memory: { VmHWM: rate } },
    { sinceStart: rate, compile: 5, memory: { VmHWM: rate } },
  ],
  rate: { workers: 4, rate, cores: 3.6 },
});
const GPU = {
  machine: { cores: 4, cpu: 'a processor', node: '20.0.0' },
  here: side('a card/PCIe', 'OpenGL ES 3.2 of it', 300),
  llvmpipe: side('llvmpipe', 'OpenGL ES 3.2 Mesa 22.3.6', 100),
  pictures: [
    {
      name: 'shirt',
      file: { here: times(40, 50), llvmpipe: times(100, 150) },
      kept: { here: times(9.96, 5), llvmpipe: times(70, 140) },
      stages: { draw: 0.7, read: 1.5, encode: 6 },
      max: 5,
      mean: 1.06,
      flip: 0.0304,
      gates: ['other-gl'],
    },
  ],
  cases: { drawn: 900, within: { parity: 150, 'other-gl': 899 }, flip: { median: 0.01, ninetyFive: 0.03 }, failed: [], beyond: ['lines'] },
  telarDraw: { asIs: 2.5, buffer: 56.3, hidden: 22.9, large: { draw: 4.3, between: 25.1 } },
};
const line = { fixed: 12, each: 3.1449, r2: 0.99987 };
const TOLD = {
  gpu: GPU,
  machine: { cores: 2, cpu: 'a processor', gl: 'Mesa 22.3.6 llvmpipe', node: '20.0.0', load: 0.1, runs: 9 },
  pictures: { shirt: SHIRT, 'shirt, 256 x 256': { mib: 240, bytes: 30_000 } },
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

test('a GPU has its figures beside those of llvmpipe on the same cores', () => {
  assert.match(page(), /^\| shirt \| 40, 50 ms \| 100, 150 ms \| 10\.0, 5\.0 ms \| 70, 140 ms \| 5, 1\.1 \| 0\.030 \| other-gl \|$/m);
  assert.match(page(), /on a card, OpenGL ES 3\.2 of it, with 4 cores/);
  assert.match(page(), /4 workers draws 300 of it a second from its file, 100 by llvmpipe, with 4 cores busy/);
  assert.match(page(), /900 cases of the parity gate were drawn by it, none with an error .*: 150 are within `parity`\n {2}of llvmpipe, 899 within `other-gl`/);
  const failed = { ...TOLD, gpu: { ...GPU, cases: { ...GPU.cases, failed: [{ name: 'a', error: 'X_GL' }] } } };
  assert.match(page(failed), /drawn by it, 1 with an error \(/);
  const none = { ...TOLD, gpu: { ...GPU, pictures: [{ ...GPU.pictures[0], gates: [] }] } };
  assert.match(page(none), /^\| shirt .* \| none \|$/m);
});

test('growth has the fit, and a busy machine is told', () => {
  assert.match(page(), /^\| megapixel \| 3\.14 ms \| 3\.14 MiB \| 12 ms, 12 MiB \| 0\.9999, 0\.9999 \| 16\.7: 900 ms, 2\.0 GiB \|$/m);
  const flat = { ...TOLD, growth: [{ ...TOLD.growth[0], mib: { fixed: 120, each: 0.03, r2: 0.7 } }] };
  assert.match(page(flat), /^\| megapixel \| 3\.14 ms \| none \| 12 ms, 120 MiB \| 0\.9999, - \|/m, 'noise is no growth');
  assert.doesNotMatch(page(), /other work/);
  assert.match(page({ ...TOLD, machine: { ...TOLD.machine, load: 7 } }), /load of the machine\nat the start 7\.0, so that other work was there/);
});
