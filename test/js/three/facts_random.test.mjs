// What the browser measures of random models, and where its cameras stand by that: as on the server. The pictures of test/parity are drawn by cameras that
// one side resolved; this is that the other resolves the same.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import * as THREE from 'three';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { createRenderer } from '../../../js/index.mjs';
import { resolvePose, resolveShot } from '../../../js/shot/index.mjs';
import { factsOf } from '../../../js/three/index.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { COLOURWAYS } from '../../fixtures/random_file.mjs';
import { Choices, randomScene } from '../../fixtures/random_scene.mjs';
import '../api/support/real.mjs';

const SEEDS = 24;
const SHOTS = 6;
const NAMES = ['a', 'b', 'Body', 'Ärmel', 'a.b', 'sleeve 1', 'x[0]'];
const VIEWS = ['front', 'back', 'left', 'right', 'top', 'bottom', 'three-quarter'];

let renderer;
before(async () => {
  globalThis.self ??= globalThis; // GLTFLoader's pictures ask for it
  renderer = await createRenderer({ cacheDirectory: null });
  await MeshoptDecoder.ready;
});
after(() => renderer.close());

function cameraOf(c) {
  const planes = { znear: c.between(0.01, 0.5), zfar: c.between(3, 20) };
  if (c.is(0.5)) return { type: 'orthographic', orthographic: { xmag: c.between(0.3, 3), ymag: c.between(0.3, 3), ...planes } };
  return { type: 'perspective', name: c.of(NAMES), perspective: { yfov: c.between(0.2, 1.5), ...planes } };
}

/** Names, of which some are those of several, and cameras that stand beneath nodes, or alone. */
function named(c, json) {
  for (const part of [...json.nodes, ...(json.materials ?? [])]) if (c.is(0.7)) part.name = c.of(NAMES);
  json.cameras = [cameraOf(c), cameraOf(c)];
  const bodies = json.nodes.length;
  for (const camera of [0, 1, 1]) {
    const turn = [0, 1, 2, 3].map(() => c.between(-1, 1));
    const place = { translation: [0, 1, 2].map(() => c.between(-3, 3)), rotation: turn.map((x) => x / Math.hypot(...turn)) };
    const node = json.nodes.push({ camera, ...place }) - 1;
    const parent = json.nodes[Math.floor(c.between(0, bodies))];
    if (c.is(0.5)) (parent.children ??= []).push(node);
    else json.scenes[json.scene ?? 0].nodes.push(node);
  }
}

const frameOf = (c) => c.of(['scene', 'model', { node: c.of(NAMES) }, { material: c.of(NAMES) }]);

function shotOf(c, json) {
  const towards = () => (c.is(0.5) ? { view: c.of(VIEWS) } : { azimuth: c.between(-180, 180), elevation: c.between(-90, 90) });
  const view = () => ({ ...towards(), projection: c.of(['perspective', 'orthographic']), fit: c.between(0.2, 1.6), fitTo: c.of(['view', 'turntable', 'all']) });
  const shot = {
    size: c.of([
      { width: 16, height: 16 },
      { width: 24, height: 10 },
    ]),
    camera: c.is(0.3) ? { gltf: c.of([0, 1, 2, 'Body']) } : { ...view(), frame: frameOf(c) },
    lights: [{ type: 'directional', position: [1, 2, 3], castShadow: c.is(0.4) }],
    ground: c.is(0.4) ? {} : 'none',
  };
  if (json.animations) shot.pose = { animation: 0, time: c.between(-0.1, 1.5) };
  if (json.extensions?.KHR_materials_variants) shot.variant = c.of(COLOURWAYS);
  if (json.materials && c.is(0.3)) shot.ghost = [{ material: Math.floor(c.between(0, json.materials.length)), opacity: c.of([0, 0.5]) }];
  return shot;
}

async function loaded(glb) {
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
  loader.register(() => ({ name: 'no pictures', loadTexture: async () => new THREE.Texture() }));
  return loader.parseAsync(glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.length), '');
}

async function resolved(shot, measure) {
  try {
    return { shot: resolveShot(shot, await measure()) };
  } catch (error) {
    return { code: error.code, pointer: error.pointer };
  }
}

const seenFrom = ({ camera }) => [...camera.position, ...camera.target, ...camera.up, camera.near, camera.far, camera.fovY ?? camera.height];

/** Of the largest number: floats of 32 bits stand between, and outlines are those of some 100 directions. */
const TOLERANCE = 1e-4;
const isNear = (a, b, most) => a.every((x, i) => Math.abs(x - b[i]) <= TOLERANCE * most);

/** What is wrong of one model. @param {(facts: object) => object} change - Of what the browser measures; to plant a fault. */
async function differencesOf(seed, change = (facts) => facts) {
  const c = new Choices(seed);
  const scene = await randomScene(seed);
  let document;
  const glb = Buffer.from(
    editedGlb(scene, (json) => {
      document = json;
      named(c, json);
    }),
  );
  // Those decoders need workers and a GL.
  const needs = document.extensionsRequired ?? [];
  if (needs.includes('KHR_draco_mesh_compression') || needs.includes('KHR_texture_basisu')) return undefined;
  const [server, browser] = [await renderer.load(glb), await loaded(glb)];
  const wrong = [];
  for (let i = 0; i < SHOTS; i++) {
    const shot = shotOf(c, document);
    const here = await resolved(shot, () => renderer.factsOf(server, shot));
    const there = await resolved(shot, () => {
      const pose = resolvePose(shot, browser);
      return change(factsOf(browser, { THREE, pose, frame: shot.camera.frame, variant: shot.variant ?? '', ghost: shot.ghost ?? [] }));
    });
    if (!here.shot || !there.shot) {
      if (here.code !== there.code || here.pointer !== there.pointer) wrong.push({ seed, shot, here, there });
      continue;
    }
    const [a, b] = [seenFrom(here.shot), seenFrom(there.shot)];
    if (!isNear(a, b, Math.max(...a.map(Math.abs)))) wrong.push({ seed, shot, here: a, there: b });
  }
  await renderer.release(server);
  return wrong;
}

test('browser and server resolve cameras of random models alike', async () => {
  const found = [];
  for (let seed = 0; seed < SEEDS; seed++) found.push(await differencesOf(seed));
  const drawn = found.filter((wrong) => wrong !== undefined);
  assert.ok(drawn.length > SEEDS / 2, `${drawn.length} models`);
  assert.deepEqual(drawn.flat(), []);
});

test('a model that the browser measures 1 % higher is told', async () => {
  const higher = (facts) => {
    const outline = facts.outline.map(([x, y, z]) => [x, y * 1.01, z]);
    return { ...facts, outline };
  };
  const found = [];
  for (let seed = 0; seed < SEEDS / 4; seed++) found.push(...((await differencesOf(seed, higher)) ?? []));
  assert.ok(found.length > 0);
});
