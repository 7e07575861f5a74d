import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sinCosDegrees, tanDegrees } from '../../../js/shot/trig.mjs';

test('multiples of 90 degrees are exact', () => {
  const expected = [
    [0, 1],
    [1, 0],
    [0, -1],
    [-1, 0],
  ];
  for (let quarter = -8; quarter <= 8; ++quarter) {
    const { sin, cos } = sinCosDegrees(90 * quarter);
    assert.deepEqual([sin + 0, cos + 0], expected[((quarter % 4) + 4) % 4], `${90 * quarter}`);
  }
});

test('agrees with Math to the last bits', () => {
  let worst = 0;
  for (let degrees = -720; degrees <= 720; degrees += 0.37) {
    const radians = ((degrees % 360) * Math.PI) / 180;
    const { sin, cos } = sinCosDegrees(degrees);
    worst = Math.max(worst, Math.abs(sin - Math.sin(radians)), Math.abs(cos - Math.cos(radians)));
    assert.ok(Math.abs(sin * sin + cos * cos - 1) < 4e-16);
  }
  // Radians of up to 2 pi carry a rounding error of 4.4e-16 themselves.
  assert.ok(worst < 2e-15, `${worst}`);
});

test('tangent of half a field of view', () => {
  assert.ok(Math.abs(tanDegrees(45) - 1) <= 2.3e-16);
  for (const degrees of [0.0005, 15, 30, 60, 89.9995]) {
    const expected = Math.tan((degrees * Math.PI) / 180);
    assert.ok(Math.abs(tanDegrees(degrees) / expected - 1) < 1e-9, `${degrees}`);
  }
});
