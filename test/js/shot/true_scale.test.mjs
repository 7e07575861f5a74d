import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3, OrthographicCamera } from 'three';
import { cornersOfBox } from '../../../js/shot/frame.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';

const shirt = { min: [-0.35, 0, -0.1], max: [0.35, 0.7, 0.1] };

/** Parts of the frame's half that the box covers: [[left, right], [bottom, top]]. */
function extentOf({ camera: { position, target, up, height, near, far }, size }) {
  const half = height / 2;
  const camera = new OrthographicCamera((-half * size.width) / size.height, (half * size.width) / size.height, half, -half, near, far);
  camera.position.fromArray(position);
  camera.up.fromArray(up);
  camera.lookAt(...target);
  camera.updateMatrixWorld(true);
  const corners = cornersOfBox(shirt).map((corner) => new Vector3(...corner).project(camera).toArray());
  return [0, 1].map((axis) => [Math.min(...corners.map((c) => c[axis])), Math.max(...corners.map((c) => c[axis]))]);
}

const side = [{ type: 'directional', position: [-1, 0.7, 0.5], castShadow: true }];
const drawn = (width, rest) =>
  resolveShot(
    { scale: '1:5', output: { ppi: 150 }, size: { width, height: width }, camera: { azimuth: 0, elevation: 10, ...rest }, ground: {}, lights: side },
    shirt,
  );
const isCentred = ([low, high]) => Math.abs(low + high) < 1e-9;

test('a shadow that a frame in true scale cannot hold does not push the model out of it', () => {
  for (const [width, rest] of [
    [900, {}],
    [1500, {}],
    [1000, { fit: 2 }],
    [1000, { fitTo: 'all' }],
    [1000, { fitTo: 'turntable' }],
  ]) {
    const shot = drawn(width, rest);
    assert.ok(Math.abs(shot.camera.height / (width * (0.0254 / 150) * 5) - 1) < 1e-12);
    const [across, along] = extentOf(shot);
    assert.ok(isCentred(across), `${width} ${JSON.stringify(rest)}: ${across}`);
    assert.ok(Math.max(...across.map(Math.abs), ...along.map(Math.abs)) <= 1, `${across} ${along}`);
  }
});

test('one that it holds beside the model is in it', () => {
  for (const width of [2120, 2150]) {
    const [across, along] = extentOf(drawn(width));
    assert.ok(!isCentred(across) && Math.min(...across) >= -0.97, `${width}: ${across}`);
    assert.ok(Math.max(...along.map(Math.abs)) <= 1, `${along}`);
  }
});

test('a frame that is large enough is that of its fit', () => {
  const shot = drawn(4000);
  const plain = resolveShot({ camera: { azimuth: 0, elevation: 10, projection: 'orthographic' }, ground: {}, lights: side }, shirt);
  assert.deepEqual([shot.camera.position, shot.camera.target], [plain.camera.position, plain.camera.target]);
});
