import assert from 'node:assert/strict';
import { mkdtemp, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { calibrationOf, keptCalibrations } from '../../../js/api/calibration.mjs';

// What is kept of a machine's speed, where the path tracer came or went between two processes.

let folder;
before(async () => {
  folder = await mkdtemp(path.join(os.tmpdir(), 'telar-calibration-'));
});
after(() => rm(folder, { recursive: true }));

const never = () => assert.fail('it was measured again');
const WITHOUT = { raster: 5, tracer: 0 };
const WITH = { raster: 6, tracer: 7 };

test('a speed that was measured without the tracer is measured again where it is there, and not the other way round', async () => {
  const of = (tracer, measure) => calibrationOf(folder, 'a GL', { tracer }, measure);
  assert.deepEqual(await of(false, async () => WITHOUT), WITHOUT);
  assert.deepEqual(await of(false, never), WITHOUT);
  assert.deepEqual(await of(true, async () => WITH), WITH);
  assert.deepEqual(await of(true, never), WITH);
  assert.deepEqual(await of(false, never), WITH);
  assert.deepEqual(await keptCalibrations(folder), { 'a GL': WITH });
});

test('without a folder each is measured', async () => {
  assert.deepEqual(await calibrationOf('', 'a GL', { tracer: true }, async () => WITH), WITH);
});
