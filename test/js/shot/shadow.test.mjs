import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { resolveShot } from '../../../js/shot/index.mjs';
import { cornersOfBox } from '../../../js/shot/frame.mjs';
import { lightAxes } from '../../../js/shot/shadow.mjs';
import { arcTangent } from '../../../js/shot/trig.mjs';

const box = { min: [-0.4, 0.1, -0.2], max: [0.5, 1.3, 0.3] };
const casting = (type, rest) => ({ type, castShadow: true, ...rest });
const resolveLight = (light, bounds = box, rest = {}) => resolveShot({ lights: [light], ...rest }, bounds).lights[0];

/** The light of three.js that a resolved light stands for, its shadow's matrix up to date. */
function threeLight(light) {
  const object = light.type === 'spot' ? new THREE.SpotLight(0xffffff, 1, light.range, light.angle) : new THREE.DirectionalLight();
  object.position.fromArray(light.position);
  object.target.position.fromArray(light.target);
  object.updateMatrixWorld();
  object.target.updateMatrixWorld();
  const { near, far, left, right, bottom, top, focus } = light.shadow;
  Object.assign(object.shadow.camera, light.type === 'spot' ? { near, far } : { near, far, left, right, bottom, top });
  if (light.type === 'spot') object.shadow.focus = focus;
  object.shadow.camera.updateProjectionMatrix();
  object.shadow.updateMatrices(object);
  return object;
}

/** Where three.js maps a point, 0..1 in the shadow map. */
const mapped = (object, point) => new THREE.Vector3(...point).applyMatrix4(object.shadow.matrix).toArray();

const LIGHTS = [
  casting('directional', { position: [1, 3, 2] }),
  casting('directional', { position: [0, 1, 0] }),
  casting('directional', { position: [0, -1, 0], target: [0, 1, 0] }),
  casting('directional', { position: [0.05, 0.7, 0.02], target: [3, 0.4, 1] }),
  casting('spot', { position: [1, 3, 2], target: [0, 0.7, 0] }),
  casting('spot', { position: [0, 4, 0], target: [0, 0, 0], angle: Math.PI / 2 }),
  casting('spot', { position: [5, 1, 0], target: [0, 1, 0], angle: 0.4, shadow: { radius: 8, mapSize: 64 } }),
];

test('the map holds the whole model with room for the filter, and not much more', () => {
  for (const light of LIGHTS) {
    const resolved = resolveLight(light);
    const object = threeLight(resolved);
    const points = cornersOfBox(box).map((corner) => mapped(object, corner));
    const { mapSize, radius } = resolved.shadow;
    const message = JSON.stringify(resolved);
    for (const [x, y, z] of points) {
      const room = Math.min(radius + 1, mapSize / 5) / mapSize;
      assert.ok(Math.min(x, y, 1 - x, 1 - y) >= room, message);
      assert.ok(z > 0 && z < 1, message);
    }
    const extent = (axis) => Math.max(...points.map((p) => p[axis])) - Math.min(...points.map((p) => p[axis]));
    assert.ok(Math.max(extent(0), extent(1)) > 0.45, message);
  }
});

test('the axes of a light are those of three.js', () => {
  for (const light of LIGHTS) {
    const { position, target } = resolveLight(light);
    const elements = new THREE.Matrix4().lookAt(new THREE.Vector3(...position), new THREE.Vector3(...target), new THREE.Vector3(0, 1, 0)).elements;
    lightAxes({ position, target })
      .flat()
      .forEach((x, i) => assert.ok(Math.abs(x - elements[Math.floor(i / 3) * 4 + (i % 3)]) < 1e-12));
  }
});

test('the same scene in other units has the same map', () => {
  for (const scale of [1e-6, 1e6]) {
    for (const light of [...LIGHTS, casting('point', { position: [1, 2, 2] })]) {
      const sized = (v) => v?.map((x) => x * scale);
      const scaled = { ...light, position: sized(light.position), ...(light.target && { target: sized(light.target) }) };
      const [one, other] = [resolveLight(light), resolveLight(scaled, { min: sized(box.min), max: sized(box.max) })];
      for (const [key, value] of Object.entries(one.shadow)) {
        const metres = ['near', 'far', 'left', 'right', 'bottom', 'top', 'normalBias'].includes(key);
        assert.ok(Math.abs(other.shadow[key] / (metres ? scale : 1) - value) <= 1e-9 * Math.abs(value) + 1e-12, `${light.type} ${key} ${scale}`);
      }
    }
  }
});

