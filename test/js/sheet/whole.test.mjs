// Views of a sheet show all of the garment, from every side: no picture ends in the midst of cloth.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { trueView } from '../../../js/sheet/scale.mjs';
import { shownBy } from '../../../js/sheet/shown.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { jacket } from '../../fixtures/garments/index.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

/** White around the garment: two pixels here, of which edges that are smooth reach into one. */
const MARGIN = 0.5;
const PPI = 2 * (25.4 / MARGIN);
/** Millimetres of the longer side on paper. */
const LONGEST = 100;

/** Covered pixels at the border of the picture of an extent, and in the ring within it. */
async function bordersOf({ model, extent }) {
  const ratio = (1000 * Math.max(extent.width, extent.height)) / LONGEST;
  const { size, camera } = trueView(extent, { ratio, ppi: PPI, margin: MARGIN });
  const shot = { size, camera, background: 'transparent', quality: 'draft', environment: 'none', output: { format: 'raw' } };
  const { data, info } = await renderer.render(model, shot);
  const covered = (ring) => {
    let count = 0;
    for (let y = ring; y < info.height - ring; ++y)
      for (let x = ring; x < info.width - ring; ++x) {
        const isEdge = x === ring || y === ring || x === info.width - 1 - ring || y === info.height - 1 - ring;
        if (isEdge && data[4 * (y * info.width + x) + 3] > 0) count += 1;
      }
    return count;
  };
  return [0, 1, 2, 3].map(covered);
}

/** Views from all around, level and from above. */
const AROUND = [0, 20, -15].flatMap((elevation) =>
  Array.from({ length: 24 }, (_, i) => ({ azimuth: 15 * i - 175, elevation, explode: 0, ghost: [], variant: '' })),
);

for (const [name, bytesOf] of [
  ['T-shirt', () => readFile(new URL('../../../js/assets/tshirt.glb', import.meta.url))],
  ['jacket', jacket],
])
  test(`no picture of the ${name} is cut off, and none has more room than it needs`, async () => {
    const model = await renderer.load(await bytesOf());
    const views = [...AROUND, { view: 'three-quarter', explode: 0, ghost: [], variant: '' }, { ...AROUND[5], explode: 0.08 }];
    for (const [i, shown] of (await shownBy(views, model)).entries()) {
      const [border, ...within] = await bordersOf(shown);
      const what = `${name} ${JSON.stringify(views[i])}: ${border} at the border, ${within} within`;
      assert.equal(border, 0, what);
      assert.ok(
        within.some((count) => count > 0),
        what,
      );
    }
  });

test('what a view leaves out has no room, what a variant or a scale of a node changes has its own', async () => {
  const builder = new GlbBuilder();
  const cloth = builder.material({ name: 'cloth', doubleSided: true });
  builder.add(plane(0.4, 0.6), cloth, { name: 'body', scale: [2, 1, 1] });
  builder.add(plane(1, 1.8), cloth, { name: 'mannequin', translation: [0, 0, -0.3] });
  const model = await renderer.load(await builder.bytes());
  const view = { azimuth: 60, elevation: 0, explode: 0, variant: '' };
  const [all, alone] = await shownBy(
    [
      { ...view, ghost: [] },
      { ...view, ghost: [{ node: 'manne*', opacity: 0 }] },
    ],
    model,
  );
  // Seen from 60 degrees aside a plane is half as wide; the mannequin stands 0.3 m behind the body.
  assert.ok(Math.abs(alone.extent.width - 0.4) < 1e-6, `${alone.extent.width}`);
  assert.ok(Math.abs(all.extent.width - (0.2 + 0.25 + 0.3 * Math.sin(Math.PI / 3))) < 1e-6, `${all.extent.width}`);
  assert.ok(all.extent.height > 1.79 && Math.abs(alone.extent.height - 0.6) < 1e-6);
});
