// The files of layers, read by other libraries than those that wrote them: PNG by sharp, EXR by three.js's EXRLoader.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import sharp from 'sharp';
import { FloatType } from 'three';
import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';
import { createRenderer } from '../../../js/index.mjs';
import { LAYERS } from '../../../js/shot/table/layers.mjs';
import { sphereAndSlope } from './support/layer_scenes.mjs';
import './support/real.mjs';

const NAMES = Object.keys(LAYERS);
const SHOT = {
  size: { width: 61, height: 47 },
  camera: { position: [0.6, 0.5, 2.6], target: [0.1, 0.05, 0], fovY: 40, near: 0.5, far: 6 },
  environment: 'none',
  lights: [{ type: 'directional', position: [1, 2, 1], castShadow: true }],
  layers: NAMES,
};

let renderer;
let model;
let truth;
before(async () => {
  renderer = await createRenderer();
  model = await renderer.load(await sphereAndSlope());
  truth = await drawn({ format: 'raw', layers: { format: 'raw' } });
});
after(() => renderer.close());

const drawn = (output, layers = NAMES) => renderer.render(model, { ...SHOT, layers, output });
const floatsOf = (bytes) => new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const exact = (name) => floatsOf(truth.layers[name]);
const channelsOf = (name) => LAYERS[name].channels.length;
const most = (values) => values.reduce((a, b) => Math.max(a, b), 0);

/** What a whole number of a PNG file stands for, as renderer/include/telar/layers.h says. */
function decoded(name, value, max, isNone, range) {
  if (name === 'partId' || name === 'materialId') return value;
  if (isNone) return 0;
  if (name === 'depth') return range[0] + ((value - 1) / (max - 1)) * (range[1] - range[0]);
  if (name === 'normal') return (2 * value) / max - 1;
  const part = value / max;
  if (name === 'albedo') return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  return part;
}

/** Samples of a PNG file as they stand in it. */
async function samplesOf(bytes, channels, bitDepth) {
  const { depth } = await sharp(bytes).metadata();
  assert.equal(depth, bitDepth === 16 ? 'ushort' : 'uchar');
  const wide = bitDepth === 16;
  const space = channels === 1 ? (wide ? 'grey16' : 'b-w') : wide ? 'rgb16' : 'srgb';
  const { data, info } = await sharp(bytes)
    .toColourspace(space)
    .raw({ depth: wide ? 'ushort' : 'uchar' })
    .toBuffer({ resolveWithObject: true });
  assert.deepEqual([info.width, info.height, info.channels], [61, 47, channels]);
  return wide ? new Uint16Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.length)) : new Uint8Array(data);
}

for (const bitDepth of [16, 8]) {
  test(`PNG of ${bitDepth} bits holds every layer within its step`, async () => {
    const max = 2 ** bitDepth - 1;
    const { layers, info } = await drawn({ layers: { format: 'png', bitDepth } });
    assert.deepEqual(Object.keys(layers), NAMES);
    for (const name of NAMES) {
      const channels = channelsOf(name);
      const samples = await samplesOf(layers[name], channels, bitDepth);
      const expected = exact(name);
      const figure = (list) =>
        most(
          [...list].map((value, i) => {
            const pixel = list.subarray(i - (i % channels), i - (i % channels) + channels);
            const isNone = pixel.every((sample) => sample === 0);
            return Math.abs(decoded(name, value, max, isNone, info.layers.depth.range) - expected[i]);
          }),
        );
      const span = { depth: info.layers.depth.range[1] - info.layers.depth.range[0], normal: 2, partId: 0, materialId: 0 }[name] ?? 1;
      // Half a step, and for sRGB the slope of its curve at white, 2.4 / 1.055.
      const bar = ((name === 'albedo' ? 2.3 : 1) * span * 0.51) / max + 1e-6;
      assert.ok(figure(samples) <= bar, `${name}: ${figure(samples)} > ${bar}`);
      const shown = expected.findIndex((value) => value > 0);
      const wrong = samples.slice();
      wrong[shown] += wrong[shown] > 4 ? -3 : 3;
      assert.ok(figure(wrong) > bar, `${name} with one sample that is off by three`);
    }
  });
}

