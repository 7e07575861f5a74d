import assert from 'node:assert/strict';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { readImage } from '../../js/compare/index.mjs';
import { createRenderer } from '../../js/index.mjs';
import { GOLDENS, goldenFile, goldenShot } from './cases.mjs';

// Another processor may round a shader's arithmetic differently in the last bit; a wrong term is far off.
const MAX = 5;
const PART_ABOVE_2 = 0.001;
const CANDIDATES = new URL('../../out/golden/', import.meta.url);

let renderer;
before(async () => {
  renderer = await createRenderer({ backend: 'egl-surfaceless' });
});
after(() => renderer?.close());

/** Largest channel difference and the part of all channels that differ by more than 2. */
function difference(golden, candidate) {
  let [largest, above] = [0, 0];
  golden.forEach((byte, i) => {
    const apart = Math.abs(byte - candidate[i]);
    largest = Math.max(largest, apart);
    above += apart > 2;
  });
  return { largest, part: above / golden.length };
}

for (const [name, golden] of Object.entries(GOLDENS)) {
  test(`${name} looks as accepted`, async () => {
    const { data } = await renderer.render(await golden.model(), goldenShot(golden));
    const keep = () => {
      mkdirSync(CANDIDATES, { recursive: true });
      writeFileSync(new URL(`${name}.png`, CANDIDATES), data);
      return `see ${fileURLToPath(new URL(`${name}.png`, CANDIDATES))}; npm run goldens accepts it`;
    };
    if (!existsSync(goldenFile(name))) assert.fail(`there is no golden; ${keep()}`);
    const [accepted, candidate] = [await readImage(goldenFile(name)), await readImage(data)];
    assert.deepEqual([candidate.width, candidate.height], [accepted.width, accepted.height]);
    const { largest, part } = difference(accepted.data, candidate.data);
    assert.ok(largest <= MAX && part <= PART_ABOVE_2, `differs by up to ${largest}, ${(part * 100).toFixed(2)} % by more than 2; ${keep()}`);
  });
}
