// Each layer against what is known of a model without drawing it, by the raster and by the path tracer, and one against
// the other. Every figure is also taken of a layer with a fault in it, which has to be beyond the bar.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { ballOfNoMaterial, BLUE, canopy, corner, formFactor, RED, sphereAndSlope } from './support/layer_scenes.mjs';
import './support/real.mjs';

const ALL = ['depth', 'normal', 'partId', 'materialId', 'ao', 'albedo', 'shadow', 'coverage', 'line'];
const CHANNELS = { normal: 3, albedo: 3 };
const SIZE = 96;
const QUALITIES = { raster: 'standard', reference: { preset: 'reference', samples: 64, transport: 'direct' } };

/** Perspective, off the axis, so that no distance along a ray is one along the view. */
const CAMERA = { position: [0.6, 0.5, 2.6], target: [0.1, 0.05, 0], fovY: 40, near: 0.5, far: 6 };

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

/** Layers as numbers. */
async function drawn(model, shot, quality) {
  const size = { width: SIZE, height: SIZE };
  const output = { format: 'raw', layers: { format: 'raw' } };
  const { data, layers, info } = await renderer.render(model, { size, layers: ALL, environment: 'none', ...shot, quality, output }, { timeoutMs: null });
  const floats = Object.entries(layers).map(([name, bytes]) => [name, new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length))]);
  return { ...Object.fromEntries(floats), data, info, width: info.width, height: info.height };
}

const cache = new Map();
function scene(name, make, shot, quality) {
  const key = `${name} ${quality}`;
  if (!cache.has(key))
    cache.set(
      key,
      make().then((model) => drawn(model, shot, QUALITIES[quality])),
    );
  return cache.get(key);
}
const ball = (quality) => scene('ball', sphereAndSlope, { camera: CAMERA }, quality);

/** World point of a pixel's centre at a depth along the view, by the inverse of the matrix in `info`. */
function unproject({ info, width, height }, camera) {
  const back = camera.position.map((x, i) => x - camera.target[i]);
  const length = Math.hypot(...back);
  const z = back.map((x) => x / length);
  const right = [z[2], 0, -z[0]].map((v) => v / Math.hypot(z[2], z[0]));
  const up = [z[1] * right[2] - z[2] * right[1], z[2] * right[0] - z[0] * right[2], z[0] * right[1] - z[1] * right[0]];
  assert.equal(info.worldToPixel.length, 16);
  const slope = Math.tan((camera.fovY * Math.PI) / 360);
  return (x, y, depth) => {
    const [u, v] = [((2 * (x + 0.5)) / width - 1) * slope * (width / height), (1 - (2 * (y + 0.5)) / height) * slope];
    return camera.position.map((p, i) => p + depth * (u * right[i] + v * up[i] - z[i]));
  };
}

function* pixels({ width, height }, border = 0) {
  for (let y = border; y < height - border; y++) for (let x = border; x < width - border; x++) yield { x, y, i: y * width + x };
}

const triple = (list, i) => [list[3 * i], list[3 * i + 1], list[3 * i + 2]];
const most = (values) => values.reduce((a, b) => Math.max(a, b), 0);
const moved = (list, { width }, channels = 1) => list.map((_, i) => list[i + channels] ?? list[i - (width - 1) * channels]);
/** Away from the borders of parts, where one method sees one surface and the other another. */
const isInside = ({ partId, width }, { i }) => [0, 1, -1, width, -width].every((step) => partId[i + step] === partId[i] && partId[i] > 0);

