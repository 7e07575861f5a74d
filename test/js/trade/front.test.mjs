import assert from 'node:assert/strict';
import { test } from 'node:test';
import { csvOf, presetsAboveFront, presetsByClass } from '../../../js/trade/figures.mjs';
import { aboveFront, cheapestWithin, frontOf } from '../../../js/trade/front.mjs';
import { toldFactor } from '../../../js/trade/measure.mjs';
import { tradePage } from '../../../js/trade/page.mjs';
import { tradePlot } from '../../../js/trade/plots.mjs';
import { assertWellFormed } from '../analyse/support.mjs';

const point = (setting, cpuMs, flip, family = 'raster') => ({ setting, cpuMs, flip, family });
const POINTS = [point('draft', 10, 0.2), point('standard', 40, 0.21), point('medium', 50, 0.05), point('a', 45, 0.05), point('b', 300, 0.01)];

test('the front has what nothing beats in time and error', () => {
  assert.deepEqual(
    frontOf(POINTS).map(({ setting }) => setting),
    ['draft', 'a', 'b'],
  );
  assert.equal(aboveFront(POINTS[0], POINTS), 1);
  assert.equal(aboveFront(POINTS[1], POINTS), 4);
  assert.ok(Math.abs(aboveFront(POINTS[2], POINTS) - 50 / 45) < 1e-12);
  assert.deepEqual(
    [0.005, 0.01, 0.05, 0.3].map((bar) => cheapestWithin(POINTS, bar)?.setting),
    [undefined, 'b', 'a', 'draft'],
  );
});

const rowOf = (each, more = {}) => ({
  model: 'a "b", c',
  light: 'studio',
  shading: 'fabric',
  size: 256,
  deltaE: 1,
  timed: 'picture',
  windowMs: 3,
  toldMs: 10,
  samples: 4,
  features: { shading: 'fabric', surface: 'relief', environment: 'studio', shadows: false, triangles: 12, pixels: 65536, covered: 9000, traceable: true },
  ...each,
  ...more,
});

test('presets above the front are counted', () => {
  const rows = [
    ...POINTS.map((each) => rowOf(each)),
    ...POINTS.map((each) => rowOf({ ...each, cpuMs: each.setting === 'standard' ? 9 : each.cpuMs }, { size: 512 })),
  ];
  const standard = presetsAboveFront(rows).find(({ preset }) => preset === 'standard');
  assert.deepEqual([standard.within, standard.scenes, standard.worst], [1, 2, 4]);
});

test('presets above the front are named by class, with what is better', () => {
  const smooth = { ...rowOf(POINTS[0]).features, surface: 'smooth' };
  const rows = [
    ...POINTS.map((each) => rowOf(each)),
    ...POINTS.map((each) => rowOf({ ...each, features: smooth, cpuMs: each.setting === 'a' ? 60 : each.cpuMs }, { size: 512 })),
  ];
  const of = (preset, group) => presetsByClass(rows).find((each) => each.preset === preset && each.group === group);
  assert.deepEqual(of('standard', 'fabric, relief'), { preset: 'standard', group: 'fabric, relief', times: 4, within: 0, scenes: 1, better: 'draft' });
  assert.deepEqual([of('medium', 'fabric, relief').better, of('medium', 'fabric, smooth').better], ['a', undefined]);
  assert.equal(of('high', 'fabric, relief'), undefined);
});

test('CSV quotes what has commas and quotes', () => {
  const [head, line, end] = csvOf([rowOf(POINTS[0])]).split('\n');
  assert.equal(head.split(',').length, 19);
  assert.ok(line.startsWith('"a ""b"", c",studio,fabric,256,draft,raster,0.2,1,10,picture,'), line);
  assert.equal(end, '');
});

test('the plot: time is logarithmic, presets are named, the front is stairs', () => {
  const svg = tradePlot('a <b>', POINTS);
  assertWellFormed(svg);
  const at = (flip, ms) => new RegExp(`cx="([\\d.]+)" cy="[\\d.]+" r="3.4"><title>[^<]*FLIP ${flip}, ${ms} ms`).exec(svg)[1];
  const [x10, x300] = [Number(at('0.2000', 10)), Number(at('0.0100', 300))];
  // 10 ms is the left end of two decades, 300 ms three quarters of the way.
  assert.deepEqual([x10, x300], [52, Number((52 + (Math.log10(30) / 2) * 388).toFixed(1))]);
  assert.ok(svg.includes('>draft<') && svg.includes('>medium<') && !svg.includes('>high<'));
  assert.match(svg, /class="front" d="M52 [\d.]+H[\d.]+V[\d.]+H[\d.]+V[\d.]+"/);
});

test('another renderer is a point with its name, and not on the front', () => {
  const stairs = (svg) => /class="front" d="M52[^"]*"/.exec(svg)[0];
  const own = POINTS.filter(({ setting }) => setting !== 'b');
  const svg = tradePlot('t', [...own, { ...point('b', 300, 0.01), family: 'peer' }]);
  assertWellFormed(svg);
  assert.ok(svg.includes('class="peer"') && svg.includes('>b<') && svg.includes('>others<'));
  assert.notEqual(stairs(svg), stairs(tradePlot('t', POINTS)), 'planted fault: as a setting it is on the front');
});

test('the page is one well-formed file that needs no other', () => {
  const html = tradePage(
    POINTS.map((each) => rowOf(each)),
    { command: 'telar bench trade', machine: 'm & n', window: 48 },
  );
  assertWellFormed(html.replace('<!doctype html>', ''));
  assert.ok(!/src=|href=|<script/.test(html));
  assert.ok(html.includes('b (300 ms)') && html.includes('m &#38; n'));
});

test('what a window tells of the time is mended by what it told of the dearest picture of its family that was drawn', () => {
  const drawn = (setting, family, cpuMs, toldMs, timed = 'picture') => rowOf({ setting, family, cpuMs, toldMs, timed });
  const rows = [
    drawn('a', 'tracer', 100, 100),
    drawn('b', 'tracer', 200, 80),
    drawn('c', 'tracer', 900, 360, 'window'),
    drawn('d', 'denoised', 100, 50),
    drawn('e', 'other', 1, 7),
  ];
  assert.equal(toldFactor(rows, 'tracer'), 2.5);
  assert.equal(toldFactor(rows, 'denoised'), 2);
  assert.deepEqual([toldFactor(rows, 'prefiltered'), toldFactor(rows, undefined)], [1, 1], 'settings of a user are of no family');
});
