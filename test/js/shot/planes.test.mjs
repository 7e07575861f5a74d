import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cornersOfBox } from '../../../js/shot/frame.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';

const shirt = { min: [-0.35, 0, -0.1], max: [0.35, 0.7, 0.1] };
const buttons = { min: [-0.006, 0.4, 0.09], max: [0.006, 0.412, 0.1] };
const facts = { bounds: shirt, part: { frame: { material: 'buttons' }, bounds: buttons } };
const cast = (type, ...position) => ({ type, position, castShadow: true });

const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
/** Distances of the corners of a box along the view. */
function distances({ position, target }, box) {
  const view = minus(target, position);
  return cornersOfBox(box).map((corner) => dot(minus(corner, position), view) / Math.hypot(...view));
}
const nearest = (camera, box) => Math.min(...distances(camera, box));

test('a ground that reaches behind the camera does not push the near plane into the model', () => {
  for (const camera of [{ view: 'three-quarter' }, { azimuth: 20, elevation: 40, fovY: 60 }, { position: [1, 1, 1], target: [0, 0.3, 0] }]) {
    const shot = (ground) => resolveShot({ camera, ground }, shirt).camera;
    const [without, wide] = [shot('none'), shot({ size: [3000, 3000] })];
    assert.ok(wide.near > 0.5 * nearest(wide, shirt) && wide.near < nearest(wide, shirt), `${wide.near}, ${nearest(wide, shirt)}`);
    assert.ok(wide.far > 1000 && without.far < 5, 'far alone goes with the ground');
  }
});

test('nor into a part that is framed', () => {
  const shot = { camera: { view: 'front', frame: { material: 'buttons' } }, ground: {}, lights: [cast('point', 1, 0.5, 1)] };
  const { camera } = resolveShot(shot, facts);
  assert.ok(camera.near < nearest(camera, buttons) && camera.far > 100, `${camera.near}, ${nearest(camera, buttons)}`);
  // Far behind the camera, and no ground: a hall and what lies in it.
  const hall = { ...facts, bounds: { min: [-150, 0, -150], max: [150, 9, 150] } };
  const inside = resolveShot({ camera: shot.camera }, hall).camera;
  assert.ok(inside.near < nearest(inside, buttons) && inside.far > 100, `${inside.near}, ${nearest(inside, buttons)}`);
});

test('a ground before a camera that turns its back to the model leaves near as it is', () => {
  const { camera } = resolveShot({ camera: { position: [0, 1, 2], target: [0, 0.5, 4] }, ground: { size: [20, 20] } }, shirt);
  assert.ok(Math.abs(camera.near / camera.far - 1e-3) < 1e-9, `${camera.near}`);
});

test('a wide ground does not push the maps of lamps into what casts the shadow', () => {
  const lampOf = (ground, light) => resolveShot({ lights: [light], ground }, shirt).lights[0].shadow;
  for (const light of [cast('point', 0, 0.35, 0), { ...cast('spot', 0, 0.35, 0), target: [0.3, 0, 0] }, cast('point', 0, 0.35, 0.11)]) {
    const [without, wide] = [lampOf('none', light), lampOf({ size: [3000, 3000] }, light)];
    assert.ok(Math.abs(wide.near / without.near - 1) < 1e-9, `${light.type}: ${wide.near}, ${without.near}`);
    assert.ok(wide.far > 500);
  }
});

test('a camera a hair outside of a box has depth left', () => {
  const room = { min: [-2, 0, -3.3], max: [2, 2.6, Math.fround(3.3)] };
  const camera = (z, rest) => resolveShot({ camera: { position: [0, 1.6, z], target: [0, 1.6, z - 1], ...rest } }, room).camera;
  for (const z of [3.3, 3.3 + 1e-12, 3.3001]) {
    const { near, far } = camera(z, { fovY: 60 });
    assert.ok(Math.abs(near / far - 1e-4) < 1e-9, `${z}: ${near} of ${far}`);
  }
  // From where half of the distance is more, nothing of the box is cut.
  const { near } = camera(3.302, { fovY: 60 });
  assert.ok(Math.abs(near / (3.302 - room.max[2]) - 0.5) < 1e-9, `${near}`);
  // Without perspective depth has one step all over, and the face that is as near is shown.
  assert.ok(camera(3.3, { height: 2 }).near < 3.3 - room.max[2]);
});

test('nor has a lamp a hair outside a map that ends in nothing', () => {
  const bounds = { min: shirt.min, max: shirt.max.map(Math.fround) };
  for (const light of [cast('point', 0, 0.7, 0), { ...cast('spot', 0, 0.3, 0.100005), target: [0, 0.3, 0] }]) {
    const { near, far } = resolveShot({ lights: [light] }, bounds).lights[0].shadow;
    assert.ok(Math.abs(near / far - 1e-4) < 1e-9, `${light.type}: ${near} of ${far}`);
  }
});

const behind = [cast('directional', 0, 0.2, -1)];
const parallel = (camera, ground = {}) => resolveShot({ camera: { projection: 'orthographic', ...camera }, ground, lights: behind }, shirt);

test('a view without perspective stands before all of a ground that it sees from above', () => {
  for (const camera of [
    { azimuth: 0, elevation: 5, fit: 0.5 },
    { azimuth: 30, elevation: 40 },
    { azimuth: 0, elevation: 5, frame: 'model' },
  ]) {
    const { camera: placed, ground } = parallel(camera);
    const [[x, y, z], [width, depth]] = [ground.position, ground.size];
    const reached = distances(placed, { min: [x - width / 2, y, z - depth / 2], max: [x + width / 2, y, z + depth / 2] });
    assert.ok(Math.min(...reached) > placed.near && Math.max(...reached) < placed.far, `${placed.near} to ${placed.far}: ${reached}`);
    const { camera: alone } = parallel(camera, 'none');
    if (camera.frame === 'model') assert.deepEqual([placed.target, placed.height], [alone.target, alone.height], 'straight back');
  }
  // The same camera for all views of a turntable.
  const away = [0, 45, 90, 200].map((azimuth) => parallel({ azimuth, elevation: 5, fitTo: 'turntable', frame: 'model' }).camera);
  for (const { position } of away) assert.ok(Math.abs(position[1] - away[0].position[1]) < 1e-9);
});

test('it stays where it was where the ground does not reach behind it, or is not seen', () => {
  for (const [camera, ground] of [
    [{ view: 'three-quarter' }, { size: [1, 1], position: [0, 0, 0] }],
    [{ azimuth: 20, elevation: -30 }, { size: [90, 90] }],
    [{ view: 'front' }, { size: [90, 90] }],
  ]) {
    const [placed, alone] = [ground, 'none'].map((one) => parallel({ ...camera, frame: 'model' }, one).camera.position);
    assert.deepEqual(placed, alone);
  }
});
