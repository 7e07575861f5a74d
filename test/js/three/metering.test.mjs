import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { lensExposure } from '../../../js/shot/lens_exposure.mjs';
import { meteredExposure } from '../../../js/shot/metering.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { applyMetering } from '../../../js/three/metering.mjs';

const LENS = { aperture: 16, shutter: 1 / 400, iso: 100 };
const BOUNDS = { min: [-1, -1, -1], max: [1, 1, 1] };
const shotOf = (lens) => resolveShot({ size: { width: 8, height: 4 }, lens, metering: { least: 0.001, most: 1000 } }, BOUNDS);

/** What applyMetering uses of a WebGLRenderer, of a scene whose radiance is the same all over. */
function rendererOf(radiance, alpha, extensions) {
  const drawn = { target: null, types: [] };
  return {
    drawn,
    toneMappingExposure: 1,
    extensions: { has: (name) => extensions.includes(name) },
    getRenderTarget: () => null,
    setRenderTarget: (target) => {
      drawn.target = target;
    },
    clear() {},
    render() {},
    readRenderTargetPixels(target, x, y, width, height, texels) {
      const { type } = target.texture;
      drawn.types.push(type);
      // A half above 65504 is infinite; toHalfFloat of three.js would cap it.
      const half = (value) => (value > 65504 ? 0x7c00 : THREE.DataUtils.toHalfFloat(value));
      const pixel = [radiance * alpha, radiance * alpha, radiance * alpha, alpha].map(type === THREE.FloatType ? (value) => value : half);
      for (let i = 0; i < width * height; i++) texels.set(pixel, 4 * i);
    },
  };
}

const FLOATS = ['EXT_color_buffer_float', 'EXT_float_blend'];
function metered(shot, radiance, { alpha = 1, extensions = FLOATS } = {}) {
  const renderer = rendererOf(radiance, alpha, extensions);
  applyMetering(shot, { THREE, renderer, scene: new THREE.Scene(), camera: new THREE.PerspectiveCamera() });
  assert.equal(renderer.drawn.target, null, 'the target that was set is set again');
  return { factor: renderer.toneMappingExposure, type: renderer.drawn.types[0] };
}
const isNear = (actual, expected, tolerance = 1e-6) => assert.ok(Math.abs(actual / expected - 1) < tolerance, `${actual}, expected ${expected}`);

test('with a lens the light is metered that halves do not hold, as it dims it', () => {
  const { level } = shotOf(LENS).metering;
  for (const radiance of [1e3, 1e5, 1e7]) {
    for (const alpha of [1, 0.75]) {
      const { factor, type } = metered(shotOf(LENS), radiance, { alpha });
      assert.equal(type, THREE.FloatType);
      isNear(factor, level / (radiance * lensExposure(LENS)));
    }
  }
});

test('where floats cannot be drawn, it is that of the brightest half', () => {
  const { level } = shotOf(LENS).metering;
  for (const extensions of [[], [FLOATS[0]]]) {
    const { factor, type } = metered(shotOf(LENS), 1e5, { extensions });
    assert.equal(type, THREE.HalfFloatType);
    isNear(factor, level / (65504 * lensExposure(LENS)));
  }
});

test('without the exposure of a lens halves are read as they are, and at most as the server has them', () => {
  for (const lens of [null, { aperture: 4 }]) {
    const shot = shotOf(lens);
    for (const radiance of [0.01, 0.5, 3.3]) {
      const { factor, type } = metered(shot, radiance);
      assert.equal(type, THREE.HalfFloatType);
      const light = THREE.DataUtils.fromHalfFloat(THREE.DataUtils.toHalfFloat(radiance));
      assert.equal(factor, meteredExposure(shot, [light, light, light, 1]));
    }
  }
  const wide = resolveShot({ size: { width: 8, height: 4 }, metering: { level: 1000, least: 0.001 } }, BOUNDS);
  isNear(metered(wide, 1e6).factor, 1000 / 65504);
});
