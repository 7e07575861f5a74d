import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readShotOptions } from '../../../js/cli/shot_options.mjs';

const shotOf = (...material) => readShotOptions({ material }, {});

test('--material names a part, a preset and a colour', async () => {
  assert.deepEqual(await shotOf('Body*=denim:#23324f', 'Collar=:rgb(1, 2, 3)', 'Pocket=satin', '0=towel'), {
    materials: { 'Body*': { preset: 'denim', color: '#23324f' }, Collar: { color: 'rgb(1, 2, 3)' }, Pocket: { preset: 'satin' }, 0: { preset: 'towel' } },
  });
});

test('what says nothing is refused', async () => {
  for (const text of ['Body', '=denim', 'Body=', 'Body=:'])
    await assert.rejects(shotOf(text), { code: 'E_USAGE', message: /--material: expected PART=PRESET:COLOUR/ });
});
