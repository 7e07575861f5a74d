import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { FORMATS } from '../../../js/shot/table/output.mjs';
import { TONE_MAPPINGS } from '../../../js/shot/table/tone_mappings.mjs';
import { SHOT, model, openRenderer } from './support/double.mjs';

let renderer;
before(async () => {
  renderer = await openRenderer();
});
after(() => renderer.close());

test('info of a frame', async () => {
  const { data, info } = await renderer.render(model({ loadMs: 20, drawMs: 30, encodeMs: 10 }), SHOT);
  assert.ok(Buffer.isBuffer(data));
  assert.deepEqual([info.width, info.height, info.format, info.backend], [4, 2, 'png', 'double']);
  assert.deepEqual(info.gl, { vendor: 'telar', renderer: 'none', version: '0' });
  assert.deepEqual([info.features, info.passes], [[], ['wait']]);
  assert.deepEqual(info.warnings, [{ code: 'W_IMAGE', message: 'from the model' }]);
  const { load, resolve, queue, draw, encode, total } = info.milliseconds;
  assert.ok(load >= 20 && draw >= 30 && encode >= 10 && resolve >= 0 && queue >= 0);
  assert.ok(total >= load + draw + encode);
  assert.ok(info.peakBytes > 1e7 && info.peakBytes < 1e10);
  assert.deepEqual(resolveShot(info.shot), info.shot, 'every default is written out');
});

test('renderAll keeps the order, and decodes a source once', async () => {
  const sizes = [8, 2, 6, 4, 1];
  const views = await renderer.renderAll(
    model({ loadMs: 30 }),
    sizes.map((width) => ({ size: { width, height: 1 } })),
  );
  assert.deepEqual(
    views.map(({ info }) => info.width),
    sizes,
  );
  assert.ok(views.every(({ info }) => info.milliseconds.load < 5));
  assert.deepEqual(await renderer.renderAll(model(), []), []);
});

test('what was drawn once is freed, a loaded model is kept until it is released', async () => {
  assert.equal(await renderer.liveObjects(), 0);
  const loaded = await renderer.load(model());
  await renderer.render(loaded, SHOT);
  assert.equal(await renderer.liveObjects(), 1);
  await renderer.release(loaded);
  assert.equal(await renderer.liveObjects(), 0);
});

const ROOM = [
  { type: 'ambient', color: 'tomato' },
  { type: 'hemisphere', groundColor: '#123' },
  { type: 'directional', intensity: 3 },
  { type: 'point', position: [1, 2, 3], range: 4 },
  { type: 'spot', position: [0, 3, 0], angle: 0.4, penumbra: 1 },
];
const SHOTS = [
  {},
  { lights: ROOM, modelLights: false },
  { background: 'rebeccapurple' },
  { background: 'environment', environment: { rotation: -30 } },
  { environment: 'none', toneMapping: 'none', exposure: 0 },
  { environment: 'a/b.EXR' },
  { environment: new Uint8Array(3) },
  { camera: { projection: 'orthographic', view: 'bottom' } },
  { quality: 'draft' },
  { quality: { samples: 4 } },
  { camera: { position: [0, 0, 9], target: [0, 0, 0], height: 3, near: -2, far: 20 } },
  { shading: 'three', layers: ['beauty'] },
  ...Object.keys(TONE_MAPPINGS).map((toneMapping) => ({ toneMapping })),
  ...Object.keys(FORMATS).map((format) => ({ output: { format } })),
  { output: { bitDepth: 16, ppi: 300, icc: true } },
  { output: { format: 'exr', bitDepth: 32 } },
  { output: { format: 'raw', bitDepth: 32 } },
];
for (const shot of SHOTS) {
  test(`native code takes what resolveShot makes of ${JSON.stringify(shot).slice(0, 80)}`, async () => {
    const { info } = await renderer.render(model(), { ...SHOT, ...shot });
    assert.equal(info.format, shot.output?.format ?? 'png');
  });
}
