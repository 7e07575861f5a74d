import assert from 'node:assert/strict';
import { test } from 'node:test';
import { analyse, analysisSteps } from '../../../js/analyse/analyse.mjs';
import { interactionOf, ranksOf, spread } from '../../../js/analyse/ranking.mjs';
import { swapsBetween } from '../../../js/analyse/swaps.mjs';
import { inWords } from '../../../js/analyse/words.mjs';
import { plantedApi } from './support.mjs';

const swaps = swapsBetween('three-r115', 'disney-2012');
const plan = (lights = ['studio'], targets = ['leather']) => ({
  swaps,
  targets: targets.map((name) => ({ name, source: name, shot: {} })),
  lights: lights.map((name) => ({ name, shot: {} })),
  shot: { size: { width: 48, height: 48 }, quality: 'draft' },
});
const ranked = (effect, given = plan()) => {
  const { api, renderer } = plantedApi(effect);
  return analyse(api, renderer, given);
};
const rowOf = (rows, slot) => rows.find((row) => row.slot === slot);

test('every slot in which the shadings differ is swapped alone, and put back alone', () => {
  assert.deepEqual(swaps.terms[0], { slot: 'parameters', from: 'three-r115', to: 'disney-2012' });
  for (const { slot, from, to } of swaps.terms) {
    const { from: first, to: second, [`alone:${slot}`]: alone, [`rest:${slot}`]: rest } = swaps.shadings;
    assert.deepEqual(alone, { ...first, [slot]: to });
    assert.deepEqual(rest, { ...second, [slot]: from });
  }
  const near = swapsBetween('three-r115', { base: 'three-r115', sheen: 'zeltner' });
  assert.deepEqual(near.terms, [{ slot: 'sheen', from: 'charlie-neubelt', to: 'zeltner' }]);
  const whole = swapsBetween('three', 'disney-2012');
  assert.deepEqual([whole.terms, Object.keys(whole.shadings)], [[], ['from', 'to']]);
  for (const [from, to, code] of [
    ['three', 'three', 'E_USAGE'],
    ['three-r115', 'three-r115', 'E_USAGE'],
    ['phong', 'disney-2012', 'E_SHOT'],
  ]) {
    assert.throws(() => swapsBetween(from, to), { code });
  }
});

test('the planted differences come back in order of size, in words, and those without an effect last', async () => {
  const { rows, cells } = await ranked(
    (swapped, cosine) => (swapped.has('sheen') && cosine < 0.6 ? 80 : 0) + (swapped.has('diffuse') ? 6 : 0) - (swapped.has('fresnel') && cosine > 0.8 ? 20 : 0),
  );
  assert.deepEqual(
    rows.slice(0, 3).map(({ slot, rank: place }) => [slot, place]),
    [
      ['sheen', 1],
      ['diffuse', 2],
      ['fresnel', 3],
    ],
  );
  assert.deepEqual(
    rows.slice(0, 3).map(({ words }) => words.split(',')[0]),
    ['much brighter limb', 'brighter throughout', 'much darker centre'],
  );
  for (const row of rows.slice(3)) assert.deepEqual([row.rank, row.effect, row.words, row.interaction], [4, 0, 'no change', '']);
  const diffuse = cells[0].terms.diffuse.alone;
  // Grey 100 to 106 of sRGB is 2.5 of CIELAB lightness everywhere.
  assert.ok(Math.abs(diffuse.cloth.lightness - 2.46) < 0.05 && Math.abs(diffuse.limb.lightness - diffuse.centre.lightness) < 1e-3);
  assert.equal(diffuse.cloth.chroma, 0);
  assert.ok(rows[0].share > rows[1].share && rows[0].share <= 1.2);
});

test('a term that acts only with another is told as an interaction', async () => {
  const { rows } = await ranked((swapped) => (swapped.has('sheen') ? 10 + (swapped.has('layering') ? 40 : 0) : 0));
  const [sheen, layering] = ['sheen', 'layering'].map((slot) => rowOf(rows, slot));
  assert.match(sheen.interaction, /^more once the others are swapped \(x 2\.9\)/);
  assert.equal(layering.interaction, 'only once others are swapped');
  assert.equal(rowOf(rows, 'diffuse').interaction, '');
  assert.equal(layering.words, 'as the last: much brighter throughout');
});

