import assert from 'node:assert/strict';
import { test } from 'node:test';
import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { VIEWS } from '../../../js/shot/frame.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';

const shirt = { min: [-0.4, 0.1, -0.15], max: [0.42, 0.82, 0.17] };

/** The resolved camera as stock three.js sets it up. */
function threeCamera({ camera, size }) {
  const aspect = size.width / size.height;
  const result =
    camera.projection === 'perspective'
      ? new PerspectiveCamera(camera.fovY, aspect, camera.near, camera.far)
      : new OrthographicCamera((-camera.height / 2) * aspect, (camera.height / 2) * aspect, camera.height / 2, -camera.height / 2, camera.near, camera.far);
  result.position.fromArray(camera.position);
  result.up.fromArray(camera.up);
  result.lookAt(...camera.target);
  result.updateMatrixWorld(true);
  return result;
}

/** Normalised device coordinates that the box covers: [[left, right], [bottom, top], [near, far]]. */
function projectedExtent(shot, { min, max }) {
  const camera = threeCamera(shot);
  const corners = Array.from({ length: 8 }, (_, i) => new Vector3(...[0, 1, 2].map((axis) => (i & (1 << axis) ? max : min)[axis])).project(camera).toArray());
  return [0, 1, 2].map((axis) => [Math.min(...corners.map((c) => c[axis])), Math.max(...corners.map((c) => c[axis]))]);
}

const near = (actual, expected, tolerance, message) => assert.ok(Math.abs(actual - expected) <= tolerance, `${message}: ${actual} is not ${expected}`);

/** Centred in both dimensions, filling `fit` of the tighter one, inside the planes. */
function assertFramed(shot, box, fit, tolerance, message) {
  const [[left, right], [bottom, top], [front, back]] = projectedExtent(shot, box);
  near(left + right, 0, tolerance, `${message}: centred horizontally`);
  near(bottom + top, 0, tolerance, `${message}: centred vertically`);
  near(Math.max(right, top), fit, tolerance, `${message}: fills the frame`);
  assert.ok(front >= -1 && back <= 1, `${message}: between the planes`);
  assert.ok(shot.camera.near > 0, `${message}: near is positive`);
}

const SIZES = [
  { width: 512, height: 512 },
  { width: 1600, height: 200 },
  { width: 200, height: 1600 },
];
const DIRECTIONS = [...Object.keys(VIEWS).map((view) => ({ view })), { azimuth: 33, elevation: -41 }, { azimuth: -200, elevation: 89.999 }];
const LENSES = [{ fovY: 30 }, { fovY: 5 }, { fovY: 70, fit: 1 }, { projection: 'orthographic' }, { projection: 'orthographic', fit: 0.25 }];

test('each view, lens and size fills the frame and is centred', () => {
  for (const size of SIZES) {
    for (const direction of DIRECTIONS) {
      for (const lens of LENSES) {
        const shot = resolveShot({ size, camera: { ...direction, ...lens } }, shirt);
        assertFramed(shot, shirt, lens.fit ?? 0.9, 1e-9, JSON.stringify({ size, direction, lens }));
      }
    }
  }
});

test('tiny, huge, distant, flat and thin boxes are framed', () => {
  const boxes = {
    tiny: { min: [-1e-6, 0, -1e-6], max: [1e-6, 2e-6, 1e-6] },
    huge: { min: [-1e6, -1e6, -1e6], max: [1e6, 1e6, 1e6] },
    distant: { min: [1e6, 1e6, 1e6], max: [1e6 + 1, 1e6 + 2, 1e6 + 3] },
    flat: { min: [-1, 0, 0], max: [1, 1, 0] },
    line: { min: [-1, 0, 0], max: [1, 0, 0] },
  };
  for (const [name, box] of Object.entries(boxes)) {
    for (const camera of [{}, { azimuth: 20, elevation: 10 }, { projection: 'orthographic' }]) {
      // three.js projects through a matrix that holds the camera's position, so a distant box loses digits there.
      assertFramed(resolveShot({ camera }, box), box, 0.9, name === 'distant' ? 1e-6 : 1e-9, `${name} ${JSON.stringify(camera)}`);
    }
  }
});

test('a point, a line seen along itself and an edge-on sheet give sound cameras', () => {
  const boxes = [
    { min: [3, 4, 5], max: [3, 4, 5] },
    { min: [1e6, 0, 0], max: [1e6, 0, 0] },
    { min: [0, 0, -1], max: [0, 0, 1] },
    { min: [0, -1, -1], max: [0, 1, 1] },
  ];
  for (const box of boxes) {
    for (const camera of [{}, { projection: 'orthographic' }, { fovY: 170 }, { view: 'top' }, { view: 'left' }]) {
      const shot = resolveShot({ camera }, box);
      const [[left, right], [bottom, top], [front, back]] = projectedExtent(shot, box);
      const message = `${JSON.stringify(box)} ${JSON.stringify(camera)}`;
      assert.ok(Math.max(-left, right, -bottom, top) <= 0.9 + 1e-9, message);
      assert.ok(front >= -1 && back <= 1 && shot.camera.near > 0, message);
      assert.deepEqual(resolveShot(shot, box), shot);
    }
  }
});

