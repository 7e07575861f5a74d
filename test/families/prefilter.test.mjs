// What real releases before 0.187 prefilter an environment to, against telar's, and what they draw of it as a background.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../js/index.mjs';
import { resolveThree } from '../../js/shot/three_terms.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { gradient, hdr, hotTexels, lamps } from '../fixtures/environment.mjs';
import { makeCase } from '../parity/make_case.mjs';
import { withMap } from '../parity/tool.mjs';
import { atlasOfTelar, distances, openRelease } from './atlas.mjs';

/** Widths that are a power of two and that are none: a face has the largest power of two below a quarter of the width. */
const MAPS = { 'lamps 256': lamps(256), 'hot texels 300': hotTexels(300), 'gradient 70': gradient(70) };

/** The same instructions on the same Mesa. */
const EXACT = { equal: 1, relative: 0 };

/** The GGX chains read at places in fp32, which differ in their last bits by the order of operations. Where a bright texel lies
 *  beside a dark one, that cuts a half to the next one, 2^-10 away, and the level after it takes that on. Measured: 0.962 of the
 *  halves at least are equal, and none is farther than one. */
const LAST_HALF = { equal: 0.9, relative: 2 * 2 ** -10 };

/** Releases, and of each slot that concerns it the term most like its own: the planted fault. */
const RELEASES = [
  { revision: 186, bar: LAST_HALF, faults: [{ prefilter: 'ggx-chain' }] },
  { revision: 185, bar: LAST_HALF, faults: [{ prefilter: 'ggx-chain-interpolated' }, { prefilter: 'ggx-chain-floor' }] },
  { revision: 181, bar: LAST_HALF, faults: [{ prefilter: 'ggx-chain' }] },
  { revision: 180, bar: EXACT, faults: [{ prefilter: 'blur' }, { samplerPrecision: 'lowp' }] },
  { revision: 163, bar: EXACT, faults: [{ prefilter: 'blur-from-end' }] },
  { revision: 160, bar: EXACT, faults: [{ samplerPrecision: 'highp' }] },
];

/** Of the release that has two tests; the others are pages beside it. */
let shared;
before(async () => {
  shared = await openRelease(160);
});
after(() => shared.browser.close());

const isWithin = (rows, bar) => rows.every(({ equal, relative }) => equal >= bar.equal && relative <= bar.relative);

for (const { revision, bar, faults } of RELEASES) {
  test(`the atlas of 0.${revision}`, async (t) => {
    const release = revision === 160 ? shared : await openRelease(revision, shared.browser);
    if (release !== shared) t.after(() => release.browser.close());
    for (const [name, map] of Object.entries(MAPS)) {
      const theirs = await release.atlas(map);
      const rows = distances(theirs, await atlasOfTelar(map, revision));
      assert.ok(isWithin(rows, bar), `${name}: ${JSON.stringify(rows)}`);
      if (map !== MAPS['lamps 256']) continue;
      for (const fault of faults) {
        assert.ok(!isWithin(distances(theirs, await atlasOfTelar(map, revision, fault)), bar), `${name}: ${JSON.stringify(fault)} is not seen`);
      }
    }
  });
}

/** Largest difference of two pictures of RGBA8 where a third, without background, has nothing; in 1/255. */
function worstBehind(a, b, mask) {
  let worst = 0;
  for (let i = 0; i < mask.length; i += 4) {
    if (mask[i + 3] === 0) for (let c = 0; c < 3; c++) worst = Math.max(worst, Math.abs(a[i + c] - b[i + c]));
  }
  return worst;
}

test('the background of 0.160, sharp and blurred, and turned', async (t) => {
  const { browser } = shared;
  const renderer = await createRenderer({ cacheDirectory: null });
  t.after(() => renderer.close());
  // Columns of four texels: a cube of half the rows shows their edges softer, and a blur leaves some of them.
  const map = hdr(256, (_, u) => (Math.floor(u * 64) % 2 ? [2, 2, 2] : [0, 0, 0]));
  const model = await MODELS.ball();
  for (const [blur, rotation, fault] of [
    [0, 0, { backgroundCube: 'full' }],
    [0.1, 0, { prefilter: 'cube' }],
    // 21.3 columns: 21.
    [0, 30, { environmentRotation: 'direction' }],
    [0.1, 30, { environmentRotation: 'direction' }],
  ]) {
    const { shot: asked } = makeCase('background', 'ball', 'lamps', {
      size: 96,
      toneMapping: 'reinhard',
      camera: 'front',
      background: blur ? { blur } : 'environment',
      environmentSettings: { rotation },
    });
    const { image, mask } = await browser.draw({ shot: asked, model, environment: map });
    const off = async (swaps) => {
      const shading = resolveThree({ base: 'three', revision: 160, ...swaps });
      const { data } = await renderer.render(model, withMap({ ...asked, shading }, map));
      return worstBehind(image, data, mask);
    };
    // Both read the same texels; what comes of them may round to either side.
    assert.ok((await off({})) <= 1, `blur ${blur}, turned by ${rotation}`);
    assert.ok((await off(fault)) > 4, `blur ${blur}, turned by ${rotation}: ${JSON.stringify(fault)} is not seen`);
  }
});
