import assert from 'node:assert/strict';
import test from 'node:test';
import { cellsOf, stepsOf } from '../../../js/analyse/cells.mjs';
import { mayShow } from '../../../js/analyse/shown_slots.mjs';
import { swapsBetween } from '../../../js/analyse/swaps.mjs';

const shadings = () => swapsBetween({ base: 'three', revision: 180 }, 'three');

/** A renderer whose pictures say what it was asked for. */
function counting(features) {
  const drawn = [];
  return {
    drawn,
    async render(_, shot) {
      drawn.push(shot.shading);
      const pixel = [drawn.length, 100, 100, 255];
      return { data: Uint8Array.from({ length: 16 }, (__, i) => pixel[i % 4]), info: { warnings: [], features } };
    },
    async renderQuantity() {
      return { data: Float32Array.from({ length: 16 }, () => 0.5) };
    },
  };
}

async function drawnWith(features) {
  const swaps = shadings();
  const renderer = counting(features);
  const plan = { lights: [{ name: 'sun', shot: {} }], swaps, shot: { size: { width: 2, height: 2 }, quality: 'standard' } };
  let steps = 0;
  const [cell] = await cellsOf(renderer, {}, { name: 'x', shot: {} }, plan, { step: () => (steps += 1) });
  assert.equal(steps, stepsOf({ targets: [1], ...plan }), 'every step is counted off');
  return { drawn: renderer.drawn, cell, swaps };
}

test('a slot that the model does not have is not drawn again, and changes nothing', async () => {
  const { drawn, cell, swaps } = await drawnWith(['environment', '2 directional-lights', 'ambient-light']);
  const hidden = ['sheenAlbedo', 'sheenEnergy', 'ambientSheen', 'filmMetal', 'filmEnvironment', 'anisotropicVisibility', 'rectCoat'];
  for (const slot of hidden) {
    for (const swapped of [`alone:${slot}`, `rest:${slot}`]) assert.ok(!drawn.includes(swaps.shadings[swapped]), swapped);
    assert.equal(cell.terms[slot].alone.flip.mean, 0, slot);
    assert.equal(cell.terms[slot].rest.flip.mean, 0, slot);
  }
  for (const slot of ['directDiffuse', 'environmentMetal', 'roughnessMin']) assert.ok(cell.terms[slot].alone.flip.mean > 0, slot);
});

test('with its layer the slot is drawn', async () => {
  const bare = await drawnWith(['environment']);
  const cloth = await drawnWith(['environment', 'sheen']);
  assert.equal(cloth.drawn.length - bare.drawn.length, 6, 'three slots, each alone and as the last');
  assert.ok(cloth.cell.terms.sheenAlbedo.alone.flip.mean > 0);
});

test('counts of lights are no part of the name, and what tells no features hides nothing', () => {
  assert.ok(mayShow('rectF90', ['1 rect-light']));
  assert.ok(mayShow('rectF90', ['12 rect-lights']));
  assert.ok(!mayShow('rectF90', ['sheen']));
  assert.ok(mayShow('rectF90', []));
  assert.ok(mayShow('sorting', ['sheen']), 'a slot without a condition');
  assert.ok(mayShow('clearcoat', ['sheen']), 'of another list of slots');
});
