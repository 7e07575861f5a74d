import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { resolveShot } from '../../../js/shot/index.mjs';
import { applyShot } from '../../../js/three/index.mjs';

const box = { min: [-1, 0, -1], max: [1, 2, 1] };
const resolve = (shot) => resolveShot({ environment: 'none', ...shot }, box);

function stage() {
  const renderer = { shadowMap: { enabled: false, type: THREE.BasicShadowMap }, setPixelRatio() {}, setSize() {}, setClearColor() {} };
  const model = { scene: new THREE.Group().add(new THREE.Mesh(), new THREE.Line()), parser: { json: {}, associations: new Map() } };
  const scene = new THREE.Scene().add(model.scene);
  const apply = (shot) => applyShot(resolve(shot), { THREE, renderer, scene, model });
  const find = (predicate) => {
    const found = [];
    scene.traverse((object) => predicate(object) && found.push(object));
    return found;
  };
  return { renderer, model, scene, apply, find };
}

const LIGHTS = [
  { type: 'directional', position: [1, 3, 2], castShadow: true, shadow: { intensity: 0.5 } },
  { type: 'spot', position: [1, 3, 2], castShadow: true, shadow: { mapSize: 256 } },
  { type: 'point', position: [1, 3, 2], castShadow: true },
  { type: 'point', position: [0, 3, 0] },
];

test("every setting of a shadow is the shot's", async () => {
  const { renderer, apply, find } = stage();
  await apply({ lights: LIGHTS });
  assert.deepEqual(renderer.shadowMap, { enabled: true, type: THREE.PCFShadowMap });
  const lights = find(({ isLight }) => isLight);
  resolve({ lights: LIGHTS }).lights.forEach(({ castShadow, shadow }, i) => {
    assert.equal(lights[i].castShadow, castShadow);
    if (!castShadow) return;
    const { mapSize, near, far, left, right, bottom, top, ...rest } = shadow;
    const set = lights[i].shadow;
    for (const [key, value] of Object.entries(rest)) assert.equal(set[key], value, key);
    assert.deepEqual(set.mapSize.toArray(), [mapSize, mapSize]);
    assert.deepEqual(
      [set.camera.near, set.camera.far, set.camera.left, set.camera.right, set.camera.bottom, set.camera.top],
      [near, far, left, right, bottom, top],
    );
  });
});

test('meshes cast and receive only where a light casts', async () => {
  const { renderer, model, apply } = stage();
  const [mesh, line] = model.scene.children;
  await apply({ lights: LIGHTS });
  assert.deepEqual([mesh.castShadow, mesh.receiveShadow, line.castShadow], [true, true, false]);
  await apply({ lights: [{ type: 'point' }] });
  assert.deepEqual([mesh.castShadow, mesh.receiveShadow, renderer.shadowMap.enabled], [false, false, false]);
});

test('the ground faces up at its place, is drawn first, and is replaced by the next shot', async () => {
  const { apply, find } = stage();
  await apply({ ground: { opacity: 0.75 } });
  await apply({ ground: { opacity: 0.25 } });
  const grounds = find(({ material }) => material?.isShadowMaterial);
  assert.equal(grounds.length, 1);
  const [{ geometry, material, position, renderOrder, receiveShadow, castShadow }] = grounds;
  const { ground } = resolve({ ground: {} });
  assert.deepEqual([material.opacity, material.depthWrite, renderOrder, receiveShadow, castShadow], [0.25, false, -1, true, false]);
  assert.deepEqual(position.toArray(), ground.position);
  geometry.computeBoundingBox();
  const size = geometry.boundingBox.getSize(new THREE.Vector3());
  assert.deepEqual([size.x, size.z], ground.size.map(Math.fround));
  geometry.computeVertexNormals();
  assert.equal(geometry.attributes.normal.getY(0), 1);
  await apply({});
  assert.equal(find(({ material: m }) => m?.isShadowMaterial).length, 0);
});

test('lights of the last shot are disposed of, with their shadow maps', async () => {
  const { apply, find } = stage();
  await apply({ lights: LIGHTS });
  let disposed = 0;
  for (const light of find(({ isLight }) => isLight)) light.shadow.dispose = () => disposed++;
  await apply({ lights: LIGHTS });
  assert.equal(disposed, 4);
});