for (const quality of Object.keys(QUALITIES)) {
  test(`${quality}: layers lie on the picture pixel by pixel`, async () => {
    const frame = await ball(quality);
    /** Pixels that the picture shows whole and the layer does not have, or the other way about; and how far their centres are apart. */
    const apart = (ids) => {
      let wrong = 0;
      const sums = { ids: [0, 0, 0], alpha: [0, 0, 0] };
      for (const { x, y, i } of pixels(frame)) {
        const alpha = frame.data[4 * i + 3];
        if ((alpha === 255 && ids[i] === 0) || (alpha === 0 && ids[i] > 0)) wrong++;
        for (const [sum, weight] of [
          [sums.ids, ids[i] > 0 ? 1 : 0],
          [sums.alpha, alpha / 255],
        ])
          [1, x, y].forEach((value, k) => (sum[k] += weight * value));
      }
      const [a, b] = [sums.ids, sums.alpha].map(([area, sx, sy]) => [sx / area, sy / area]);
      return { wrong, shift: Math.hypot(a[0] - b[0], a[1] - b[1]) };
    };
    const figure = apart(frame.partId);
    assert.equal(figure.wrong, 0);
    // One sample a pixel along an outline of 250 pixels: its centre is within a part of a pixel over the root of that many.
    assert.ok(figure.shift < 0.05, `${figure.shift} pixels`);
    assert.ok(apart(moved(frame.partId, frame)).shift > 0.05, 'a layer that is moved by a pixel');
    for (const name of ['depth', 'materialId']) for (const { i } of pixels(frame)) assert.equal(frame[name][i] > 0, frame.partId[i] > 0);
    const off = most([...pixels(frame)].map(({ i }) => Math.abs(frame.coverage[i] - frame.data[4 * i + 3] / 255)));
    assert.ok(off <= 1 / 255 + 1e-6, `coverage is the picture's alpha: ${off}`);
  });

  test(`${quality}: the depth of a plane`, async () => {
    const frame = await ball(quality);
    const at = unproject(frame, CAMERA);
    // Leaning back, it looks up.
    const normal = [0, Math.sin(Math.PI / 6), Math.cos(Math.PI / 6)];
    const figure = (depth) =>
      most(
        [...pixels(frame)]
          .filter(({ i }) => frame.partId[i] === 2)
          .map(({ x, y, i }) => {
            const [near, far] = [at(x, y, 0), at(x, y, 1)];
            const height = (p) => normal.reduce((sum, n, k) => sum + n * (p[k] - [0.25, 0, -0.6][k]), 0);
            const exact = height(near) / (height(near) - height(far));
            return Math.abs(depth[i] / exact - 1);
          }),
      );
    assert.ok(figure(frame.depth) < 1e-4, `${figure(frame.depth)}`);
    assert.ok(figure(frame.depth.map((z) => z * 1.0003)) > 1e-4, 'a depth that is off by 0.03 %');
    const values = frame.depth.filter((z) => z > 0);
    assert.deepEqual(frame.info.layers.depth.range, [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))]);
  });

  test(`${quality}: the normals of a sphere, in world space`, async () => {
    const frame = await ball(quality);
    const at = unproject(frame, CAMERA);
    const figure = (normals) =>
      most(
        [...pixels(frame)]
          .filter(({ i }) => frame.partId[i] === 1)
          .map(({ x, y, i }) => {
            const p = at(x, y, frame.depth[i]).map((v, k) => (v - [0, 0, 0.2][k]) / 0.5);
            const n = triple(normals, i);
            return Math.hypot(...n.map((v, k) => v - p[k] / Math.hypot(...p)));
          }),
      );
    // Of 96 rings: within a triangle of 1.9 degrees, blended normals and places differ by less than the square of its angle, 1.1e-3.
    assert.ok(figure(frame.normal) < 1.1e-3, `${figure(frame.normal)}`);
    assert.ok(figure(frame.normal.map((v, i) => (i % 3 === 1 ? -v : v))) > 1.1e-3, 'normals upside down');
    assert.ok(figure(frame.normal.map((v, i) => (i % 3 === 0 ? v + 0.002 : v))) > 1.1e-3, 'normals that lean by a tenth of a degree');
  });

  test(`${quality}: numbers and their legends`, async () => {
    const frame = await ball(quality);
    const { partId, materialId } = frame.info.layers;
    assert.deepEqual(
      partId.legend.map(({ id, name }) => [id, name]),
      [
        [1, 'ball'],
        [2, 'slope'],
      ],
    );
    assert.deepEqual(
      materialId.legend.map(({ id, material, name }) => [id, material, name]),
      [
        [1, 0, 'red'],
        [2, 1, 'blue'],
      ],
    );
    const wrong = (parts, materials) => {
      let count = 0;
      for (const { i } of pixels(frame)) {
        if (![0, 1, 2].includes(parts[i])) count++;
        if (parts[i] === 0) continue;
        const isBall = partId.legend[parts[i] - 1]?.name === 'ball';
        const isRed = materialId.legend[materials[i] - 1]?.name === 'red';
        const [r, , b] = triple(frame.albedo, i);
        if (isBall !== isRed || isRed !== r > b) count++;
      }
      return count;
    };
    assert.equal(wrong(frame.partId, frame.materialId), 0);
    const swapped = frame.materialId.map((id) => (id > 0 ? 3 - id : 0));
    assert.ok(wrong(frame.partId, swapped) > 1000, 'materials that are swapped');
    const blended = frame.partId.map((id, i) => (id + (frame.partId[i + 1] ?? id)) / 2);
    assert.ok(wrong(blended, frame.materialId) > 50, 'numbers that are antialiased');
  });

  test(`${quality}: what has no material has a number of its own, also beside a cloth that a shot puts on`, async () => {
    for (const materials of [{}, { red: { preset: 'denim' } }]) {
      const frame = await drawn(await ballOfNoMaterial(), { camera: CAMERA, materials }, QUALITIES[quality]);
      const { partId, materialId } = frame.info.layers;
      assert.deepEqual(
        materialId.legend.map(({ material, name }) => [material, name]),
        [
          [null, ''],
          [0, 'red'],
        ],
      );
      const numbers = { ball: new Set(), slope: new Set() };
      for (const { i } of pixels(frame)) if (frame.partId[i] > 0) numbers[partId.legend[frame.partId[i] - 1].name].add(frame.materialId[i]);
      const numberOf = (wanted) => materialId.legend.find(({ material }) => material === wanted).id;
      assert.deepEqual(numbers, { ball: new Set([numberOf(null)]), slope: new Set([numberOf(0)]) });
    }
  });

  test(`${quality}: the albedo is the base colour`, async () => {
    const frame = await ball(quality);
    const figure = (albedo) =>
      most(
        [...pixels(frame)]
          .filter(({ i }) => frame.partId[i] > 0)
          .flatMap(({ i }) => triple(albedo, i).map((v, c) => Math.abs(v - [RED, BLUE][frame.partId[i] - 1][c]))),
      );
    // Factors alone: the same float.
    assert.ok(figure(frame.albedo) < 1e-6);
    assert.ok(figure(frame.albedo.map((v) => v * 0.96)) > 1e-6, 'what a dielectric reflects is taken off');
  });

  test(`${quality}: ambient occlusion in the corner of a box`, async () => {
    const camera = { position: [2, 1.8, 2], target: [0.35, 0.3, 0.35], fovY: 36, near: 0.5, far: 6 };
    const frame = await scene('corner', corner, { camera }, quality);
    const at = unproject(frame, camera);
    const faces = {
      1: { normal: [0, 1, 0], axis: 1 },
      2: { normal: [0, 0, 1], axis: 2 },
      3: { normal: [1, 0, 0], axis: 0 },
    };
    /** The square at 0 along an axis. */
    const square = (axis) =>
      [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 1],
      ].map(([a, b]) => [0, 0, 0].map((_, i) => (i === axis ? 0 : i === (axis + 1) % 3 ? a : b)));
    const errors = (ao) =>
      [...pixels(frame)]
        .filter(({ i }) => frame.partId[i] > 0)
        .map(({ x, y, i }) => ({ point: at(x, y, frame.depth[i]), value: ao[i], face: faces[frame.partId[i]] }))
        // The raster's corners lie on a grid of 1/256 of a pixel, and its rays start 1/64 of one above: nearer to another face they may miss it.
        .filter(({ point, face }) => point.every((v, k) => k === face.axis || v > 0.01))
        .map(({ point, value, face: { normal, axis } }) => {
          const others = [0, 1, 2].filter((k) => k !== axis).map((k) => formFactor(point, normal, square(k)));
          return Math.abs(value - (1 - others[0] - others[1]));
        });
    const figure = (ao) => {
      const list = errors(ao);
      assert.ok(list.length > 3000);
      return { mean: list.reduce((a, b) => a + b, 0) / list.length, worst: most(list) };
    };
    const { mean, worst } = figure(frame.ao);
    // 256 rays of a pixel and its neighbours, or 64 of a pixel, that fill the disk evenly: a border through N points is off by about
    // N ** -0.75, 0.016 and 0.044; the mean of many by half of it. The raster's neighbours reach 5 cm here: where a crease ends at an open
    // border, occlusion falls by as much as 0.15 on that way, and half of it remains.
    const bars = { raster: { mean: 0.008, worst: 0.08 }, reference: { mean: 0.03, worst: 0.15 } }[quality];
    assert.ok(mean < bars.mean && worst < bars.worst, `${mean} ${worst}`);
    assert.ok(figure(frame.ao.map((v) => v ** 0.8)).mean > bars.mean, 'occlusion that is too weak');
    assert.ok(figure(frame.ao.map(() => 1)).mean > bars.mean, 'none');
  });

  test(`${quality}: the shadow of a roof`, async () => {
    const camera = { position: [1.2, 2.4, 2.2], target: [0, 0, 0], fovY: 40, near: 0.5, far: 6 };
    const sun = { type: 'directional', position: [0.5, 1, 0], target: [0, 0, 0], castShadow: true, shadow: { mapSize: 2048 } };
    const frame = await scene('canopy', canopy, { camera, lights: [sun] }, quality);
    const at = unproject(frame, camera);
    const wrong = (shadow) =>
      [...pixels(frame)].filter(({ x, y, i }) => {
        if (frame.partId[i] !== 1) return false;
        const [px, , pz] = at(x, y, frame.depth[i]);
        // The light falls from +x: half a metre up is a quarter to -x. Within 15 mm of its border the raster's filter is soft:
        // 2 texels and a half of a map of 2048 over 4 m, and the lift by its normal.
        const outside = Math.max(Math.abs(px + 0.25), Math.abs(pz)) - 0.25;
        return Math.abs(outside) > 0.015 && Math.abs(shadow[i] - (outside < 0 ? 1 : 0)) > 0.01;
      }).length;
    assert.equal(wrong(frame.shadow), 0);
    assert.ok(wrong(moved(frame.shadow, frame)) > 0, 'a shadow that is moved by a pixel');
    assert.ok([...frame.shadow].some((v) => v === 1));
  });
}

