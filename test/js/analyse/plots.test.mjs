import assert from 'node:assert/strict';
import { test } from 'node:test';
import { albedoPlot, lobePlot, roundUp } from '../../../js/analyse/plots.mjs';
import { assertWellFormed } from './support.mjs';

const lobes = (diffuse, specular = 0) => ({ diffuse, specular, sheen: 0, coat: 0, total: diffuse + specular });
const names = { from: 'a <b> & "c"', to: 'second' };
const points = (svg, className) => {
  const d = new RegExp(`<path class="${className}"[^>]* d="([^"]*)"`).exec(svg)[1];
  return [...d.matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
};

test("the lobe plot: the normal points up, the viewer's side is on the right, lengths are square roots", () => {
  const angles = [60, 0, -60];
  const svg = lobePlot({ title: 'lobes', names, viewAngle: 40, angles, from: [lobes(0.25), lobes(1), lobes(0.25)], to: [lobes(0, 0.04), lobes(0), lobes(0)] });
  assertWellFormed(svg);
  const [right, top, left] = points(svg, 'total from');
  const centre = [(right[0] + left[0]) / 2, top[1] + 156];
  assert.deepEqual([top[0], Math.round(right[0] - centre[0])], [centre[0], Math.round(78 * Math.sin(Math.PI / 3))]);
  assert.ok(right[0] > left[0] && Math.abs(right[1] - (centre[1] - 39)) < 0.02);
  assert.ok(!svg.includes('<b>') && svg.includes('&#60;b&#62;'));
  assert.ok(svg.includes('>specular<') && !svg.includes('>coat<'), 'only lobes that are there');
  assert.match(svg, /prefers-color-scheme:dark/);
});

test('the albedo plot rises with the value and runs to the right with the angle', () => {
  const svg = albedoPlot({ title: 'albedo', names, angles: [0, 45, 87], from: [lobes(0.1), lobes(0.2), lobes(0.4)], to: [lobes(0.1), lobes(0.1), lobes(0.1)] });
  assertWellFormed(svg);
  const line = points(svg, 'total from');
  assert.ok(line[0][0] < line[1][0] && line[1][0] < line[2][0]);
  // The axis ends at 0.5: 0.4 stands at four fifths of its height.
  assert.ok(Math.abs((200 - line[2][1]) / (200 - 26) - 0.8) < 1e-3);
});

test('axes end at round numbers', () => {
  assert.deepEqual(
    [0.013, 0.2, 0.21, 1, 7, 0].map((value) => Number(roundUp(value).toPrecision(6))),
    [0.02, 0.2, 0.5, 1, 10, 1],
  );
});