test('biases are those of one filter: texels at the farthest caster', () => {
  const { shadow } = resolveLight(casting('directional', { position: [1, 3, 2] }));
  const texel = (shadow.right - shadow.left) / shadow.mapSize;
  assert.ok(Math.abs(shadow.normalBias / texel - 3.5) < 0.01);
  assert.ok(Math.abs((-shadow.bias * (shadow.far - shadow.near)) / texel - 1) < 0.01);
  const { shadow: coarse } = resolveLight(casting('directional', { position: [1, 3, 2], shadow: { mapSize: 128, radius: 6 } }));
  assert.ok(coarse.normalBias > 15 * shadow.normalBias);
});

test('the maps of releases before 0.182 measure the distance to a point light, and their filter is a square', () => {
  const position = [1.5, 2.2, 1.4];
  const older = (light) => resolveLight(light, box, { shading: { base: 'three', revision: 181 } });
  const { shadow } = older(casting('point', { position }));
  const distances = cornersOfBox(box).map((corner) => Math.hypot(...corner.map((c, i) => c - position[i])));
  assert.ok(Math.abs(shadow.far / (1.01 * Math.max(...distances)) - 1) < 1e-9);
  assert.ok(shadow.near < Math.min(...distances) && shadow.near > 0);
  const texel = (2 * Math.max(...distances)) / shadow.mapSize;
  assert.ok(Math.abs((-shadow.bias * (shadow.far - shadow.near)) / texel - 1) < 0.01, 'one texel of distance');
  // A cube measures along the axes of its faces, which is less.
  assert.ok(resolveLight(casting('point', { position })).shadow.far < 0.9 * shadow.far);
  const { shadow: flat } = older(casting('directional', { position: [1, 3, 2], shadow: { radius: 6 } }));
  const flatTexel = (flat.right - flat.left) / flat.mapSize;
  assert.ok(Math.abs(flat.normalBias / flatTexel / (6.5 * Math.SQRT2) - 1) < 0.01);
});

test('a far light and a light in the midst of the model have sound maps', () => {
  for (const light of [
    casting('directional', { position: [1e6, 1e6, 0] }),
    casting('spot', { position: [0, 1e5, 0] }),
    casting('point', { position: [0, 0.7, 0] }),
    casting('spot', { position: [0, 0.7, 0], target: [1, 0.7, 0], angle: Math.PI / 2 }),
    casting('point', { position: [9, 9, 9], range: 0.5 }),
  ]) {
    const resolved = resolveLight(light, box, { ground: {} });
    const { near, far, bias, normalBias, focus = 1 } = resolved.shadow;
    assert.ok([near, far, bias, normalBias].every(Number.isFinite), JSON.stringify(resolved));
    assert.ok(far > near && normalBias > 0 && bias <= 0 && bias >= -1, JSON.stringify(resolved));
    if (light.type !== 'directional') assert.ok(near > 0);
    if (light.range) assert.equal(far, light.range);
    assert.ok(focus * (light.angle ?? 1) < 1.49, 'a projection narrower than 180 degrees');
  }
});

test('what the caller gives stays', () => {
  const shadow = { mapSize: 333, radius: 1.5, intensity: 0.25, bias: -0.01, normalBias: 0.02, near: 0.1, far: 20, left: -1, right: 2, bottom: -3, top: 4 };
  assert.deepEqual(resolveLight(casting('directional', { shadow })).shadow, shadow);
  assert.equal(resolveLight(casting('spot', { shadow: { bias: 0.5 } })).shadow.bias, 0.5);
});

test('without a model there is nothing to fit', () => {
  const camera = { position: [0, 0, 3], target: [0, 0, 0], near: 1, far: 9 };
  assert.throws(() => resolveShot({ camera, lights: [casting('point')] }), { code: 'E_NO_GEOMETRY', pointer: '/lights/0/castShadow' });
  assert.throws(() => resolveShot({ camera, ground: {} }), { code: 'E_NO_GEOMETRY', pointer: '/ground' });
});