test('very wide lenses stay outside of the box', () => {
  for (const fovY of [100, 150, 175, 179.999]) {
    for (const view of ['front', 'three-quarter', 'top']) {
      const shot = resolveShot({ camera: { view, fovY } }, shirt);
      const [[left, right], [bottom, top], [front, back]] = projectedExtent(shot, shirt);
      assert.ok(Math.max(-left, right, -bottom, top) <= 0.9 + 1e-6 && front >= -1 && back <= 1, `${fovY} ${view}`);
    }
  }
});

test('near and far are tight', () => {
  for (const view of Object.keys(VIEWS)) {
    const shot = resolveShot({ camera: { view } }, shirt);
    const { near: nearest, far: farthest } = shot.camera;
    const distances = projectedExtent(shot, shirt)[2].map((z) => (2 * farthest * nearest) / (farthest + nearest - z * (farthest - nearest)));
    assert.ok(nearest > 0.98 * distances[0] - 0.01 && farthest < 1.02 * distances[1] + 0.01, `${view}: ${nearest} to ${farthest}`);
  }
});

test('glTF axes: the front faces +Z, +Y is up, right is +X', () => {
  const axes = {
    front: [
      [0, 0, 1],
      [0, 1, 0],
    ],
    back: [
      [0, 0, -1],
      [0, 1, 0],
    ],
    left: [
      [-1, 0, 0],
      [0, 1, 0],
    ],
    right: [
      [1, 0, 0],
      [0, 1, 0],
    ],
    top: [
      [0, 1, 0],
      [0, 0, -1],
    ],
    bottom: [
      [0, -1, 0],
      [0, 0, 1],
    ],
  };
  const cube = { min: [-1, -1, -1], max: [1, 1, 1] };
  for (const [view, [towards, up]] of Object.entries(axes)) {
    const { camera } = resolveShot({ camera: { view } }, cube);
    const distance = Math.hypot(...camera.position);
    assert.deepEqual(
      camera.position.map((x) => x / distance + 0),
      towards,
      view,
    );
    assert.deepEqual(camera.up, up, view);
  }
  const { camera } = resolveShot({ camera: { view: 'three-quarter' } }, cube);
  assert.ok(camera.position.every((x) => x > 0));
});

test("azimuth and elevation are the named views' own", () => {
  for (const [view, angles] of Object.entries(VIEWS)) {
    assert.deepEqual(resolveShot({ camera: { view } }, shirt), resolveShot({ camera: angles }, shirt));
  }
  assert.deepEqual(resolveShot({ camera: { elevation: 20 } }, shirt), resolveShot({ camera: { azimuth: 0, elevation: 20 } }, shirt));
});

test('planes of an explicit camera are fitted, with the camera outside, inside and behind', () => {
  const cube = { min: [-1, -1, -1], max: [1, 1, 1] };
  const planes = (position, target, more) => {
    const { camera } = resolveShot({ camera: { position, target, ...more } }, cube);
    return [camera.near, camera.far];
  };
  const [outsideNear, outsideFar] = planes([0, 0, 5], [0, 0, 0]);
  assert.ok(outsideNear > 3.9 && outsideNear <= 4 && outsideFar >= 6 && outsideFar < 6.1);
  const [insideNear, insideFar] = planes([0, 0, 0.5], [0, 0, 0]);
  assert.ok(insideNear > 0 && insideNear < 0.01 && insideFar >= 1.5 && insideFar < 1.6);
  const [behindNear, behindFar] = planes([0, 0, 5], [0, 0, 9]);
  assert.ok(behindNear > 0 && behindFar > behindNear);
  assert.deepEqual(planes([0, 0, 5], [0, 0, 0], { near: 0.5, far: 9 }), [0.5, 9]);
  const [givenNear, beyond] = planes([0, 0, 5], [0, 0, 0], { near: 50 });
  assert.ok(givenNear === 50 && beyond > 50);
});

test('with its outline known, the model itself fills the frame, not its box', () => {
  // An octahedron: from the front and at a slant its box is far larger than it.
  const outline = [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1.5, 0],
    [0, -0.5, 0],
    [0, 0, 1],
    [0, 0, -1],
  ];
  const facts = { bounds: { min: [-1, -0.5, -1], max: [1, 1.5, 1] }, outline };
  for (const size of SIZES) {
    for (const direction of DIRECTIONS) {
      // A lens of 70 degrees would have to stand inside the box, which the near plane forbids.
      for (const lens of LENSES.filter(({ fovY }) => fovY !== 70)) {
        const shot = resolveShot({ size, camera: { ...direction, ...lens } }, facts);
        const seen = outline.map((point) => new Vector3(...point).project(threeCamera(shot)).toArray());
        const extent = [0, 1].map((axis) => [Math.min(...seen.map((p) => p[axis])), Math.max(...seen.map((p) => p[axis]))]);
        const message = JSON.stringify({ size, direction, lens });
        for (const [low, high] of extent) near(low + high, 0, 1e-9, `${message}: centred`);
        near(Math.max(...extent.map(([, high]) => high)), lens.fit ?? 0.9, 1e-9, `${message}: fills the frame`);
        assert.deepEqual(resolveShot(shot, facts), shot, `${message}: idempotent`);
      }
    }
  }
});

test('an outline that is not a list of points is refused', () => {
  assert.throws(() => resolveShot({}, { bounds: shirt, outline: [[0, 1, NaN]] }), /facts\.outline: expected a list of points/);
});