test('raster and path tracer draw the same layers', async () => {
  const [raster, reference] = [await ball('raster'), await ball('reference')];
  const bars = {
    // Both are floats of one geometry: rounding of 32 bits, and of GL's interpolation along a view of 3 m.
    depth: 2e-5,
    // Interpolated along the screen there, over the triangle here.
    normal: 2e-3,
    albedo: 1e-6,
    partId: 0,
    materialId: 0,
    // 256 rays against 64: the error of the 64.
    ao: 0.15,
    // No light throws a shadow here.
    shadow: 0,
    // One algorithm.
    line: 0,
  };
  for (const [name, bar] of Object.entries(bars)) {
    const channels = CHANNELS[name] ?? 1;
    const figure = (layer) =>
      most(
        [...pixels(raster, 1)]
          .filter((pixel) => name === 'line' || (isInside(raster, pixel) && isInside(reference, pixel)))
          .flatMap(({ i }) => Array.from({ length: channels }, (_, c) => Math.abs(layer[i * channels + c] - reference[name][i * channels + c]))),
      );
    assert.ok(figure(raster[name]) <= bar, `${name}: ${figure(raster[name])}`);
    if (name !== 'shadow') assert.ok(figure(raster[name].map((v) => v * 1.2 + 1e-3)) > bar, `${name} with a fault`);
  }
  const borders = [...pixels(raster)].filter(({ i }) => raster.partId[i] !== reference.partId[i]).length;
  assert.ok(borders <= 4, `${borders} pixels whose centre lies on a border`);
  // The path tracer's 64 samples fall at random, the raster's four in a pattern: a pixel that is cut is off by up to a quarter.
  const mean = [...pixels(raster)].reduce((sum, { i }) => sum + Math.abs(raster.coverage[i] - reference.coverage[i]), 0) / (SIZE * SIZE);
  assert.ok(mean < 0.01, `${mean}`);
});

