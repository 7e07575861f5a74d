import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import sharp from 'sharp';
import { animateWebp, createRenderer } from '../../../js/index.mjs';
import { resolveShot, turntable } from '../../../js/shot/index.mjs';
import { sphereAndSlope } from './support/layer_scenes.mjs';
import './support/real.mjs';

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  model = await renderer.load(await sphereAndSlope());
});
after(() => renderer.close());

test('frames are in order, named by degrees, evenly spaced from the own view on', () => {
  const frames = turntable({ camera: { view: 'right', fit: 0.8 }, variant: 'x' }, 8);
  assert.deepEqual(
    frames.map(({ name }) => name),
    ['side-000', 'side-045', 'side-090', 'side-135', 'side-180', 'side-225', 'side-270', 'side-315'],
  );
  assert.deepEqual(frames[3].shot, { camera: { fit: 0.8, azimuth: 225, elevation: 0, fitTo: 'turntable' }, variant: 'x' });
  assert.equal(turntable({}, 16)[1].name, 'side-022.5');
});

test('all frames have one scale, and the model turns about one axis', async () => {
  const frames = turntable({ size: { width: 80, height: 80 }, camera: { projection: 'orthographic' }, output: { format: 'raw' } }, 6);
  const drawn = await renderer.renderAll(
    model,
    frames.map(({ shot }) => shot),
  );
  const scales = drawn.map(({ info }) => info.millimetresPerPixel);
  assert.equal(new Set(scales).size, 1);
  const { min, max } = model.facts.bounds;
  const middle = min.map((low, i) => (low + max[i]) / 2);
  const axis = drawn.map(({ info: { worldToPixel: m } }) => [0, 1].map((row) => middle.reduce((sum, x, i) => sum + m[4 * i + row] * x, m[12 + row])));
  for (const [x, y] of axis) assert.ok(Math.abs(x - axis[0][0]) < 1e-9 && Math.abs(y - axis[0][1]) < 1e-9, `${x} ${y}`);
  assert.ok(
    drawn.every(({ data }, i) => i === 0 || !data.equals(drawn[0].data)),
    'and no two are alike',
  );
});

for (const quality of [100, 80]) {
  test(`an animation of quality ${quality} keeps every frame`, async () => {
    const shots = turntable({ size: { width: 50, height: 40 }, output: { format: 'webp', quality } }, 5).map(({ shot }) => shot);
    const stills = (await renderer.renderAll(model, shots)).map(({ data }) => data);
    const file = animateWebp(stills, { frameMs: 80, loops: 3 });
    const { pages, delay, loop, width, pageHeight } = await sharp(file, { animated: true }).metadata();
    assert.deepEqual({ pages, delay, loop, width, pageHeight }, { pages: 5, delay: Array(5).fill(80), loop: 3, width: 50, pageHeight: 40 });
    for (const [page, still] of stills.entries()) {
      const [inFile, alone] = await Promise.all([sharp(file, { page }).ensureAlpha().raw().toBuffer(), sharp(still).ensureAlpha().raw().toBuffer()]);
      assert.ok(inFile.equals(alone), `frame ${page}`);
      const other = await sharp(stills[(page + 1) % 5])
        .ensureAlpha()
        .raw()
        .toBuffer();
      assert.ok(!inFile.equals(other), 'another frame is another picture');
    }
  });
}

test('what is no frame is refused by its place', async () => {
  const still = (size) => renderer.render(model, { size: { width: size, height: 40 }, output: { format: 'webp' } }).then(({ data }) => data);
  const [one, other] = await Promise.all([still(50), still(51)]);
  assert.throws(() => animateWebp([one, other]), { code: 'E_OPTION', message: /^frames\[1\]: expected 50 x 40 pixels, as the first frame/ });
  assert.throws(() => animateWebp([one, one.subarray(0, 60)]), { code: 'E_OPTION', message: /^frames\[1\]: expected a whole WebP file/ });
  assert.throws(() => animateWebp([Buffer.from('GIF89a')]), { code: 'E_OPTION', message: /^frames\[0\]: expected a WebP file/ });
  const animation = animateWebp([one, one]);
  const moving = { code: 'E_OPTION', message: 'frames[1]: expected a still WebP picture, got "a file without one"' };
  assert.throws(() => animateWebp([one, animation]), moving);
  const extended = await sharp(one)
    .withMetadata({ exif: { IFD0: { Copyright: 'telar' } } })
    .webp({ lossless: true })
    .toBuffer();
  assert.equal(extended.toString('latin1', 12, 16), 'VP8X');
  assert.equal((await sharp(animateWebp([one, extended]), { animated: true }).metadata()).pages, 2, 'a still one with more than its picture');
  for (const name of ['VP8 ', 'VP8L', 'VP8X']) {
    const empty = Buffer.from(`RIFF\x0c\0\0\0WEBP${name}\0\0\0\0`, 'latin1');
    assert.throws(() => animateWebp([empty]), { code: 'E_OPTION', message: /^frames\[0\]: expected a still WebP picture/ }, name);
  }
  assert.throws(() => animateWebp([]), { code: 'E_OPTION' });
});

test('frames of a look share one exposure: none is metered by itself', () => {
  const shots = turntable({ look: 'catalogue' }, 6).map(({ shot }) => resolveShot(shot, { min: [-0.4, 0, -0.2], max: [0.4, 0.8, 0.2] }));
  assert.deepEqual([...new Set(shots.map(({ metering, exposure }) => `${metering} ${exposure}`))], ['null 1']);
});
