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
  return Buffer.from(jsonOf({
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
  }));
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
const lobesAt = (numbers, start) => Object.fromEntries(LOBES.map((lobe, i) => [lobe, [...numbers.subarray(start + i * 3, start + i * 3 + 3)]]));

/**
 * What a material reflects, by lobe: in double, by the text that the renderer shades with. Needs no GL. Textures are left
 * out, as if white, normal maps flat. Tangent frame: z is the normal, x the tangent; the viewer stands at `viewAngle` from z
 * towards x.
 * @param {object} options
 * @param {object | number} options.material - A material as glTF writes it, or the index of one in `model`.
 * @param {import('./model.mjs').Model} [options.model]
 * @param {string | object} [options.shading='three'] - As the shot has it.
 * @param {number} [options.viewAngle=0] - Radians, 0 up to but not including pi / 2.
 * @param {Array<[number, number, number]>} [options.directions] - Unit vectors to the light, at most 65536.
 * @param {boolean} [options.albedo=false] - Integrate over all directions above the surface too, drawn as the lobes lie, and the same every time.
 * @param {AbortSignal} [options.signal]
 * @returns {Promise<{radiance: object[], albedo: object | null, albedoError: object | null}>} `radiance`: for each direction {diffuse, specular, sheen, coat,
 *   total}, linear [r, g, b] under a light that gives the irradiance 1 on a surface that faces it (the BRDF times the cosine);
 *   `albedo`: the same of the share that is reflected of light from everywhere; `albedoError`: how far each of its numbers may be from
 *   the integral (999 of 1000 are closer): 1e-6 for wide lobes, some 1e-4 for the narrowest. `total` is the sum of the lobes.
 * @throws {TelarError} E_OPTION, E_SHOT, and what loading a model throws
 */
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
