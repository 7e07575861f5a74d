import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { inspect } from '../../../js/index.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { factsOf } from '../../../js/three/index.mjs';
import '../api/support/real.mjs';

const lens = { yfov: 0.6, znear: 0.1, zfar: 50 };
const mesh = new Float32Array([-1, 0, 0, 1, 0, 0, 0, 2, 0.5]);

/** Cameras in every way that a node can hold one: alone, beside a mesh, beneath a turned parent, twice: the server goes level by level. */
const DOCUMENT = {
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0, 1, 2, 4] }],
  nodes: [
    { name: 'flat', camera: 2, translation: [0, 1, 5] },
    { name: 'beside', camera: 1, mesh: 0 },
    { name: 'parent', rotation: [0, Math.SQRT1_2, 0, Math.SQRT1_2], scale: [2, 2, 2], children: [3] },
    { name: 'child', camera: 0, translation: [0, 0.5, 3] },
    { name: 'again', camera: 0, rotation: [Math.SQRT1_2, 0, 0, Math.SQRT1_2], translation: [0, -4, 0] },
  ],
  cameras: [
    { name: 'wide', type: 'perspective', perspective: { ...lens, aspectRatio: 1.5 } },
    { type: 'perspective', perspective: { yfov: 1, znear: 0.01 } },
    { name: 'plan', type: 'orthographic', orthographic: { xmag: 2, ymag: 1.5, znear: 0, zfar: 20 } },
    { name: 'broken', type: 'perspective', perspective: { ...lens, zfar: 0.05 } },
  ],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
  accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [-1, 0, 0], max: [1, 2, 0.5] }],
  bufferViews: [{ buffer: 0, byteLength: 36 }],
  buffers: [{ byteLength: 36 }],
};

function glbOf(document, binary) {
  const json = JSON.stringify(document);
  const chunk = (type, data) => [Buffer.from(Uint32Array.of(data.length, type).buffer), data];
  const chunks = [...chunk(0x4e4f534a, Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4))), ...chunk(0x4e4942, binary)];
  const bytes = chunks.reduce((sum, part) => sum + part.length, 12);
  return Buffer.concat([Buffer.from(Uint32Array.of(0x46546c67, 2, bytes).buffer), ...chunks]);
}

/** Numbers apart by rounding alone. */
function assertNear(actual, expected, path = '') {
  if (typeof expected === 'number') assert.ok(Math.abs(actual - expected) < 1e-9, `${path}: ${actual}, not ${expected}`);
  else if (typeof expected !== 'object' || expected === null) assert.equal(actual, expected, path);
  else for (const key of Object.keys(expected)) assertNear(actual[key], expected[key], `${path}.${key}`);
}

test('browser and server list the cameras of a model alike, and frame through them alike', async () => {
  const glb = glbOf(DOCUMENT, Buffer.from(mesh.buffer));
  const server = await inspect(glb);
  const model = await new GLTFLoader().parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.length), '');
  const browser = factsOf(model, { THREE });
  assert.deepEqual(
    browser.cameras.map(({ name }) => name),
    ['wide', 'wide', 'beside', 'plan'],
  );
  assert.equal(server.cameras.length, 4);
  assertNear(
    browser.cameras,
    server.cameras.map(({ node, width, aspectRatio, ...camera }) => camera),
  );
  for (const gltf of [0, 1, 2, 'plan']) assertNear(resolveShot({ camera: { gltf } }, browser), resolveShot({ camera: { gltf } }, server));
});
