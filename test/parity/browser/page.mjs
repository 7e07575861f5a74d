// Runs in Chromium: loads a model with stock three.js, sets the shot up, and sends the drawing buffer's bytes back.
import * as THREE from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { client } from 'client';
import { applyShot, rendererParameters } from '/js/three/index.mjs';
import { applyShading } from '/js/three/shading.mjs';
import { environmentOf } from '/js/three/suns.mjs';
import { prefilteredFaces } from './prefilter.mjs';
import { measureTerms } from './terms.mjs';

const dracoLoader = new DRACOLoader().setDecoderPath('/node_modules/three/examples/jsm/libs/draco/gltf/');
const loaders = new Map();

/**
 * @param {'uncompressed'} [textures] - Lets KTX2Loader transcode to RGBA8 alone, which holds what the file says; otherwise
 *   to the GPU formats of this browser.
 */
function loaderFor(renderer, textures) {
  if (!loaders.has(textures)) {
    const ktx2 = new KTX2Loader().setTranscoderPath('/node_modules/three/examples/jsm/libs/basis/').detectSupport(renderer);
    if (textures === 'uncompressed') for (const key of Object.keys(ktx2.workerConfig)) ktx2.workerConfig[key] = false;
    loaders.set(textures, new GLTFLoader().setDRACOLoader(dracoLoader).setKTX2Loader(ktx2).setMeshoptDecoder(MeshoptDecoder));
  }
  return loaders.get(textures);
}

/** One renderer per set of context parameters: a page may hold only a few GL contexts. */
const renderers = new Map();

function rendererFor(shot) {
  const parameters = rendererParameters(shot);
  const key = JSON.stringify(parameters);
  if (!renderers.has(key)) {
    const renderer = new THREE.WebGLRenderer({ ...parameters, preserveDrawingBuffer: true });
    renderers.set(key, renderer);
  }
  return renderers.get(key);
}

/** Textures by URL, the last used last: three keeps what it prefiltered of a texture as long as the texture lives. */
const environments = new Map();
const MAX_ENVIRONMENTS = 12;

async function loadEnvironment({ url, format }) {
  const loader = format === 'exr' ? new EXRLoader() : new HDRLoader();
  const texture = environments.get(url) ?? (await loader.setDataType(THREE.FloatType).loadAsync(url));
  environments.delete(url);
  environments.set(url, texture);
  if (environments.size > MAX_ENVIRONMENTS) {
    const [oldest, unused] = environments.entries().next().value;
    environments.delete(oldest);
    unused.dispose();
  }
  return texture;
}

/** Everything that a draw needs: `job` is {shot, model: url, environment: {url, format} | null, ownText, settings}. */
async function prepare(job) {
  const renderer = rendererFor(job.shot);
  const model = await loaderFor(renderer, job.textures).loadAsync(job.model);
  const environment = job.environment ? await loadEnvironment(job.environment) : undefined;
  const scene = new THREE.Scene();
  scene.add(model.scene);
  const apply = (shot) =>
    applyShot(shot, {
      THREE,
      renderer,
      scene,
      model,
      environment,
      revision: 'client',
      cloths: (preset) => loaderFor(renderer).loadAsync(`/js/assets/cloths/${preset}.glb`),
      areaLightTables: () => import('three/addons/lights/RectAreaLightUniformsLib.js'),
    });
  const camera = await apply(job.shot);
  client.finishScene({ renderer, settings: job.settings });
  if (job.ownText) await applyShading(model, 'three', { THREE, ownText: true });
  return { renderer, scene, camera, apply, dispose: () => disposeModel(model.scene, job.keepPrograms) };
}

function disposeModel(root, keepPrograms) {
  root.traverse((object) => {
    object.geometry?.dispose();
    for (const material of [object.material ?? []].flat()) {
      for (const value of Object.values(material)) if (value?.isTexture) value.dispose();
      // three lets a program go with the last material that has it.
      if (!keepPrograms) material.dispose();
    }
  });
}

