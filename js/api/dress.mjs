import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { resolveMaterials } from '../shot/materials.mjs';
import { Model, loadModel } from './model.mjs';
import { nativeCall } from './native_call.mjs';

/** Each cloth of the shot's `materials`, a square of it in true size: js/assets/make/cloths writes them. */
const CLOTH_DIRECTORY = fileURLToPath(new URL('../assets/cloths', import.meta.url));

const RADIANS_PER_DEGREE = Math.PI / 180;

/** A bundled cloth, decoded. There are a few dozen small ones, so a renderer keeps those that it was asked for. */
function clothOf(native, cloths, preset) {
  if (!cloths.has(preset)) {
    const loaded = loadModel(native, path.join(CLOTH_DIRECTORY, `${preset}.glb`), {});
    loaded.catch(() => cloths.delete(preset));
    cloths.set(preset, loaded);
  }
  return cloths.get(preset);
}

/**
 * The model in the cloths that a shot puts on it.
 * @internal
 * @param {object} native the addon's exports
 * @param {Model} model in the shot's pose
 * @param {object} shot not resolved
 * @param {object} options
 * @param {import('./work.mjs').Work} [options.work]
 * @param {Map<string, Promise<Model>>} [options.cloths] decoded ones by name, which this adds to
 * @param {boolean} [options.forget] the model is not used afterwards
 * @returns {Promise<Model>}
 * @throws {TelarError} E_SHOT, E_CLOTH
 */
export async function dressModel(native, model, shot, { work, cloths = new Map(), forget = false }) {
  const scene = Model.sceneOf(model);
  const asked = resolveMaterials(shot, JSON.parse(await nativeCall(native, work, (token) => native.namesOf(scene, token))));
  const dressings = await Promise.all(
    asked.map(async ({ preset, rotation, metresPerUv, ...rest }) => ({
      ...rest,
      rotation: rotation * RADIANS_PER_DEGREE,
      metresPerUv: metresPerUv ?? undefined,
      cloth: preset === null ? undefined : Model.sceneOf(await clothOf(native, cloths, preset)),
    })),
  );
  const made = await nativeCall(native, work, (token) => native.dress(scene, dressings, forget, token));
  // What is drawn where stays: the outline for one need not be found again.
  return new Model(made.scene, { ...model.facts, ...JSON.parse(made.facts) });
}
