import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CASES } from './cases.mjs';
import { drawCases } from './draw_cases.mjs';
import { serial } from './serial.mjs';

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const named = (name, model = 'ball') => ({ ...CASES.find((item) => item.name === 'ball-sun'), name, model });

/** A side that notes when it begins and ends, and takes `ms`. */
function side(log, who, ms, result) {
  return {
    draw: async () => {
      log.push(`${who} begins`);
      await pause(ms);
      log.push(`${who} ends`);
      return result;
    },
  };
}

test('both sides draw a case at the same time, and results come in the order of the cases', async () => {
  const log = [];
  const sides = {
    browser: side(log, 'browser', 20, { image: 1, facts: { loadMs: 1, drawMs: 2 } }),
    server: side(log, 'server', 5, 'actual'),
    comparer: { compare: async (item, expected, actual) => ({ difference: [item.name, expected.image, actual] }) },
  };
  const found = [];
  for await (const { item, difference } of drawCases(
    ['a', 'b', 'c', 'd', 'e', 'f'].map((name) => named(name)),
    sides,
  ))
    found.push([item.name, ...difference]);
  assert.deepEqual(
    found,
    ['a', 'b', 'c', 'd', 'e', 'f'].map((name) => [name, name, 1, 'actual']),
  );
  assert.ok(log.indexOf('server begins') < log.indexOf('browser ends'), log.join(', '));
});

test('a case that cannot be drawn has the error, and the others go on', async () => {
  const facts = { loadMs: 0, drawMs: 0 };
  const broken = {
    draw: async ({ shot }) => {
      if (shot.size.width === 256) throw new Error('lost');
      return { facts };
    },
  };
  const small = { ...named('small'), shot: { ...named('').shot, size: { width: 8, height: 8 } } };
  const results = [];
  for await (const result of drawCases([named('gone', 'no-such-model'), named('broken'), small], { browser: broken })) results.push(result);
  assert.deepEqual(
    results.map(({ item, error }) => [item.name, error?.message]),
    [
      ['gone', 'case gone: test/fixtures has no model no-such-model'],
      ['broken', 'lost'],
      ['small', undefined],
    ],
  );
});

test('serial work: one call after the other, whatever becomes of the one before', async () => {
  const log = [];
  const work = serial(async (name, ms) => {
    log.push(`${name} begins`);
    await pause(ms);
    log.push(`${name} ends`);
    if (name === 'a') throw new Error(name);
    return name;
  });
  const results = await Promise.allSettled([work('a', 10), work('b', 1), work('c', 0)]);
  assert.deepEqual(log, ['a begins', 'a ends', 'b begins', 'b ends', 'c begins', 'c ends']);
  assert.deepEqual(
    results.map(({ status, value }) => value ?? status),
    ['rejected', 'b', 'c'],
  );
});
