import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';

/** A shirt: wider than deep, its middle not that of its box. */
const outline = [
  [-0.4, 0.6, 0],
  [0.42, 0.55, 0.02],
  [0, 0.72, -0.05],
  [-0.25, 0, 0.14],
  [0.25, 0.01, 0.15],
  [0.2, 0, -0.15],
  [-0.22, 0.02, -0.13],
  [0.05, 0.4, 0.2],
];
const axes = [0, 1, 2];
const facts = {
  bounds: { min: axes.map((axis) => Math.min(...outline.map((p) => p[axis]))), max: axes.map((axis) => Math.max(...outline.map((p) => p[axis]))) },
  outline,
};
const centre = axes.map((axis) => (facts.bounds.min[axis] + facts.bounds.max[axis]) / 2);

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const minus = (a, b) => a.map((x, i) => x - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (v) => v.map((x) => x / Math.hypot(...v));

/** How much of the frame's half each point is away from the middle: [[x, y], ...]. */
function projected({ camera, size }, points) {
  const back = unit(minus(camera.position, camera.target));
  const right = unit(cross(camera.up, back));
  const up = cross(back, right);
  const half = camera.height ? () => camera.height / 2 : (depth) => depth * Math.tan((camera.fovY / 360) * Math.PI);
  return points.map((point) => {
    const p = minus(point, camera.position);
    const high = half(-dot(p, back));
    return [dot(p, right) / (high * (size.width / size.height)), dot(p, up) / high];
  });
}
const reach = (shot) => Math.max(...projected(shot, outline).flat().map(Math.abs));
/** Distance along the view of the box's middle: what gives the scale. */
const distance = ({ camera }) => dot(minus(camera.position, centre), unit(minus(camera.position, camera.target)));

const TURN = Array.from({ length: 72 }, (_, i) => i * 5);
const LENSES = [{}, { fovY: 60 }, { fovY: 8, fit: 0.5 }, { projection: 'orthographic' }, { projection: 'orthographic', fit: 1.2 }];
const SIZES = [
  { width: 512, height: 512 },
  { width: 900, height: 300 },
  { width: 300, height: 900 },
];
const near = (a, b, tolerance = 1e-9) => Math.abs(a - b) <= tolerance;

test('a view of its own breathes: the reason for fitTo', () => {
  const all = TURN.map((azimuth) => distance(resolveShot({ camera: { azimuth } }, facts)));
  assert.ok(Math.max(...all) / Math.min(...all) > 1.09);
});

test('a turntable has one distance, one height and one scale all round, and touches the frame somewhere', () => {
  for (const size of SIZES) {
    for (const lens of LENSES) {
      for (const elevation of [-30, 0, 15, 60, 90]) {
        const shots = TURN.map((azimuth) => resolveShot({ size, camera: { azimuth, elevation, fitTo: 'turntable', ...lens } }, facts));
        const message = JSON.stringify({ size, lens, elevation });
        const [first] = shots;
        for (const shot of shots) {
          assert.ok(near(distance(shot), distance(first)) && near(shot.camera.position[1], first.camera.position[1]), message);
          assert.equal(shot.camera.height, first.camera.height, message);
          // The model turns about its own axis: the rig is the first one turned.
          const level = ([x, , z]) => Math.hypot(x - centre[0], z - centre[2]);
          assert.ok(near(level(shot.camera.position), level(first.camera.position)) && near(level(shot.camera.target), level(first.camera.target)), message);
          assert.ok(reach(shot) <= (lens.fit ?? 0.9) + 1e-9, `${message}: ${reach(shot)}`);
        }
        // Half a degree beside the touching azimuth a little is missing.
        assert.ok(Math.max(...shots.map(reach)) > (lens.fit ?? 0.9) - 0.01, `${message}: ${Math.max(...shots.map(reach))}`);
      }
    }
  }
});

test('all directions share one scale, and fit', () => {
  const directions = [...TURN.flatMap((azimuth) => [-90, -40, 0, 35, 90].map((elevation) => ({ azimuth, elevation }))), { view: 'top' }, { view: 'back' }];
  for (const size of SIZES) {
    for (const lens of LENSES) {
      const shots = directions.map((direction) => resolveShot({ size, camera: { ...direction, fitTo: 'all', ...lens } }, facts));
      for (const shot of shots) {
        assert.ok(near(distance(shot), distance(shots[0])) && shot.camera.height === shots[0].camera.height);
        assert.ok(
          shot.camera.target.every((x, i) => near(x, centre[i])),
          'every view looks at the middle',
        );
        assert.ok(reach(shot) <= (lens.fit ?? 0.9) + 1e-9);
      }
      // No more room than a ball about the model needs: its tangents from the camera are the frame's planes.
      const slope = (lens.fit ?? 0.9) * Math.min(1, size.width / size.height) * Math.tan(((lens.fovY ?? 30) / 360) * Math.PI);
      const ball = Math.max(...outline.map((point) => Math.hypot(...minus(point, centre))));
      const { height } = shots[0].camera;
      if (height) assert.ok(near(height, (2 * ball) / ((lens.fit ?? 0.9) * Math.min(1, size.width / size.height))));
      else assert.ok(near(distance(shots[0]), ball / Math.sin(Math.atan(slope))));
    }
  }
});

test('resolved cameras of a shared scale resolve to themselves', () => {
  for (const fitTo of ['turntable', 'all']) {
    const shot = resolveShot({ camera: { azimuth: 33, elevation: 12, fitTo }, ground: {} }, facts);
    assert.deepEqual(resolveShot(shot, facts), shot);
  }
});

test('fit above 1 cuts the model as much as it says, until the camera stands before its box', () => {
  for (const projection of ['perspective', 'orthographic']) {
    for (const fit of [1.5, 3]) {
      const shot = resolveShot({ camera: { fit, projection, fovY: projection === 'perspective' ? 20 : undefined } }, facts);
      assert.ok(near(reach(shot), fit, 1e-9), `${projection} ${fit}: ${reach(shot)}`);
    }
  }
  const close = resolveShot({ camera: { fit: 100 } }, facts);
  assert.ok(close.camera.position[2] > facts.bounds.max[2] && close.camera.near > 0);
  assert.throws(() => resolveShot({ camera: { fit: 101 } }, facts), /shot\.camera\.fit: expected a number in \[0\.000001, 100\]/);
});

test('a wrong frame says what there may be', () => {
  const expected = 'expected "scene", "model", {node} or {material}';
  for (const [frame, message] of [
    ['sleeve', `shot.camera.frame: ${expected}, got "sleeve"`],
    [{}, `shot.camera.frame: ${expected}, got {}`],
    [{ node: 'x', material: 'y' }, `shot.camera.frame: ${expected}, got {"node", "material"}`],
    [{ nodes: 'x' }, 'shot.camera.frame.nodes: unknown key, did you mean node?'],
    [{ node: -1 }, 'shot.camera.frame.node: expected the index or the name of a node in the model, got -1'],
    [{ material: true }, 'shot.camera.frame.material: expected the index or the name of a material in the model, got true'],
  ])
    assert.throws(() => resolveShot({ camera: { frame } }, facts), { code: 'E_SHOT', message });
  assert.throws(() => resolveShot({ camera: { fitTo: 'turn' } }, facts), { message: 'shot.camera.fitTo: expected "view", "turntable" or "all", got "turn"' });
});
