import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../js/index.mjs';
import { IMAGE_CHECKS } from './image_checks.mjs';
import { IMAGE_FAULTS, misled } from './image_faults.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer({ backend: 'egl-surfaceless' });
});
after(() => renderer?.close());

const said = ({ what, shading, measured, low, high }) => `${what}, ${shading}: ${measured}, bar ${low} .. ${high}`;
const kindOf = ({ what }) => what.slice(what.lastIndexOf(': ') + 2);
const hasBar = ({ low, high }) => low !== null || high !== null;

for (const { name, run } of IMAGE_CHECKS) {
  test(`every figure of "${name}" holds, and a fault is planted for each bar`, async () => {
    const figures = await run(renderer);
    assert.deepEqual(figures.filter(({ holds }) => !holds).map(said), []);
    const caught = new Set(IMAGE_FAULTS.filter(({ check }) => check === name).flatMap(({ fails }) => fails));
    const safe = figures.filter((figure) => hasBar(figure) && !caught.has(kindOf(figure)));
    assert.deepEqual(safe.map(said), [], 'a fault is planted for each bar');
  });
}

for (const fault of IMAGE_FAULTS) {
  test(`"${fault.check}" finds ${fault.name}`, async (t) => {
    const { run } = IMAGE_CHECKS.find(({ name }) => name === fault.check);
    const off = (await run(misled(renderer, fault), { shadings: ['fabric'] })).filter(({ holds }) => !holds);
    for (const figure of off) t.diagnostic(said(figure));
    const kinds = new Set(off.map(kindOf));
    assert.deepEqual(
      fault.fails.filter((what) => !kinds.has(what)),
      [],
    );
  });
}
