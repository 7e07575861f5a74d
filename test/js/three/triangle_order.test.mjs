import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { drawFarToNear, isOrdered } from '../../../js/three/shading/triangle_order.mjs';

// The pictures themselves: test/parity/cases_materials.mjs.

/** Triangles across the view at these places along z, whose corners have places of their own. */
function geometryAt(places) {
  const positions = places.flatMap((z) => [0, 0, z, 1, 0, z, 0, 1, z]);
  return new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
}

/** The camera looks along -z. */
const SEEING = { perspective: new THREE.PerspectiveCamera(), orthographic: new THREE.OrthographicCamera() };

/** Draws a mesh that stands 10 m before the camera, and tells the triangles in the order of the index that it is drawn by. */
function orderOf(geometry, { camera = SEEING.perspective, mesh = new THREE.Mesh(geometry), group = null } = {}) {
  mesh.modelViewMatrix.makeTranslation(0, 0, -10);
  drawFarToNear(THREE, [null, null, camera, geometry, mesh, group]);
  return Array.from({ length: geometry.index.count / 3 }, (_, i) => geometry.index.getX(3 * i) / 3);
}

for (const [name, camera] of Object.entries(SEEING)) {
  test(`triangles are drawn far to near, those of one place as the file has them, ${name}`, () => {
    const geometry = geometryAt([1, -1, 2, 0, -1, 1]);
    assert.deepEqual(orderOf(geometry, { camera }), [1, 4, 3, 0, 5, 2]);
    for (let i = 0; i < geometry.index.count; i++) assert.equal(geometry.index.getX(i) % 3, i % 3, 'corners stay in order');
  });
}

test('by the distance from the eye in a perspective, along the view without one', () => {
  // The first lies nearer along the view, and far aside.
  const geometry = geometryAt([1, 0]);
  for (let i = 0; i < 3; i++) geometry.attributes.position.setX(i, 50);
  assert.deepEqual(orderOf(geometry), [0, 1]);
  assert.deepEqual(orderOf(geometry, { camera: SEEING.orthographic }), [1, 0]);
});

test('a geometry has its own index again after a draw that did not end, also where two meshes share it', async () => {
  for (const index of [null, new THREE.BufferAttribute(new Uint16Array([3, 4, 5, 0, 1, 2]), 1)]) {
    const geometry = geometryAt([1, -1]).setIndex(index);
    const [first, second] = [new THREE.Mesh(geometry), new THREE.Mesh(geometry)];
    for (const mesh of [first, second, first]) assert.deepEqual(orderOf(geometry, { mesh }), [1, 0]);
    assert.notEqual(geometry.index, index);
    await null;
    assert.equal(geometry.index, index);
    assert.deepEqual(Array.from(index?.array ?? []), index ? [3, 4, 5, 0, 1, 2] : []);
  }
});

test('a geometry has its own index again as soon as its mesh is drawn, and what the client does then is done once', () => {
  const geometry = geometryAt([1, -1]).setIndex([3, 4, 5, 0, 1, 2]);
  const { index } = geometry;
  const mesh = new THREE.Mesh(geometry);
  let calls = 0;
  mesh.onAfterRender = (camera) => {
    assert.equal(geometry.index, index);
    assert.equal(camera, SEEING.perspective);
    calls++;
  };
  const own = mesh.onAfterRender;
  for (let frame = 1; frame < 3; frame++) {
    assert.deepEqual(orderOf(geometry, { mesh }), [1, 0]);
    mesh.onAfterRender(SEEING.perspective);
    assert.equal(geometry.index, index);
    assert.equal(calls, frame);
    assert.equal(mesh.onAfterRender, own);
  }
});

test('an index that a client sets in the meantime stays', async () => {
  const geometry = geometryAt([1, -1]);
  orderOf(geometry);
  const own = new THREE.BufferAttribute(new Uint16Array([0, 1, 2]), 1);
  geometry.setIndex(own);
  await null;
  assert.equal(geometry.index, own);
  assert.deepEqual(orderOf(geometry), [0]);
});

