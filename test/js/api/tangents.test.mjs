// Vertices whose tangent has no length: no seam, in the raster and in the path tracer.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { compareImages } from '../../../js/compare/index.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

const SIZE = { width: 128, height: 128 };
const LIGHTS = [
  { type: 'ambient', intensity: 0.3 },
  { type: 'directional', position: [2, 3, 2.5], intensity: 2.5 },
];
const WAYS = {
  'shading three': { shading: 'three' },
  'shading fabric': { shading: 'fabric' },
  'the path tracer': { shading: 'fabric', quality: { preset: 'reference', transport: 'direct', samples: 16 } },
};

let renderer;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
});
after(() => renderer.close());

for (const [name, way] of Object.entries(WAYS)) {
  test(`${name} draws a bumpy ring without a seam where some or all of its tangents have no length`, async () => {
    const shot = { size: SIZE, environment: 'none', lights: LIGHTS, output: { format: 'raw' }, ...way };
    const draw = async (kind) => ({ ...SIZE, data: (await renderer.render(await MODELS[`known-tangents-${kind}`](), shot)).data });
    const [all, some, none, absent] = await Promise.all(['all', 'some', 'none', 'absent'].map(draw));
    const apart = (a, b) => compareImages(a, b).object.flip.mean;
    // The same frame but for the order of its arithmetic.
    assert.ok(apart(absent, none) < 1e-3, `FLIP ${apart(absent, none)} from a mesh without tangents`);
    // The frame of texture coordinates keeps their stretch, which vertex tangents do not have: a tenth above that is left for the mixture.
    const least = apart(all, absent);
    assert.ok(apart(all, some) < 1.1 * least, `FLIP ${apart(all, some)} from all tangents, ${least} without any`);
  });
}
