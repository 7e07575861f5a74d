import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { fuzzSpec, plantedRead } from '../../fuzz/spec.mjs';

// A short turn of `npm run fuzz -- spec`, always the same; what longer ones have found is read again.

const REGRESSIONS = new URL('../../fuzz/regressions/spec/', import.meta.url);
const RUNS = 1500;

test('specs that are changed in their structure are accepted or refused as specs', () => {
  const corpus = existsSync(REGRESSIONS) ? readdirSync(REGRESSIONS).map((name) => JSON.parse(readFileSync(new URL(name, REGRESSIONS), 'utf8'))) : [];
  const { runs, outcomes, fault, spec } = fuzzSpec({ runs: RUNS, corpus });
  assert.equal(fault, undefined, JSON.stringify(spec));
  assert.equal(runs, RUNS);
  assert.ok(outcomes > 100, `${outcomes} complaints that differ`);
});

for (const [what, read] of [
  ['an error that is not of the spec', plantedRead],
  ['a spec of the caller that is written to', (spec) => Object.assign(spec, { written: true })],
]) {
  test(`planted: ${what}`, () => assert.ok(fuzzSpec({ runs: 20_000, read }).fault));
}
