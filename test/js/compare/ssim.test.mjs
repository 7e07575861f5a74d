import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ssim } from '../../../js/compare/ssim.mjs';
import { draw, flat, noise, withPixel } from './support.mjs';

const of = (a, b) => ssim(a.data, b.data, a.width, a.height);
const near = (found, wanted, by = 1e-9) => assert.ok(Math.abs(found - wanted) <= by, `${found}, not ${wanted}`);

test('equal pictures: 1', () => {
  near(of(noise(20, 15, 3), noise(20, 15, 3)), 1);
});

test('flat pictures: the luminance term alone', () => {
  const C1 = (0.01 * 255) ** 2;
  near(of(flat(12, 12, [50, 50, 50, 255]), flat(12, 12, [90, 90, 90, 255])), (2 * 50 * 90 + C1) / (50 * 50 + 90 * 90 + C1));
});

test('one window: the formula over its 121 weighted pixels', () => {
  const [a, b] = [noise(11, 11, 7), noise(11, 11, 8)];
  const weights = [];
  for (let y = -5; y <= 5; y++) for (let x = -5; x <= 5; x++) weights.push(Math.exp(-(x * x + y * y) / (2 * 1.5 * 1.5)));
  const sum = weights.reduce((s, w) => s + w, 0);
  const luma = ({ data }) => weights.map((_, p) => 0.299 * data[p * 4] + 0.587 * data[p * 4 + 1] + 0.114 * data[p * 4 + 2]);
  const [p, q] = [luma(a), luma(b)];
  const expectation = (f) => weights.reduce((s, w, i) => s + (w / sum) * f(i), 0);
  const [mp, mq] = [expectation((i) => p[i]), expectation((i) => q[i])];
  const [vp, vq] = [expectation((i) => (p[i] - mp) ** 2), expectation((i) => (q[i] - mq) ** 2)];
  const covariance = expectation((i) => (p[i] - mp) * (q[i] - mq));
  const [C1, C2] = [2.55 ** 2, 7.65 ** 2];
  near(of(a, b), ((2 * mp * mq + C1) * (2 * covariance + C2)) / ((mp ** 2 + mq ** 2 + C1) * (vp + vq + C2)));
});

test('a mirrored structure is negative; a picture without a whole window has none', () => {
  const stripes = (shift) => draw(16, 16, (x) => [((x + shift) % 2) * 255, ((x + shift) % 2) * 255, ((x + shift) % 2) * 255, 255]);
  assert.ok(of(stripes(0), stripes(1)) < -0.9);
  assert.equal(of(flat(10, 30, [0, 0, 0, 255]), flat(10, 30, [0, 0, 0, 255])), null);
});

test('a spot: the mean over all windows, each taken by itself', () => {
  const window = ({ width, data }, x0, y0) => draw(11, 11, (x, y) => [...data.subarray(((y0 + y) * width + x0 + x) * 4).subarray(0, 4)]);
  for (const [x, y] of [
    [20, 12],
    [0, 0],
    [39, 29],
  ]) {
    const [a, b] = [noise(40, 30, 3), withPixel(noise(40, 30, 3), x, y, [255, 0, 255, 255])];
    const values = [];
    for (let y0 = 0; y0 <= 19; y0++) for (let x0 = 0; x0 <= 29; x0++) values.push(of(window(a, x0, y0), window(b, x0, y0)));
    near(of(a, b), values.reduce((sum, value) => sum + value, 0) / values.length);
  }
});
