import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import * as THREE from 'three';
import { NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS } from '@gltf-transform/extensions';
import { inspect } from '../../../js/index.mjs';
import { factsOf } from '../../../js/three/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';

/** The scene of a GLB as plain three.js objects, without its pictures. */
async function sceneOf(bytes) {
  const document = await new NodeIO().registerExtensions(ALL_EXTENSIONS).readBinary(bytes);
  const scene = new THREE.Group();
  for (const node of document.getRoot().listNodes()) {
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.BufferAttribute(primitive.getAttribute('POSITION').getArray(), 3));
      if (primitive.getIndices()) geometry.setIndex(new THREE.BufferAttribute(primitive.getIndices().getArray(), 1));
      const mesh = new THREE.Mesh(geometry);
      mesh.matrixAutoUpdate = false;
      mesh.matrix.fromArray(node.getWorldMatrix());
      scene.add(mesh);
    }
  }
  return scene;
}

const models = {
  transforms: MODELS.transforms,
  boxes: MODELS.boxes,
  tshirt: async () => readFileSync(new URL('../../../js/assets/tshirt.glb', import.meta.url)),
};
for (const [name, make] of Object.entries(models)) {
  test(`browser and server measure ${name} alike`, async () => {
    const bytes = await make();
    const server = await inspect(bytes);
    const browser = factsOf({ scene: await sceneOf(bytes) }, { THREE });
    const close = (a, b) => a.every((x, i) => Math.abs(x - b[i]) < 1e-6);
    assert.ok(close(server.bounds.min, browser.bounds.min) && close(server.bounds.max, browser.bounds.max));
    assert.ok(server.outline.length >= 8, `${server.outline.length} points`);
    // Rounding may choose another of two points that lie equally far: what they span must agree.
    for (const direction of [
      [1, 0, 0],
      [0, 1, 0],
      [0.3, -0.8, 0.5],
      [-0.6, 0.1, 0.8],
    ]) {
      const reach = (points) => Math.max(...points.map((p) => p[0] * direction[0] + p[1] * direction[1] + p[2] * direction[2]));
      assert.ok(Math.abs(reach(server.outline) - reach(browser.outline)) < 1e-3, `${direction}`);
    }
  });
}
