// telar's text of stock three.js within three.js: what js/three puts a shading's text into, apart from what a shading does.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from './browser/chromium.mjs';
import { GATE_CASES } from './cases.mjs';
import { loadInputs } from './inputs.mjs';
import { difference } from './metrics.mjs';

/** Everything that the text reads of three.js: maps, lights, shadows, layers, skins, instances, transmission. */
const CASES = process.env.TELAR_TEXT_CASES?.split(' ') ?? [
  'sweep-sun', 'sweep-gradient', 'cloth-env', 'light-hemisphere', 'light-spot', 'lights-many', 'shadow-everything', 'shadow-point',
  'physical-everything-lights', 'physical-everything-ortho', 'sheen-env', 'sheen-sun', 'clearcoat-two-normals-env', 'anisotropy-map-tangents-env',
  'anisotropy-derivatives-env', 'iridescence-metal-furnace', 'diffuse-roughness-sheen-env', 'rect-everything', 'transmission-layers-lit',
  'transmission-dispersion-lit', 'occlusion-map-env', 'transforms-env', 'flat-shading-env', 'alpha-mask-env', 'alpha-blend-env', 'morph-and-skin-0-0.6',
  'instances-colors-rest', 'vertex-colors-env', 'emissive-strength-env', 'odd-slots-env', 'mirrored-uvs-layers-env', 'variant-red',
];

let browser;
before(async () => (browser = await Browser.start()));
after(() => browser?.close());

const names = CASES[0] === 'all' ? GATE_CASES.map(({ name }) => name) : CASES;
for (const name of names) {
  test(`the same picture by three.js's text and by telar's: ${name}`, async (t) => {
    const item = GATE_CASES.find((candidate) => candidate.name === name);
    assert.ok(item, `the gate has a case ${name}`);
    const input = { shot: item.shot, textures: item.textures, ...(await loadInputs(item)) };
    const { width, height, image, mask } = await browser.draw(input);
    const own = await browser.draw({ ...input, ownText: true });
    const background = item.shot.background !== 'transparent';
    const { interior, edge, verdict } = difference({ expected: image, actual: own.image, mask, width, height, background });
    t.diagnostic(`interior ${interior?.max}/255, edge ${edge?.max}/255`);
    assert.ok(own.facts.replaced > 0, 'a material is shaded by telar\'s text');
    assert.ok(verdict.pass, JSON.stringify(verdict.checks));
  });
}
