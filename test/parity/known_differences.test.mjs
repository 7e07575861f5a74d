// Each entry of known_differences.mjs: three.js's fault in the real browser, and telar's picture of the same shot.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from './browser/chromium.mjs';
import { CASES } from './cases.mjs';
import { KNOWN_CASES, KNOWN_DIFFERENCES, LIT_PIXEL } from './known_differences.mjs';
import { loadInputs } from './inputs.mjs';
import { openServer } from './server.mjs';

let browser;
let server;
before(async () => ([browser, server] = await Promise.all([Browser.start(), openServer()])));
after(() => Promise.all([browser?.close(), server?.close()]));

/**
 * Both sides of a case: pictures, RGBA8, premultiplied, top row first; and quantities of three's and telar's shading,
 * RGBA fp32, alpha 1 on the object.
 */
async function draw(name) {
  const item = KNOWN_CASES.find((candidate) => candidate.name === name);
  const input = { shot: item.shot, ...(await loadInputs(item)) };
  const names = ['n', 'direct', 'linear'];
  const { image, facts } = await browser.draw(input);
  assert.equal(facts.three, '187');
  const three = { image, ...(await browser.terms({ ...input, terms: names })) };
  const telar = { image: await server.draw(input), ...(await server.debug(input, names)) };
  assert.equal(notNumbers(telar.linear), 0, 'telar stays finite');
  assert.ok(telar.linear.every((value) => value >= 0));
  return { three, telar, width: item.shot.size.width };
}

const isObject = (pixels, i) => pixels[i + 3] > 0;

/** How many pixels of the object have a component that is not a number. */
function notNumbers(values) {
  let count = 0;
  for (let i = 0; i < values.length; i += 4) {
    if (isObject(values, i) && !values.subarray(i, i + 3).every(Number.isFinite)) count++;
  }
  return count;
}

/** The red channel of an image over the pixels that the object covers whole. */
const reds = (image) =>
  Array.from({ length: image.length / 4 }, (_, i) => i * 4)
    .filter((i) => image[i + 3] === 255)
    .map((i) => image[i]);
const share = (list, condition) => list.filter(condition).length / list.length;
const spread = (list) => Math.max(...list) - Math.min(...list);
const furthest = (a, b) => a.reduce((worst, value, i) => Math.max(worst, Math.abs(value - b[i])), 0);