test('a group and a range are put in order by themselves', () => {
  const geometry = geometryAt([3, 2, 1, 0]);
  assert.deepEqual(orderOf(geometry, { group: { start: 6, count: 6 } }), [0, 1, 3, 2]);
  geometry.setDrawRange(0, 6);
  assert.deepEqual(orderOf(geometry), [1, 0, 2, 3]);
});

test('what moves is put in order anew, what stands still is not', () => {
  const geometry = geometryAt([1, -1]);
  const mesh = new THREE.Mesh(geometry);
  orderOf(geometry, { mesh });
  const { version } = geometry.index;
  orderOf(geometry, { mesh });
  assert.equal(geometry.index.version, version);
  geometry.attributes.position.setZ(0, -9).setZ(1, -9).setZ(2, -9).needsUpdate = true;
  assert.deepEqual(orderOf(geometry, { mesh }), [0, 1]);
});

test('two views of a mesh, and two of its groups, are put in order once each while nothing moves', () => {
  const geometry = geometryAt([1, -1, 2, 0]);
  const mesh = new THREE.Mesh(geometry);
  const groups = [
    { start: 0, count: 6 },
    { start: 6, count: 6 },
  ];
  const drawAll = () =>
    Object.values(SEEING).flatMap((camera) =>
      groups.map((group) => {
        orderOf(geometry, { mesh, camera, group });
        return [geometry.index, geometry.index.version];
      }),
    );
  const first = drawAll();
  assert.equal(new Set(first.map(([index]) => index)).size, 4);
  assert.deepEqual(drawAll(), first);
});

test('a mesh with joints is put in order anew when one of them moves', () => {
  const geometry = geometryAt([1, -1]);
  geometry.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Uint16Array(24), 4));
  geometry.setAttribute(
    'skinWeight',
    new THREE.Float32BufferAttribute(
      Array.from({ length: 24 }, (_, i) => (i % 4 === 0 ? 1 : 0)),
      4,
    ),
  );
  const mesh = new THREE.SkinnedMesh(geometry);
  const bone = new THREE.Bone();
  mesh.add(bone);
  mesh.bind(new THREE.Skeleton([bone]));
  const versionNow = () => {
    mesh.updateMatrixWorld(true);
    mesh.skeleton.update();
    orderOf(geometry, { mesh });
    return geometry.index.version;
  };
  const version = versionNow();
  assert.equal(versionNow(), version);
  bone.position.z = 3;
  assert.equal(versionNow(), version + 1);
});

test('a mesh that morphs is put in order by where its vertices are', () => {
  const geometry = geometryAt([1, -1]);
  geometry.morphAttributes.position = [new THREE.Float32BufferAttribute([0, 0, -8, 0, 0, -8, 0, 0, -8, 0, 0, 0, 0, 0, 0, 0, 0, 0], 3)];
  geometry.morphTargetsRelative = true;
  const mesh = new THREE.Mesh(geometry);
  assert.deepEqual(orderOf(geometry, { mesh }), [1, 0]);
  mesh.morphTargetInfluences[0] = 1;
  assert.deepEqual(orderOf(geometry, { mesh }), [0, 1]);
});

test('nets and sheer cloth alone have an order', () => {
  const sheer = { isFabricMaterial: true, transparent: true, transmission: 0 };
  const mesh = new THREE.Mesh();
  assert.equal(isOrdered(sheer, mesh), true);
  for (const change of [{ isFabricMaterial: false }, { transparent: false }, { transmission: 0.5 }])
    assert.equal(isOrdered({ ...sheer, ...change }, mesh), false);
  assert.equal(isOrdered(sheer, new THREE.InstancedMesh(new THREE.BufferGeometry(), new THREE.Material(), 2)), false);
  assert.equal(isOrdered(sheer, new THREE.Points()), false);
});
