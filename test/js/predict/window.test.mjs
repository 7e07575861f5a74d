import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { windowCamera, windowOf } from '../../../js/predict/window.mjs';

const SIZE = { width: 400, height: 300 };
const WINDOW = { x: 260, y: 40, width: 60, height: 60 };

const sub = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (v) => v.map((x) => x / Math.hypot(...v));

/** Pixel of a point, from the top left corner. */
function projected(camera, { width, height }, point) {
  const forward = unit(sub(camera.target, camera.position));
  const right = unit(cross(forward, camera.up));
  const above = cross(right, forward);
  const to = sub(point, camera.position);
  const half = camera.projection === 'orthographic' ? camera.height / 2 : Math.tan((camera.fovY * Math.PI) / 360) * dot(to, forward);
  return [width / 2 + (dot(to, right) / half) * (height / 2), height / 2 - (dot(to, above) / half) * (height / 2)];
}

const box = { min: [-0.4, -0.5, -0.3], max: [0.4, 0.5, 0.3] };
const cameraOf = (camera) => resolveShot({ size: SIZE, camera }, box).camera;

/** How far a window's pixels are from where the whole picture has them, in pixels. */
function apart(camera, window) {
  const shown = windowCamera(camera, SIZE, window);
  const points = [
    [0.1, 0.3, 0.1],
    [0.2, 0.25, -0.1],
    [0.15, 0.33, 0.2],
  ].filter((point) => {
    const [x, y] = projected(camera, SIZE, point);
    return Math.abs(x - window.x - window.width / 2) < window.width && Math.abs(y - window.y - window.height / 2) < window.height;
  });
  assert.ok(points.length > 0, 'a point lies in the window');
  return Math.max(
    ...points.map((point) => {
      const [x, y] = projected(camera, SIZE, point);
      const [u, v] = projected(shown, window, point);
      return Math.hypot(x - window.x - u, y - window.y - v);
    }),
  );
}

test('a window shows its part of the picture at the same scale', () => {
  const orthographic = cameraOf({ azimuth: 20, elevation: 10, projection: 'orthographic' });
  const perspective = cameraOf({ azimuth: 20, elevation: 10, fovY: 20 });
  for (const point of [[0.15, 0.3, 0.1]]) {
    const around = (camera) => {
      const [x, y] = projected(camera, SIZE, point);
      return { x: Math.round(x) - 30, y: Math.round(y) - 30, width: 60, height: 60 };
    };
    assert.ok(apart(orthographic, around(orthographic)) < 1e-9);
    // The axis is turned by some degrees: a pixel off at most over a window of 60.
    assert.ok(apart(perspective, around(perspective)) < 1);
    const fault = { ...around(perspective), y: 300 - around(perspective).y - 60 };
    assert.ok(Math.abs(fault.y - around(perspective).y) > 60, 'planted fault: up and down taken for each other');
    const shown = windowCamera(perspective, SIZE, fault);
    const [, v] = projected(shown, fault, point);
    assert.ok(v < 0 || v > 60);
  }
});

test('everything of the model stays between the planes of a window', () => {
  const camera = cameraOf({ azimuth: 20, elevation: 10, fovY: 60 });
  const shown = windowCamera(camera, SIZE, { ...WINDOW, x: 340, y: 0 });
  const forward = unit(sub(shown.target, shown.position));
  for (const x of [0, 1]) {
    for (const y of [0, 1]) {
      for (const z of [0, 1]) {
        const corner = [x ? box.max[0] : box.min[0], y ? box.max[1] : box.min[1], z ? box.max[2] : box.min[2]];
        const depth = dot(sub(corner, shown.position), forward);
        assert.ok(depth > shown.near && depth < shown.far, `${corner}: ${depth} in ${shown.near}, ${shown.far}`);
      }
    }
  }
});

test('the window lies where the model covers most of it and its outline is seen', () => {
  const [width, height] = [100, 80];
  const data = new Uint8Array(width * height * 4);
  const fill = (left, top, right, bottom) => {
    for (let y = top; y < bottom; y++) for (let x = left; x < right; x++) data[(y * width + x) * 4 + 3] = 255;
  };
  fill(50, 20, 100, 80);
  const found = windowOf(data, { width, height }, 40);
  assert.deepEqual([found.width, found.height], [40, 40]);
  assert.ok(Math.abs(found.coverage - 0.8) <= 0.21, JSON.stringify(found));
  assert.deepEqual(windowOf(data, { width, height }, 400), { x: 0, y: 0, width, height, coverage: (50 * 60) / (width * height) });
});
