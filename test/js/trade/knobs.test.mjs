import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { KNOB_SETTINGS, KNOBS, knobsTable, sensitivity, together } from '../../../js/trade/knobs.mjs';

const FACTS = { bounds: { min: [-1, -1, -1], max: [1, 1, 1] } };

/** What each setting adds to standard's FLIP of 0.1 and 50 ms: "samples 16" takes 0.02 for 40 ms, and so on. */
const LAW = {
  standard: [0, 0],
  'samples 1': [0.01, -20],
  'samples 16': [-0.02, 40],
  'samples 64': [-0.03, 600],
  'environmentSamples 16': [-0.04, 20],
  'resolve linear': [-0.001, 1],
  'shadow.mapSize 256': [-0.001, -5],
  'shadow.mapSize 2048': [0.002, 10],
};
const rowsBy = (law) =>
  ['a', 'b', 'c'].flatMap((model, i) =>
    Object.entries(law).map(([setting, [flip, cpuMs]]) => ({
      model,
      light: 'sun',
      shading: 'fabric',
      size: 256,
      setting,
      flip: 0.1 + 0.01 * i + flip,
      cpuMs: 50 + i + cpuMs,
    })),
  );

test('every setting is a shot that telar draws, one change from standard', () => {
  const standard = resolveShot({ quality: 'standard' }, FACTS).quality;
  for (const [name, setting] of Object.entries(KNOB_SETTINGS)) {
    const lights = [{ type: 'directional', castShadow: true, ...(setting.shadow && { shadow: setting.shadow }) }];
    const { quality } = resolveShot({ quality: setting.quality ?? setting, lights }, FACTS);
    const changed = Object.keys(standard).filter((key) => key !== 'preset' && quality[key] !== standard[key]);
    const knob = name.split(' ')[0];
    // More than 4 samples are averaged in linear light, and noise is of such; what is denoised is their light.
    const sampled = quality.samples > 4 ? ['samples', 'resolve', ...(quality.denoise ? ['environmentSamples'] : [])] : [];
    assert.deepEqual(changed, knob in standard ? [...new Set([...sampled, knob])] : [], name);
  }
});

test('slopes come back as planted, the steepest first', () => {
  const found = sensitivity(rowsBy(LAW));
  const of = (name) => found.find(({ setting }) => setting === name);
  for (const [name, [flip, cpuMs]] of Object.entries(LAW).slice(1)) {
    const { perSecond, scenes, ...by } = of(name);
    assert.ok(Math.abs(by.flip - flip) < 1e-9 && Math.abs(by.cpuMs - cpuMs) < 1e-9 && scenes === 3, name);
    assert.ok(Math.abs(perSecond - (-1000 * flip) / cpuMs) < 1e-6, name);
  }
  assert.equal(found[0].setting, 'environmentSamples 16');
  const faulty = sensitivity(rowsBy({ ...LAW, 'environmentSamples 16': [-0.04, 200] }));
  assert.notEqual(faulty[0].setting, 'environmentSamples 16', 'planted fault: ten times the time');
});

test('every number of a quality is a knob', () => {
  const { preset: _, ...numbers } = resolveShot({ quality: 'standard' }, FACTS).quality;
  assert.deepEqual(
    Object.keys(numbers).filter((key) => !Object.hasOwn(KNOBS, key)),
    [],
  );
});

test('ambient visibility is compared with the same truth', () => {
  const law = { standard: [0, 0], 'standard, of what is hidden': [0.05, 0], ambientVisibility: [0.03, 5] };
  const found = sensitivity(rowsBy(law));
  assert.deepEqual(
    found.map(({ setting }) => setting),
    ['ambientVisibility'],
  );
  assert.ok(Math.abs(found[0].flip + 0.02) < 1e-9 && Math.abs(found[0].cpuMs - 5) < 1e-9);
});

test('together: the steepest value of each of the three steepest knobs that take error away for time', () => {
  const sets = together(rowsBy(LAW));
  assert.deepEqual(Object.keys(sets), [
    'environmentSamples 16, resolve linear',
    'environmentSamples 16, samples 16',
    'environmentSamples 16, resolve linear, samples 16',
  ]);
  const { samples, resolve, environmentSamples } = sets['environmentSamples 16, samples 16'];
  assert.deepEqual([samples, resolve, environmentSamples], [16, 'linear', 16]);
  assert.deepEqual(together(rowsBy({ standard: [0, 0], 'samples 1': [0.01, -20] })), {});
});

test('the table says where there is no slope', () => {
  const { lines } = knobsTable(rowsBy(LAW));
  const of = (name) => lines.find(([setting]) => setting === name);
  assert.deepEqual(of('samples 16'), ['samples 16', '-0.0200', '+40', '0.500', '3']);
  assert.deepEqual(of('samples 1').slice(1, 4), ['+0.0100', '-20', '0.500']);
  assert.deepEqual([of('shadow.mapSize 256')[3], of('shadow.mapSize 2048')[3]], ['less of both', 'more of both']);
});