test('spread over cells: the mean, its deviation, and the ranks in each', async () => {
  const { rows } = await ranked(
    (swapped, _cosine, { exposure }) => (swapped.has('sheen') ? (exposure === 2 ? 40 : 4) : 0) + (swapped.has('diffuse') ? 15 : 0),
    {
      ...plan(),
      lights: [
        { name: 'dim', shot: {} },
        { name: 'bright', shot: { exposure: 2 } },
      ],
    },
  );
  const [sheen, diffuse] = ['sheen', 'diffuse'].map((slot) => rowOf(rows, slot));
  assert.deepEqual([sheen.ranks, diffuse.ranks, sheen.rank], [[1, 2], [1, 2], 1]);
  assert.ok(sheen.alone.flip.deviation > 5 * diffuse.alone.flip.deviation && diffuse.alone.flip.deviation < 1e-6);
  assert.match(sheen.words, /^much brighter throughout \(leather, bright\)/);
  assert.deepEqual(spread([1, 3]), { mean: 2, deviation: Math.SQRT2, min: 1, max: 3 });
  assert.deepEqual(spread([5]), { mean: 5, deviation: 0, min: 5, max: 5 });
  assert.deepEqual(ranksOf([0, 3, 3, 1]), [4, 1, 1, 3]);
});

test('equal shadings are drawn once, steps are as announced', async () => {
  const one = swapsBetween('three-r115', { base: 'three-r115', sheen: 'zeltner', diffuse: 'eon' });
  const { api, renderer, calls } = plantedApi(() => 0);
  let steps = 0;
  const given = { ...plan(['studio', 'sun'], ['leather', 'wool']), swaps: one };
  const { cells } = await analyse(api, renderer, given, {
    step: () => {
      steps += 1;
    },
  });
  // alone:sheen is rest:diffuse and the other way round; the lobes of a target are a step, too.
  assert.deepEqual([calls.rendered, steps, analysisSteps(given), cells.length], [16, 38, 38, 4]);
  assert.deepEqual([calls.loaded, calls.released], [2, 2]);
  assert.deepEqual(
    cells.map(({ target, light }) => `${target} ${light}`),
    ['leather studio', 'leather sun', 'wool studio', 'wool sun'],
  );
});

test('interactions begin at a factor of 1.25 and above what can be seen', () => {
  assert.equal(interactionOf(0.1, 0.12), '');
  assert.equal(interactionOf(0.0004, 0.0018), '');
  assert.equal(interactionOf(0.2, 0.1), 'less once the others are swapped (x 0.5)');
  assert.equal(interactionOf(0.2, 0), 'only while the others are not swapped');
});

test('words follow the figures', () => {
  const figures = (more) => ({ deltaE: { mean: 3, p95: 6 }, cloth: { lightness: 0, chroma: 0 }, limb: null, centre: null, highlight: null, ...more });
  const change = (lightness) => ({ lightness, chroma: 0 });
  for (const [given, expected] of [
    [{ deltaE: { mean: 0, p95: 0 } }, 'no change'],
    [{ deltaE: { mean: 0.1, p95: 0.4 } }, 'not visible'],
    [{ limb: change(3), centre: change(-1) }, 'brighter limb, darker centre'],
    [{ limb: change(-7), centre: change(-1) }, 'much darker limb'],
    [{ limb: change(2), centre: change(1.9), cloth: { lightness: 2, chroma: -3 } }, 'brighter throughout, weaker highlights, paler'],
    [{ limb: change(2), centre: change(2), highlight: change(9), cloth: change(2) }, 'brighter throughout, much stronger highlights'],
    [{}, 'local changes that even out'],
  ])
    assert.equal(inWords(figures(given)), expected);
});