test('the shadow on the ground is in the layer of shadows, by both', async () => {
  const sun = { type: 'directional', position: [0, 1, 0.6], target: [0, 0, 0], castShadow: true };
  const shot = { camera: { position: [1.2, 1.6, 3], target: [0, -0.3, -0.2], fovY: 40 }, lights: [sun], ground: { opacity: 0.5 } };
  const [raster, reference] = await Promise.all(Object.keys(QUALITIES).map((quality) => scene('ground', sphereAndSlope, shot, quality)));
  const onGround = [...pixels(raster)].filter(({ i }) => raster.partId[i] === 0 && raster.shadow[i] > 0.99);
  assert.ok(onGround.length > 50, `${onGround.length} pixels`);
  const off = [...pixels(raster)].filter(({ i }) => Math.abs(raster.shadow[i] - reference.shadow[i]) > 0.5 && raster.partId[i] === 0);
  assert.ok(off.length < onGround.length / 10, `${off.length} of ${onGround.length}`);
  for (const frame of [raster, reference]) {
    const painted = [...pixels(frame)].filter(({ i }) => frame.partId[i] === 0 && frame.coverage[i] > 0.6);
    assert.equal(painted.length, 0, 'the ground is no part of the model');
  }
});

test('nothing is paid and nothing comes when no layer is asked for', async () => {
  const model = await sphereAndSlope();
  const plain = await renderer.render(model, { size: { width: 64, height: 64 } });
  assert.equal(plain.layers, undefined);
  assert.equal(plain.info.layers, undefined);
  assert.equal(plain.info.milliseconds.layers, undefined);
  const withDepth = await renderer.render(model, { size: { width: 64, height: 64 }, layers: ['depth'] });
  assert.deepEqual(Object.keys(withDepth.layers), ['depth']);
  assert.ok(withDepth.data.equals(plain.data), 'the colour is the same');
});
