import assert from 'node:assert/strict';
import { test } from 'node:test';
import { judgeRamp, ramp, timesOf } from '../../load/ramp.mjs';
import { HOURS, openPool } from './support.mjs';

// A short ramp of load; `npm run load` is the long one, and says the times.

test('more than can be drawn: each request is drawn or refused, and the service is idle afterwards', async () => {
  const pool = await openPool();
  const result = await ramp({ pool, seconds: 3, times: 10, deadlineMs: HOURS });
  await pool.close();
  assert.deepEqual(judgeRamp(result), []);
  assert.ok(timesOf(result.answers).most > 0);
});

const GOOD = {
  asked: 2,
  answers: [
    { status: 200, code: '', ms: 5 },
    { status: 429, code: 'X_BUSY', ms: 1 },
  ],
  idle: { status: 'ready', running: 0, waiting: 0 },
};
const other = (status, code) => ({ asked: 3, answers: [...GOOD.answers, { status, code, ms: 1 }] });
const PLANTED = [
  [{}, []],
  [{ asked: 3 }, ['1 of 3 requests have no answer']],
  [other(504, 'X_TIMEOUT'), ['1 answers of another kind, as 504 X_TIMEOUT']],
  [other('ECONNRESET', ''), ['1 answers of another kind, as ECONNRESET ']],
  [other(429, 'X_SHUTDOWN'), ['1 answers of another kind, as 429 X_SHUTDOWN']],
  [{ asked: 1, answers: GOOD.answers.slice(0, 1) }, ['no answer is 429']],
  [{ idle: { status: 'ready', running: 1, waiting: 0 } }, ['afterwards the service says {"status":"ready","running":1,"waiting":0}']],
];
test('planted: what a ramp must not have', () => {
  for (const [change, faults] of PLANTED) assert.deepEqual(judgeRamp({ ...GOOD, ...change }), faults);
});
