import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { bakedTexture } from '../../../js/three/shading/texture_bake.mjs';

// What is kept of the textures that are made anew. The texels themselves: test/parity.

/** The part of WebGLRenderer that draws into a target, without GL. */
function fakeRenderer() {
  const nothing = () => null;
  return {
    drawn: 0,
    properties: {},
    extensions: { has: () => true },
    xr: { enabled: false },
    shadowMap: { autoUpdate: true },
    getRenderTarget: nothing,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
    setRenderTarget: nothing,
    render() {
      this.drawn += 1;
    },
  };
}

const textureOf = () => new THREE.DataTexture(new Uint8Array(64), 4, 4);

/** Whether the texture is made anew. */
function isBaked(renderer, source, kind, other) {
  const before = renderer.drawn;
  bakedTexture(THREE, {}, renderer, kind, source, other);
  return renderer.drawn > before;
}

test('a texture is made once, and anew where it or one beside it was changed', () => {
  const renderer = fakeRenderer();
  const [source, beside] = [textureOf(), textureOf()];
  const bake = () => isBaked(renderer, source, 'metal', { beside });
  assert.deepEqual([bake(), bake()], [true, false]);
  for (const changed of [source, beside]) {
    changed.needsUpdate = true;
    assert.deepEqual([bake(), bake()], [true, false]);
  }
});

test('of cutoffs that a fade goes through the last ones are kept', () => {
  const renderer = fakeRenderer();
  const source = textureOf();
  const bake = (cutoff) => isBaked(renderer, source, 'coverage', { cutoff });
  for (let i = 0; i < 60; i++) assert.equal(bake(i / 100), true);
  assert.equal(bake(0.59), false);
  assert.equal(bake(0.55), false);
  assert.equal(bake(0.1), true, 'it went');
});

test('a lost context that is back has none of them: three.js has other properties then', () => {
  const renderer = fakeRenderer();
  const source = textureOf();
  assert.deepEqual([isBaked(renderer, source, 'relief'), isBaked(renderer, source, 'relief')], [true, false]);
  renderer.properties = {};
  assert.equal(isBaked(renderer, source, 'relief'), true);
});
