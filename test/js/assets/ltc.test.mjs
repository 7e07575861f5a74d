import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { LTC_FILE, ltcTables } from '../../../js/assets/make/ltc.mjs';

test("the tables of rect lights are three.js's, number for number, with the notice of their source", async () => {
  const text = readFileSync(LTC_FILE, 'utf8');
  assert.ok(text === (await ltcTables()), 'run node js/assets/make/ltc.mjs');
  assert.match(text, /Copyright \(c\) 2017, Eric Heitz, Jonathan Dupuy, Stephen Hill and David Neubelt/);
  const { RectAreaLightTexturesLib } = await import('three/addons/lights/RectAreaLightTexturesLib.js');
  const [inverse, albedo] = [...text.matchAll(/= \{([^}]*)\}/g)].map(([, list]) =>
    list
      .split(',')
      .slice(0, -1)
      .map((word) => Math.fround(Number.parseFloat(word))),
  );
  const { LTC_FLOAT_1, LTC_FLOAT_2 } = RectAreaLightTexturesLib;
  assert.deepEqual(
    inverse,
    Array.from(LTC_FLOAT_1.image.data, (x) => x + 0),
  );
  assert.deepEqual(
    albedo,
    Array.from(LTC_FLOAT_2.image.data).filter((_, i) => i % 4 < 2),
  );
});