test('the ground lies at the lowest point and holds every shadow', () => {
  for (const light of [...LIGHTS.slice(0, 2), casting('spot', { position: [1, 3, 2] }), casting('point', { position: [-1, 2.5, 1] })]) {
    const { ground } = resolveShot({ lights: [light], ground: {} }, box);
    assert.equal(ground.position[1], box.min[1]);
    const { position = [0, 0, 0], target = [0, 0, 0] } = light;
    for (const corner of cornersOfBox(box)) {
      const ray = light.type === 'directional' ? target.map((x, i) => x - position[i]) : corner.map((x, i) => x - position[i]);
      const t = (box.min[1] - corner[1]) / ray[1];
      [0, 2].forEach((axis, i) => {
        const at = corner[axis] + t * ray[axis];
        assert.ok(Math.abs(at - ground.position[axis]) < ground.size[i] / 2, JSON.stringify(light));
      });
    }
  }
});

test('a light at the horizon or below it makes no endless ground', () => {
  for (const y of [0.01, 0, -1]) {
    const { ground, camera } = resolveShot({ lights: [casting('directional', { position: [5, y, 0] })], ground: {} }, box);
    assert.ok(
      ground.size.every((x) => x > 0.5 && x < 500),
      `${y}: ${ground.size}`,
    );
    assert.ok(Number.isFinite(camera.far) && camera.near > 0);
  }
});

test('where the model alone is framed, near and far hold the ground', () => {
  const shot = { lights: [casting('directional', { position: [2, 1, -2] })], camera: { view: 'three-quarter', frame: 'model' } };
  const [without, withGround] = [resolveShot(shot, box).camera, resolveShot({ ...shot, ground: {} }, box).camera];
  for (const key of ['position', 'target', 'up', 'fovY']) assert.deepEqual(withGround[key], without[key]);
  assert.ok(withGround.near < without.near && withGround.far >= without.far);
});

test('where no light casts, lights that shine on nothing do: soft, from above', () => {
  const { lights } = resolveShot({ ground: {}, lights: [{ type: 'point' }] }, box);
  assert.equal(lights.length, 4);
  for (const light of lights.slice(1)) {
    assert.deepEqual([light.type, light.intensity, light.castShadow], ['directional', 0, true]);
    assert.ok(light.position[1] > box.max[1]);
  }
  assert.equal(resolveShot({ ground: {}, lights: [casting('point', { position: [1, 2, 1] })] }, box).lights.length, 1);
  assert.deepEqual(resolveShot({}, box).lights, []);
  const tie = resolveShot({ ground: {} }, { min: [0, 0, 0], max: [0.08, 0.002, 1.5] }).lights[0].shadow;
  assert.ok((tie.right - tie.left) / tie.mapSize < 0.08 / 3, 'a narrow model covers several texels');
});

test('arc tangent to the last bits, from arithmetic alone', () => {
  for (const x of [0, 1e-9, 0.1, 0.5, 1, 3, 100, 1e9]) assert.ok(Math.abs(arcTangent(x) - Math.atan(x)) <= 4e-15, `${x}`);
});

test('what hangs has its shadow as far below it as it is told to, and the frame holds that', () => {
  const facts = { bounds: { min: [-0.4, 0.2, -0.15], max: [0.4, 1.2, 0.15] } };
  const resolved = (ground) => resolveShot({ ground, camera: { elevation: 6 } }, facts);
  const [standing, hanging] = [resolved({}), resolved({ gap: 0.1 })];
  assert.equal(standing.ground.position[1], 0.2);
  assert.ok(Math.abs(hanging.ground.position[1] - 0.1) < 1e-12, 'a tenth of its height of 1 m');
  assert.ok(hanging.camera.position[2] > standing.camera.position[2], 'it stands back for the shadow');
  assert.deepEqual(resolveShot(hanging, facts), hanging, 'and once resolved it moves no further');
  assert.equal(resolved({ gap: 0.1, position: [0, -1, 0] }).ground.position[1], -1, 'a place that is given stays');
});

test('a garment that hangs has a soft shadow below it in the looks that hang it', () => {
  const facts = { bounds: { min: [-0.4, 0, -0.15], max: [0.4, 1, 0.15] } };
  for (const look of ['hanger', 'ghost']) {
    const { ground, lights } = resolveShot({ look }, facts);
    assert.ok(ground.position[1] < -0.05, look);
    assert.equal(lights.filter(({ castShadow, intensity }) => castShadow && intensity === 0).length, 3, 'of light that shines on nothing');
  }
  assert.equal(resolveShot({ look: 'furniture' }, facts).ground.position[1], 0, 'what stands touches the floor');
});