/** Drawing buffer as it is: RGBA8, premultiplied, bottom row first. */
function readDrawingBuffer(renderer) {
  const gl = renderer.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const pixels = new Uint8Array(width * height * 4);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

async function send(url, bytes) {
  const response = await fetch(url, { method: 'PUT', body: bytes });
  if (!response.ok) throw new Error(`sending the result: HTTP ${response.status}`);
}

/**
 * Draws a job; PUTs the picture to `${job.result}/image`, and where it has a background the same without one to
 * `${job.result}/mask`.
 * @returns {Promise<object>} Facts: GL strings, samples, draw calls, meshes lit by three.js's own text, milliseconds.
 */
window.telarDraw = async (job) => {
  try {
    return await draw(job);
  } catch (error) {
    // What three.js threw in the midst of would show in the next pictures.
    for (const renderer of renderers.values()) renderer.forceContextLoss();
    renderers.clear();
    throw error;
  }
};

async function draw(job) {
  const begin = performance.now();
  const { renderer, scene, camera, dispose } = await prepare(job);
  const loaded = performance.now();
  renderer.render(scene, camera);
  const image = readDrawingBuffer(renderer);
  const drawn = performance.now();
  const calls = renderer.info.render.calls;
  let mask = null;
  if (scene.background) {
    scene.background = null;
    renderer.render(scene, camera);
    mask = readDrawingBuffer(renderer);
  }
  const left = stockMeshes(scene);
  dispose();
  await send(`${job.result}/image`, image);
  if (mask) await send(`${job.result}/mask`, mask);
  return { ...contextFacts(renderer), calls, left, loadMs: loaded - begin, drawMs: drawn - loaded };
}

/** How many meshes stock three.js's text lights. */
function stockMeshes(scene) {
  let count = 0;
  scene.traverse(({ material }) => (count += Number(material?.isMeshStandardMaterial === true && !material.isTelarShadingMaterial)));
  return count;
}

function contextFacts(renderer) {
  const gl = renderer.getContext();
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return {
    three: THREE.REVISION,
    gl: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
    samples: gl.getParameter(gl.SAMPLES),
    error: gl.getError(),
  };
}

/**
 * Draws one shot after the other with the same loaded model; PUTs the pictures to `${job.result}/0`, `1` ...
 * @returns {Promise<{programs: number, textures: number}[]>} What the renderer holds after each.
 */
window.telarSequence = async (job) => {
  const { renderer, scene, apply, dispose } = await prepare({ ...job, shot: job.shots[0] });
  const held = [];
  for (const [i, shot] of job.shots.entries()) {
    renderer.render(scene, await apply(shot));
    held.push({ programs: renderer.info.programs.length, textures: renderer.info.memory.textures });
    await send(`${job.result}/${i}`, readDrawingBuffer(renderer));
  }
  dispose();
  return held;
};

/**
 * PUTs three's own shader variables (terms.mjs) to `${job.result}/TERM`.
 * @returns {Promise<string[]>} Their names.
 */
window.telarTerms = async (job) => {
  const prepared = await prepare(job);
  const names = [];
  for (const [name, values] of measureTerms(THREE, prepared, job)) {
    await send(`${job.result}/${name}`, values);
    names.push(name);
  }
  prepared.dispose();
  return names;
};

/**
 * PUTs every face of the prefiltered environment (prefilter.mjs) to `${job.result}/LEVEL-FACE`.
 * @returns {Promise<{name: string, size: number, height?: number}[]>}
 */
window.telarPrefilter = async (job) => {
  const { texture: environment } = environmentOf(THREE, await loadEnvironment(job.environment));
  const faces = [];
  for (const { values, ...face } of prefilteredFaces(THREE, rendererFor(job.shot), environment)) {
    await send(`${job.result}/${face.name}`, values);
    faces.push(face);
  }
  return faces;
};

window.telarReady = true;
