import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { fromControls, orbited, withFit, withFovY, withModelCamera, withProjection, withView } from '../../../js/view/page/camera_edit.mjs';
import { straightPixels, scaledDifference } from '../../../js/view/page/pixels.mjs';
import { shotDifferences } from '../../../js/view/page/shot_differences.mjs';
import { premultiply } from '../../../js/compare/image.mjs';

const FACTS = { min: [-0.4, 0, -0.2], max: [0.4, 1, 0.2] };
const resolved = (camera) => resolveShot({ camera }, FACTS).camera;
const near = (a, b) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < 1e-9, `${a} against ${b}`));

test('a view keeps projection, lens and fit of the camera before it', () => {
  const camera = { view: 'front', fovY: 40, fit: 0.7 };
  assert.deepEqual(withView(camera, resolved(camera), 'back'), { view: 'back', projection: 'perspective', fovY: 40, fit: 0.7 });
  const shared = { view: 'front', frame: 'model', fitTo: 'all' };
  assert.deepEqual(withView(shared, resolved(shared), 'top'), { view: 'top', projection: 'perspective', fovY: 30, frame: 'model', fitTo: 'all' });
  const orthographic = { view: 'left', projection: 'orthographic' };
  assert.deepEqual(withView(orthographic, resolved(orthographic), 'top'), { view: 'top', projection: 'orthographic' });
  assert.deepEqual(withView(undefined, resolved(undefined), 'front'), { view: 'front', projection: 'perspective', fovY: 30 });
});

test('turning by a quarter leads from the front to the right', () => {
  const { position, target } = resolved({ view: 'front' });
  const distance = position[2] - target[2];
  const camera = orbited(resolved({ view: 'front' }), { turn: 90 });
  near(camera.position, [target[0] + distance, target[1], target[2]]);
  near(camera.target, target);
  assert.equal(resolved(camera).fovY, 30);
});

test('tilting stops short of the pole, and leaves it upright', () => {
  const { position, target, up } = resolved(orbited(resolved({ view: 'front' }), { tilt: 500 }));
  const offset = position.map((p, i) => p - target[i]);
  assert.ok(offset[1] / Math.hypot(...offset) < 1 && offset[2] > 0, 'still in front');
  assert.deepEqual(up, [0, 1, 0]);
});

test('from the top the front stays below, so that tilting down leads to the front', () => {
  const top = resolved({ view: 'top' });
  const camera = orbited(top, { tilt: -90 });
  const [x, y, z] = camera.position.map((p, i) => p - camera.target[i]);
  assert.ok(Math.abs(x) < 1e-9 && Math.abs(y) < 1e-9, `${x} ${y}`);
  assert.ok(Math.abs(z - (top.position[1] - top.target[1])) < 1e-9);
});

test('nearer means a shorter way in perspective, a smaller height without', () => {
  const perspective = resolved({ view: 'front' });
  const way = ({ position, target }) => Math.hypot(...position.map((p, i) => p - target[i]));
  assert.ok(Math.abs(way(orbited(perspective, { zoom: 2 })) - way(perspective) / 2) < 1e-12);
  const flat = resolved({ view: 'front', projection: 'orthographic' });
  const closer = orbited(flat, { zoom: 2 });
  assert.equal(closer.height, flat.height / 2);
  near(closer.position, flat.position);
});

test('a placed camera changes projection about its target, which keeps its size', () => {
  const camera = { position: [0, 0.5, 2], target: [0, 0.5, 0], fovY: 60 };
  const flat = withProjection(camera, resolved(camera), 'orthographic');
  assert.ok(Math.abs(flat.height - 2 * 2 * Math.tan(Math.PI / 6)) < 1e-12);
  const back = withProjection(flat, resolved(flat), 'perspective');
  assert.ok(Math.abs(back.fovY - 60) < 1e-9);
  assert.equal(withProjection(camera, resolved(camera), 'perspective'), camera);
  assert.deepEqual(withProjection({ view: 'back', fovY: 20 }, resolved({ view: 'back', fovY: 20 }), 'orthographic'), {
    view: 'back',
    projection: 'orthographic',
  });
});

test('field of view, fit and cameras of the model', () => {
  assert.deepEqual(withFovY({ view: 'back' }, resolved({ view: 'back' }), 50), { view: 'back', fovY: 50 });
  const placed = { position: [0, 0.5, 2], target: [0, 0.5, 0] };
  assert.equal(resolved(withFovY(placed, resolved(placed), 50)).fovY, 50);
  assert.deepEqual(withFit(undefined, 0.5), { fit: 0.5 });
  assert.deepEqual(withModelCamera(1), { gltf: 1 });
});

test('a drag of an orthographic camera zooms by its height', () => {
  const flat = resolved({ view: 'front', projection: 'orthographic' });
  const camera = fromControls(flat, { position: { toArray: () => [1, 2, 3] }, target: { toArray: () => [0, 0, 0] }, zoom: 4 });
  assert.deepEqual(camera, { projection: 'orthographic', height: flat.height / 4, position: [1, 2, 3], target: [0, 0, 0] });
});

test('straight alpha gives the premultiplied bytes back, rows from the top', () => {
  const buffer = new Uint8Array(256 * 4 * 2);
  for (let alpha = 0; alpha < 256; alpha++) {
    const at = (256 + alpha) * 4; // the buffer's second row is the picture's first
    buffer.set([alpha, Math.floor(alpha / 3), Math.min(alpha, 7), alpha], at);
  }
  const straight = straightPixels(buffer, 256, 2);
  assert.deepEqual(premultiply(straight).subarray(0, 1024), buffer.subarray(1024));
  assert.ok(straight.subarray(1024).every((byte) => byte === 0));
});

test('differences show sixteenfold, those of alpha in every channel', () => {
  const image = (...data) => ({ width: data.length / 4, height: 1, data: Uint8Array.from(data) });
  const difference = scaledDifference(image(10, 20, 30, 255, 9, 9, 9, 0, 50, 0, 0, 255), image(11, 18, 30, 255, 0, 0, 0, 2, 0, 0, 0, 255));
  assert.deepEqual([...difference], [16, 32, 0, 255, 32, 32, 32, 255, 255, 0, 0, 255]);
});

test('differences of resolved shots are named, those of rounding and of the file are not', () => {
  const shot = { exposure: 1, camera: { position: [0, 1, 2] }, lights: [{ type: 'ambient' }], output: { format: 'png' } };
  const other = { exposure: 1.5, camera: { position: [5e-8, 1 + 1e-7, 2.1] }, lights: [], output: { format: 'raw' } };
  assert.deepEqual(shotDifferences(shot, { ...shot, output: undefined }), []);
  assert.deepEqual(shotDifferences(shot, other), [
    { path: 'exposure', ours: '1', theirs: '1.5' },
    { path: 'camera.position[2]', ours: '2', theirs: '2.1' },
    { path: 'lights[0]', ours: '{"type":"ambient"}', theirs: undefined },
  ]);
});
