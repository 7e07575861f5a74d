import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../js/index.mjs';
import { IMAGE_CHECKS } from './image_checks.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer({ backend: 'egl-surfaceless' });
});
after(() => renderer?.close());

for (const { name, run } of IMAGE_CHECKS) {
  test(`every figure of "${name}" holds`, async () => {
    const off = (await run(renderer)).filter(({ holds }) => !holds);
    assert.deepEqual(off.map(({ what, shading, measured, low, high }) => `${what}, ${shading}: ${measured}, bar ${low} .. ${high}`), []);
  });
}
