import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { pictureWarnings } from '../../../js/api/frame_info.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { plane, without } from '../../fixtures/geometry.mjs';
import { ENVIRONMENTS, MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

const SIZE = 64;
let renderer, ball;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  ball = await renderer.load(await MODELS.ball());
});
after(() => renderer.close());

/** A sheet of one unlit colour, 1 x 1 m. */
async function sheet(baseColor, material = {}) {
  const glb = new GlbBuilder();
  glb.add(without(plane(1, 1), 'tangents', 'uvs'), glb.material({ unlit: true, baseColor, ...material }));
  return glb.bytes();
}

const lit = (more = {}) => ({
  size: { width: SIZE, height: SIZE },
  environment: 'none',
  lights: [{ type: 'ambient', intensity: 1 }],
  toneMapping: 'none',
  ...more,
});
const draw = async (model, shot) => (await renderer.render(model, lit(shot))).info;
const codes = ({ warnings }) => warnings.map(({ code }) => code).filter((code) => code === 'W_EMPTY' || code === 'W_EXPOSURE');

/** Every way in which a background comes into a picture. */
const dim = { map: ENVIRONMENTS.lamps(), intensity: 0.1 };
const BACKGROUNDS = {
  transparent: {},
  colour: { background: '#888' },
  'white, as of a jpeg': { output: { format: 'jpeg' } },
  environment: { environment: dim, background: 'environment' },
  'blurred environment': { environment: dim, background: { blur: 0.5 } },
  'colour behind an average': { background: '#888', quality: { samples: 16 } },
  'environment in an average': { environment: dim, background: 'environment', quality: { samples: 16 } },
  'transparent average': { quality: { samples: 16 } },
  'linear floats': { background: '#888', output: { format: 'exr' } },
  'one sample': { background: '#888', quality: 'draft' },
  'traced paths': { background: '#888', quality: { preset: 'reference', samples: 8 } },
  'traced paths, transparent': { quality: { preset: 'reference', samples: 8 } },
  'environment behind traced paths': { environment: dim, background: 'environment', quality: { preset: 'reference', samples: 8 } },
};
const AWAY = { position: [0, 0, 5], target: [0, 0, 9], near: 0.1, far: 50 };

for (const [name, background] of Object.entries(BACKGROUNDS)) {
  test(`coverage, and a camera that looks past the model: ${name}`, async () => {
    // A disk of 0.9 of the frame's width, and a little more: the farthest points known of a ball are corners of it.
    const { picture, warnings } = await draw(ball, background);
    assert.ok(Math.abs(picture.coverage - (Math.PI / 4) * 0.92 ** 2) < 0.03, `${picture.coverage}`);
    assert.deepEqual(warnings, []);
    const past = await draw(ball, { ...background, camera: AWAY });
    assert.equal(past.picture.coverage, 0);
    assert.deepEqual(past.warnings, [
      { code: 'W_EMPTY', message: 'the model covers 0 % of the picture: the camera looks past it, or it is too small, or see-through' },
    ]);
  });

  test(`black, white and saturated models: ${name}`, async () => {
    const floats = name === 'linear floats';
    for (const [colour, key] of [
      [[0, 0, 0, 1], 'dark'],
      [[1, 1, 1, 1], 'bright'],
      [[1, 0, 1, 1], 'saturated'],
      [[0.5, 0.4, 0.3, 1], undefined],
    ]) {
      const info = await draw(await sheet(colour), { ...background, camera: { fit: 0.8 } });
      const { coverage, ...ends } = info.picture;
      assert.ok(Math.abs(coverage - 0.64) < 0.05, `${coverage}`);
      const isMeant = key !== undefined && (!floats || key === 'dark');
      for (const [end, part] of Object.entries(ends)) {
        // Along the edge of an average the first pass alone tells the coverage.
        assert.ok(isMeant && end === key ? part > 0.9 : part === 0, `${colour}: ${JSON.stringify(ends)}`);
      }
      assert.deepEqual(codes(info), isMeant ? ['W_EXPOSURE'] : []);
    }
  });
}

test('quality high tells the same of an environment behind the model, traced or by the raster', async () => {
  const shot = { size: { width: 32, height: 32 }, environment: dim, background: 'environment', shading: 'fabric' };
  // Not a part of it is cut out, but with a cutoff the raster would take all passes, and paths cost less.
  const cutOut = editedGlb(await MODELS.ball(), (json) => {
    for (const material of json.materials) Object.assign(material, { alphaMode: 'MASK' });
  });
  for (const more of [{}, { toneMapping: 'linear', exposure: 400 }, { camera: AWAY }]) {
    const traced = await draw(cutOut, { ...shot, quality: 'high', ...more });
    const raster = await draw(cutOut, { ...shot, quality: 'standard', ...more });
    assert.deepEqual([traced.backend, raster.backend], ['reference', renderer.backend]);
    assert.deepEqual(codes(traced), codes(raster));
    // Each asks four places of a pixel, other ones: along the outline, a ninth of these pixels, one of ten may differ.
    for (const [fact, part] of Object.entries(raster.picture)) {
      assert.ok(Math.abs(traced.picture[fact] - part) < 0.015, JSON.stringify([more, fact, traced.picture, raster.picture]));
    }
    if (more.camera) assert.deepEqual(codes(traced), ['W_EMPTY']);
    if (more.exposure) assert.deepEqual(codes(traced), ['W_EXPOSURE']);
  }
});