/** Channels by name: the loader gives planes in the order of the file. */
function exrChannels(bytes) {
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  const header = Buffer.from(buffer);
  const at = header.indexOf('channels\0chlist\0', 0, 'latin1') + 'channels\0chlist\0'.length + 4;
  const names = [];
  for (let i = at; header[i] !== 0; ) {
    const end = header.indexOf(0, i);
    names.push({ name: header.toString('latin1', i, end), type: header.readUInt32LE(end + 1) });
    i = end + 17;
  }
  return names;
}

const UINT_HALF_FLOAT = ['uint', 'half', 'float'];

test('EXR files have channels of these names and kinds', async () => {
  for (const bitDepth of [32, 16]) {
    const { layers } = await drawn({ layers: { format: 'exr', bitDepth } });
    for (const name of NAMES) {
      const kind = name.endsWith('Id') || bitDepth === 32 ? 'float' : 'half';
      assert.deepEqual(
        exrChannels(layers[name]).map(({ name: channel, type }) => [channel, UINT_HALF_FLOAT[type]]),
        LAYERS[name].channels.toSorted().map((channel) => [channel, kind]),
        name,
      );
    }
  }
});

test('EXR of a colour layer reads back to the bit, and half floats to their step', async () => {
  const loader = new EXRLoader().setDataType(FloatType);
  for (const [bitDepth, bar] of [
    [32, 0],
    [16, 2 ** -12],
  ]) {
    const { layers } = await drawn({ layers: { format: 'exr', bitDepth } });
    const bytes = layers.albedo;
    const { data, width, height } = loader.parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
    const expected = exact('albedo');
    const figure = (read) =>
      most(
        Array.from({ length: 3 * width * height }, (_, i) => {
          const [pixel, c] = [Math.floor(i / 3), i % 3];
          const [x, y] = [pixel % width, Math.floor(pixel / width)];
          // The loader gives the lowest row first.
          return Math.abs(read[4 * ((height - 1 - y) * width + x) + c] - expected[i]);
        }),
      );
    assert.ok(figure(data) <= bar, `${bitDepth}: ${figure(data)}`);
    assert.ok(figure(data.map((v) => v + 1e-3)) > bar);
  }
});

test('one EXR file holds the colour and every layer; its colour is that of the file without them', async () => {
  const { data, layers } = await drawn({ format: 'exr', bitDepth: 32, layers: { format: 'exr', together: true } });
  assert.equal(layers, undefined);
  const named = NAMES.flatMap((name) => LAYERS[name].channels.map((channel) => `${name}.${channel}`));
  assert.deepEqual(
    exrChannels(data)
      .map(({ name }) => name)
      .toSorted(),
    ['A', 'B', 'G', 'R', ...named].toSorted(),
  );
  const alone = await drawn({ format: 'exr', bitDepth: 32 }, ['beauty']);
  const loader = new EXRLoader().setDataType(FloatType);
  const [whole, colour] = [data, alone.data].map((bytes) => loader.parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)).data);
  assert.deepEqual(whole, colour);
});

test('numbers that do not fit are refused by name', async () => {
  const many = { width: 8, height: 8 };
  const nodes = Array.from({ length: 300 }, (_, i) => ({ name: `tile ${i}`, mesh: 0, translation: [i, 0, 0] }));
  const positions = Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer);
  const gltf = {
    asset: { version: '2.0' },
    buffers: [{ byteLength: positions.length, uri: `data:application/octet-stream;base64,${positions.toString('base64')}` }],
    bufferViews: [{ buffer: 0, byteLength: positions.length }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    nodes,
    scenes: [{ nodes: nodes.map((_, i) => i) }],
    scene: 0,
  };
  const shot = { size: many, layers: ['partId'], camera: { position: [299.3, 0.3, 1], target: [299.3, 0.3, 0], height: 0.2 } };
  const bytes = Buffer.from(JSON.stringify(gltf));
  await assert.rejects(renderer.render(bytes, { ...shot, output: { layers: { bitDepth: 8 } } }), {
    code: 'X_OUTPUT',
    message: 'layer partId: the number 300 does not fit into 8 bits: take format "exr", or output.layers.bitDepth 16',
  });
  const { info } = await renderer.render(bytes, shot);
  assert.equal(info.layers.partId.legend.length, 300);
});