const CHECKS = {
  async 'known-anisotropy-no-uvs-sun'() {
    const { three, telar } = await draw('known-anisotropy-no-uvs-sun');
    assert.ok(notNumbers(three.direct) > 0, 'three.js has pixels that are not numbers');
    assert.ok(share(reds(three.image), (red) => red > 250) > 0.5, 'and a highlight nearly everywhere');
    assert.ok(share(reds(telar.image), (red) => red > 250) < 0.1);
    assert.ok(spread(reds(telar.image)) > 100, 'telar has a highlight somewhere');
  },
  async 'known-anisotropy-no-uvs-env'() {
    const { three, telar } = await draw('known-anisotropy-no-uvs-env');
    const nearMedian = (image) => {
      const list = reds(image).sort((a, b) => a - b);
      return share(list, (red) => Math.abs(red - list[list.length >> 1]) <= 4);
    };
    assert.ok(nearMedian(three.image) > 0.8, 'three.js shows one colour of the environment');
    assert.ok(nearMedian(telar.image) < 0.3, 'telar shows the environment');
  },
  async 'known-sheen-roughness-zero'() {
    const { three, telar, width } = await draw('known-sheen-roughness-zero');
    assert.ok(notNumbers(three.direct) > (width * width) / 20, `${notNumbers(three.direct)} pixels of three.js are not numbers`);
    let compared = 0;
    for (let i = 0; i < three.direct.length; i += 4) {
      if (!isObject(three.direct, i) || !three.direct.subarray(i, i + 3).every(Number.isFinite)) continue;
      compared++;
      for (let c = 0; c < 3; c++) assert.ok(Math.abs(three.direct[i + c] - telar.direct[i + c]) <= 1e-4 + 1e-3 * three.direct[i + c]);
    }
    assert.ok(compared > (width * width) / 20, 'and elsewhere both agree');
  },
  async 'known-light-on-surface'() {
    const { three, telar, width } = await draw('known-light-on-surface');
    const lit = (LIT_PIXEL[1] * width + LIT_PIXEL[0]) * 4;
    assert.equal(notNumbers(three.direct), 1, 'one pixel of three.js is not a number');
    assert.ok(Number.isNaN(three.direct[lit]));
    assert.ok(Math.max(...three.image.subarray(lit, lit + 3)) === 0, 'and black');
    assert.ok(telar.image[lit] > 50);
    assert.ok(Math.abs(telar.image[lit] - telar.image[lit + 4]) <= 1, 'telar shows what is beside it');
    three.image.copyWithin(lit, lit + 4, lit + 8);
    assert.ok(furthest(telar.image, three.image) <= 1, 'elsewhere both agree');
  },
  async 'known-flattened'() {
    const { three, telar } = await draw('known-flattened');
    const covered = reds(three.image).length;
    assert.equal(
      share(reds(three.image), (red) => red === 0),
      1,
      'three.js shows a black disc',
    );
    assert.ok(notNumbers(three.n) >= covered, 'whose normals are not numbers');
    assert.equal(reds(telar.image).length, covered);
    assert.ok(spread(reds(telar.image)) <= 8 && Math.min(...reds(telar.image)) > 100, 'telar shows a flat one');
  },
  async 'known-shared-texture'() {
    const { three, telar } = await draw('known-shared-texture');
    const apart = (await draw('known-shared-texture-apart')).telar.image;
    assert.deepEqual(telar.image, apart);
    assert.ok(furthest(three.image, apart) > 20, `three.js is ${furthest(three.image, apart)}/255 from the same image in two textures`);
  },
  async 'known-shared-texture-apart'() {
    const { three, telar } = await draw('known-shared-texture-apart');
    assert.ok(furthest(telar.image, three.image) <= 1, 'of two textures both agree');
  },
  async 'known-rect-head-on'() {
    const { three, telar } = await draw('known-rect-head-on');
    assert.equal(Math.max(...reds(three.image)), 0, 'three.js loses the light');
    const aside = (await draw('known-rect-aside')).three.image;
    assert.ok(Math.min(...reds(aside)) > 50, 'and has it a hundredth of a degree aside');
    assert.ok(furthest(telar.image, aside) <= 1, 'which is what telar shows');
  },
  async 'known-rect-aside'() {
    const { three, telar } = await draw('known-rect-aside');
    assert.ok(furthest(telar.image, three.image) <= 1);
  },
  async 'known-tangents-all'() {
    const { three, telar } = await draw('known-tangents-all');
    assert.ok(furthest(telar.image, three.image) <= 1, 'with all tangents both agree');
  },
  async 'known-tangents-some'() {
    const { three, telar } = await draw('known-tangents-some');
    const [lost, total] = [notNumbers(three.n), reds(three.image).length];
    assert.ok(lost > 0.3 * total && lost < 0.9 * total, `three.js loses the direct light of ${lost} of ${total} pixels`);
    const whole = (await draw('known-tangents-all')).telar.image;
    assert.ok(
      furthest(telar.image, whole) < 60 && furthest(three.image, whole) > 120,
      'telar shows the ring that has them all, but for the stretch of its texture',
    );
  },
  async 'known-tangents-none'() {
    const { three, telar } = await draw('known-tangents-none');
    assert.ok(spread(reds(three.image)) < 10, 'three.js shows a disc of ambient light');
    assert.ok(spread(reds(telar.image)) > 100);
  },
  'known-ktx2-etc1s': () => checkTranscoded('known-ktx2-etc1s'),
  'known-ktx2-uastc': () => checkTranscoded('known-ktx2-uastc'),
  // Uncompressed, KTX2Loader has too few texels for the size that it pads this one to.
  'known-ktx2-odd-size': () => checkTranscoded('known-ktx2-odd-size', { uncompressed: false }),
};

/** A texture that the browser transcodes: all of the difference is in its texels. */
async function checkTranscoded(name, { uncompressed = true } = {}) {
  const item = KNOWN_CASES.find((candidate) => candidate.name === name);
  const input = { shot: item.shot, ...(await loadInputs(item)) };
  const telar = await server.draw(input);
  const transcoded = furthest(telar, (await browser.draw(input)).image);
  assert.ok(transcoded > 2 && transcoded <= 10, `transcoded, three.js is ${transcoded}/255 away`);
  if (!uncompressed) return;
  assert.ok(furthest(telar, (await browser.draw({ ...input, textures: 'uncompressed' })).image) <= 1);
}

for (const { name, cases } of KNOWN_DIFFERENCES) {
  for (const item of cases) test(`${item}: ${name}`, CHECKS[item]);
}

test('the list is whole, and the gate has none of its cases', () => {
  const named = KNOWN_DIFFERENCES.flatMap(({ cases }) => cases);
  assert.deepEqual([...named].sort(), KNOWN_CASES.map(({ name }) => name).sort());
  assert.deepEqual([...named].sort(), Object.keys(CHECKS).sort());
  for (const entry of KNOWN_DIFFERENCES) {
    for (const key of ['name', 'three', 'telar', 'source']) assert.ok(entry[key].length > 10, `${key} of ${entry.name}`);
  }
  assert.deepEqual(
    CASES.filter(({ name }) => named.includes(name)),
    [],
  );
});