test('where alpha does not tell the model, nothing is said', async () => {
  const { picture, warnings } = await draw(ball, { environment: dim, background: 'environment', camera: { projection: 'orthographic' } });
  assert.deepEqual([picture, warnings], [undefined, []]);
});

test('too small, and see-through', async () => {
  const shot = (height) => ({ camera: { position: [0, 0, 5], target: [0, 0, 0], height, near: 1, far: 10 } });
  assert.deepEqual(codes(await draw(ball, shot(400))), ['W_EMPTY']);
  assert.deepEqual(codes(await draw(ball, shot(20))), []);
  assert.deepEqual(codes(await draw(await sheet([1, 1, 1, 0], { alphaMode: 'BLEND' }), { background: 'red' })), ['W_EMPTY']);
  assert.deepEqual(codes(await draw(await sheet([0.2, 0.2, 0.2, 0.1], { alphaMode: 'BLEND' }), { background: 'red' })), []);
  // A mask that cuts all of it off.
  assert.deepEqual(codes(await draw(await sheet([0.2, 0.2, 0.2, 0.4], { alphaMode: 'MASK' }), {})), ['W_EMPTY']);
});

test('exposure: too much, too little, no light at all', async () => {
  const sun = [{ type: 'directional', position: [1, 2, 3], intensity: 3 }];
  for (const background of [{}, { background: 'white' }, { background: 'black' }]) {
    assert.deepEqual(codes(await draw(ball, { lights: sun, toneMapping: 'neutral', ...background })), []);
    for (const toneMapping of ['neutral', 'aces', 'linear']) {
      assert.deepEqual(codes(await draw(ball, { lights: sun, exposure: 400, toneMapping, ...background })), ['W_EXPOSURE'], toneMapping);
      assert.deepEqual(codes(await draw(ball, { lights: sun, exposure: 1e-5, toneMapping, ...background })), ['W_EXPOSURE'], toneMapping);
    }
    assert.deepEqual(codes(await draw(ball, { lights: [], ...background })), ['W_EXPOSURE']);
  }
});

test('without tone mapping bytes have no exposure in any quality, and floats have it', async () => {
  const light = async (quality, exposure, output) => {
    const { data } = await renderer.render(ball, lit({ environment: dim, quality, exposure, output: { format: 'raw', ...output } }));
    const values = output ? new Float32Array(data.buffer, data.byteOffset, data.length / 4) : data;
    return values.reduce((sum, value, i) => sum + (i % 4 === 3 ? 0 : value), 0);
  };
  for (const quality of ['standard', { samples: 16, noise: 0 }, { preset: 'reference', samples: 4 }]) {
    assert.equal(await light(quality, 4), await light(quality, 1), JSON.stringify(quality));
    const floats = (await light(quality, 4, { bitDepth: 32 })) / (await light(quality, 1, { bitDepth: 32 }));
    assert.ok(Math.abs(floats - 4) < 1e-4, `${floats} of ${JSON.stringify(quality)}`);
  }
});

test('shadows on the ground are no part of the model', async () => {
  const shadow = {
    ground: { opacity: 0.6 },
    lights: [{ type: 'ambient' }, { type: 'directional', position: [-1, 2, -2], castShadow: true }],
    camera: { view: 'three-quarter' },
  };
  for (const background of [{}, { background: 'white' }, { environment: dim, background: 'environment' }, { background: 'white', quality: { samples: 16 } }]) {
    const [without, withGround] = [
      await draw(ball, { ...shadow, ...background, ground: 'none', camera: { view: 'three-quarter', fit: 0.4 } }),
      await draw(ball, { ...shadow, ...background, camera: { view: 'three-quarter', frame: 'model', fit: 0.4 } }),
    ];
    assert.ok(Math.abs(without.picture.coverage - withGround.picture.coverage) < 0.004, JSON.stringify([background, without.picture, withGround.picture]));
    assert.deepEqual(codes(withGround), []);
  }
});

test('messages say what and how much', () => {
  const said = (picture) => pictureWarnings({ coverage: 0.5, dark: 0, bright: 0, saturated: 0, ...picture }).map(({ code, message }) => `${code} ${message}`);
  assert.deepEqual(said({}), []);
  assert.deepEqual(said({ coverage: 0.001 }), []);
  assert.deepEqual(said({ coverage: 0.00042 }), [
    'W_EMPTY the model covers 0.042 % of the picture: the camera looks past it, or it is too small, or see-through',
  ]);
  assert.deepEqual(said({ dark: 0.2, bright: 0.2, saturated: 0.1 }), []);
  assert.deepEqual(said({ dark: 0.614, bright: 0.1, saturated: 0.006 }), [
    'W_EXPOSURE 72 % of the model shows no shading: 61 % is black, 10 % white, 0.6 % saturated; change shot.exposure, the lights or the environment',
  ]);
  assert.deepEqual(pictureWarnings(undefined), []);
});
