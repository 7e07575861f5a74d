import assert from 'node:assert/strict';
import { test } from 'node:test';
import { placeCallouts } from '../../../js/sheet/place/callouts.mjs';
import { isWithin, linesCross, overlaps } from '../../../js/sheet/place/geometry.mjs';
import { spread, stacked } from '../../../js/sheet/place/stack.mjs';
import { between, oneOf, seeded } from './random.mjs';

const COLUMNS = { height: 150, left: { x: 0, width: 60 }, right: { x: 213, width: 60 }, gap: 4, port: 1.25, pad: 1.6, stub: 4 };
const PAGE = { x: 0, y: 0, width: 273, height: 150 };

/** What is wrong with a layout, in words. */
function faultsOf(labels, { placed, rest }) {
  const faults = [];
  placed.forEach((a, i) => {
    const label = labels.find(({ id }) => id === a.id);
    if (!isWithin(a, PAGE)) faults.push(`${a.id} leaves the page`);
    if (a.height !== label.height || a.width !== label.width) faults.push(`${a.id} has another size`);
    if (a.leader.at(-1) !== label.site) faults.push(`${a.id} leads elsewhere`);
    if (a.leader[0][1] < a.y || a.leader[0][1] > a.y + a.height) faults.push(`${a.id} is left by its line`);
    for (const b of placed.slice(i + 1)) {
      if (overlaps(a, b)) faults.push(`${a.id} overlaps ${b.id}`);
      if (linesCross(a.leader, b.leader)) faults.push(`${a.id} crosses ${b.id}`);
    }
  });
  const seen = [...placed, ...rest].map(({ id }) => id).sort((a, b) => a - b);
  if (JSON.stringify(seen) !== JSON.stringify(labels.map(({ id }) => id))) faults.push('something is lost or twice');
  if (placed.length === 0 && labels.length > 0) faults.push('nothing is placed');
  return faults;
}

/** Call-outs that make trouble: sites in rows, columns, clusters, at one place; wishes that contradict each other. */
function randomLabels(seed) {
  const random = seeded(seed);
  const count = 1 + Math.floor(random() * 40);
  const kind = oneOf(random, ['anywhere', 'row', 'column', 'cluster', 'same']);
  const site = () => {
    if (kind === 'row') return [between(random, 70, 203), 75];
    if (kind === 'column') return [136, between(random, 0, 150)];
    if (kind === 'cluster') return [between(random, 130, 140), between(random, 70, 80)];
    return kind === 'same' ? [120, 60] : [between(random, 65, 208), between(random, 0, 150)];
  };
  const wishes = random() < 0.3 ? ['left', 'right', undefined] : [undefined];
  return Array.from({ length: count }, (_, id) => ({
    id,
    site: site(),
    width: between(random, 8, 60),
    height: between(random, 2.5, random() < 0.1 ? 74 : 16),
    side: oneOf(random, wishes),
  }));
}

test('500 layouts: no line crosses another, no text overlaps or leaves the page, none is lost', () => {
  for (let seed = 1; seed <= 500; ++seed) {
    const labels = randomLabels(seed);
    assert.deepEqual(faultsOf(labels, placeCallouts(labels, COLUMNS)), [], `seed ${seed}`);
  }
});

test('what does not fit is placed on further pages, in the order given', () => {
  const labels = Array.from({ length: 60 }, (_, id) => ({ id, site: [70 + ((id * 37) % 130), (id * 53) % 150], width: 50, height: 12 }));
  const order = [];
  for (let left = labels, pages = 0; left.length > 0; ++pages) {
    const { placed, rest } = placeCallouts(left, COLUMNS);
    assert.deepEqual(faultsOf(left, { placed, rest }), []);
    order.push(...placed.map(({ id }) => id).sort((a, b) => a - b));
    left = rest;
    assert.ok(pages < 10);
  }
  assert.deepEqual(
    order,
    labels.map(({ id }) => id),
  );
});

test('a wish for a side is kept where it can be, and told where not', () => {
  const label = (id, x, y, side) => ({ id, site: [x, y], width: 40, height: 8, side });
  const kept = placeCallouts([label(0, 80, 20, 'right'), label(1, 190, 120, 'left')], COLUMNS);
  assert.deepEqual([kept.placed.find(({ id }) => id === 0).side, kept.placed.find(({ id }) => id === 1).side, kept.moved], ['right', 'left', []]);
  // Each would have to pass the other at one height.
  const crossed = placeCallouts([label(0, 80, 75, 'right'), label(1, 190, 75.5, 'left'), label(2, 82, 75.2, 'right'), label(3, 188, 74.5, 'left')], COLUMNS);
  assert.ok(crossed.moved.length > 0);
  const both = crossed.placed.filter((a) => crossed.placed.some((b) => a !== b && linesCross(a.leader, b.leader)));
  assert.deepEqual(both, []);
});

test('planted faults are seen', () => {
  const labels = Array.from({ length: 8 }, (_, id) => ({ id, site: [100 + 9 * id, 20 + 14 * id], width: 40, height: 9 }));
  const plant = (change) => {
    const result = placeCallouts(labels, COLUMNS);
    change(result);
    return faultsOf(labels, result).join('\n');
  };
  assert.match(
    plant(({ placed }) => placed.pop()),
    /lost/,
  );
  assert.match(
    plant(({ placed }) => {
      placed[1].y = placed[0].y;
      placed[1].x = placed[0].x;
    }),
    /overlaps/,
  );
  assert.match(
    plant(({ placed }) => {
      placed[0].x = -1;
    }),
    /leaves the page/,
  );
  const swapped = plant(({ placed }) => {
    const side = placed.filter((label) => label.side === placed[0].side).sort((a, b) => a.y - b.y);
    const [top, bottom] = [side[0], side.at(-1)];
    [top.leader, bottom.leader] = [
      [...bottom.leader.slice(0, 2), top.leader[2]],
      [...top.leader.slice(0, 2), bottom.leader[2]],
    ];
  });
  assert.match(swapped, /crosses/);
});

test('a column keeps texts near to what they name, in their order and apart', () => {
  const items = [10, 12, 60].map((wanted) => ({ height: 10, wanted }));
  const column = { height: 100, gap: 2 };
  // The first two push each other apart by the same: their tops are 12 apart about 11.
  assert.deepEqual(stacked(items, column), [5, 17, 60]);
  assert.deepEqual(stacked([{ height: 10, wanted: 200 }], column), [90]);
  assert.deepEqual(stacked([{ height: 10, wanted: -5 }], column), [0]);
  assert.equal(stacked(Array(9).fill({ height: 10, wanted: 0 }), column), undefined);
  assert.deepEqual(spread(items, { height: 100, gap: 2 }), [0, 45, 90]);
  assert.deepEqual(stacked([], column), []);
});
