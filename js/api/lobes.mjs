import { readSource } from './source.mjs';
import { nativeCall } from './native_call.mjs';
import { wrongOption } from './options.mjs';
import { lobesOptions } from './lobes_options.mjs';
import { shotJson } from './shot_json.mjs';
import { loadNative } from './native.mjs';
import { Model, loadModel, shotModule } from './model.mjs';
import { ANY_MODEL } from '../shot/facts.mjs';

/** Lobes in the order of the addon's numbers, three a lobe. */
const LOBES = ['diffuse', 'specular', 'sheen', 'coat', 'total'];
const PER_DIRECTION = LOBES.length * 3;

/** A glTF of one triangle in the material, so that the loader reads and checks it like any other. */
function triangleIn(material) {
  const corners = Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer);
  return Buffer.from(
    jsonOf({
      asset: { version: '2.0' },
      extensionsUsed: Object.keys(material.extensions ?? {}),
      buffers: [{ byteLength: corners.length, uri: `data:application/octet-stream;base64,${corners.toString('base64')}` }],
      bufferViews: [{ buffer: 0, byteLength: corners.length }],
      accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] }],
      materials: [material],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }],
      nodes: [{ mesh: 0 }],
      scenes: [{ nodes: [0] }],
      scene: 0,
    }),
  );
}

function jsonOf(file) {
  try {
    return JSON.stringify(file);
  } catch (error) {
    throw wrongOption('options.material', `plain data as in JSON (${error.message.split('\n')[0]})`, file.materials[0]);
  }
}

async function sceneOf(native, { model, material }, signal) {
  if (model) return { scene: Model.sceneOf(model), index: material };
  const input = readSource(native, triangleIn(material), native.limits.L_FILE_BYTES);
  return { scene: Model.sceneOf(await loadModel(native, input, {}, { work: { signal } })), index: 0 };
}

/** {diffuse: [r, g, b], ...} of the numbers from `start`. */
function lobesAt(numbers, start) {
  const lobes = {};
  let at = start;
  for (const lobe of LOBES) {
    lobes[lobe] = [numbers[at], numbers[at + 1], numbers[at + 2]];
    at += 3;
  }
  return lobes;
}

/** Documented in js/api/lobes.d.ts. */
export async function evaluateShading(options) {
  const { model, material, shading, viewAngle, directions, albedo, signal } = lobesOptions(options, Model.isModel);
  const native = loadNative();
  const { resolveShot } = await shotModule();
  const shot = shotJson(resolveShot({ shading }, ANY_MODEL));
  const { scene, index } = await sceneOf(native, { model, material }, signal);
  const request = { material: index, shot, viewAngle, directions: Float64Array.from(directions.flat()), albedo };
  const numbers = await nativeCall(native, { signal }, (token) => native.evaluateLobes(scene, request, token));
  return {
    radiance: directions.map((_, i) => lobesAt(numbers.radiance, i * PER_DIRECTION)),
    albedo: albedo ? lobesAt(numbers.albedo, 0) : null,
    albedoError: albedo ? lobesAt(numbers.albedo, PER_DIRECTION) : null,
  };
}
