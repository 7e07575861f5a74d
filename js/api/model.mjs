import { refuseWarnings } from './fail_on.mjs';
import { nativeCall } from './native_call.mjs';
import { withParts } from './parts.mjs';

/** The schema of the shot costs load time, so it comes with the first job. */
export const shotModule = () => import('../shot/index.mjs');

/** Comes with it. @internal */
export const qualityModule = () => import('../shot/quality.mjs');

/** A decoded model, made by `renderer.load`: draw many views of it, with any renderer of the same thread. */
export class Model {
  #scene;

  /** @internal */
  constructor(scene, facts) {
    this.#scene = scene;
    /** What is in the file: bounds, size in metres, counts, materials, variants, cameras, warnings; as `inspect` gives it. */
    this.facts = facts;
  }

  /** Documented in js/index.d.ts. Few callers measure, so what it needs comes with the first call. */
  async measure(options) {
    const { measureModel } = await import('./measure.mjs');
    return measureModel(this, options);
  }

  /** Documented in js/index.d.ts. */
  async flat(shot = {}, options = {}) {
    const { flatOf } = await import('./flat.mjs');
    return flatOf(this, shot, options);
  }

  /** Documented in js/index.d.ts. */
  async swatch(options) {
    const { swatchOf } = await import('./swatch.mjs');
    return swatchOf(this, options);
  }

  /** Documented in js/index.d.ts. */
  async explode(distance, options = {}) {
    const { explodeModel } = await import('./explode.mjs');
    return explodeModel(this, distance, options);
  }

  /** @internal */
  static sceneOf(model) {
    return model.#scene;
  }

  /** @internal */
  static isModel(value) {
    return typeof value === 'object' && value !== null && #scene in value;
  }
}

/**
 * Decodes a source.
 * @internal
 * @param {object} native the addon's exports
 * @param {string | object} input of readSource
 * @param {object} limits
 * @param {import('./options.mjs').Loading & {work?: import('./work.mjs').Work}} [options]
 * @returns {Promise<Model>}
 */
export async function loadModel(native, input, limits, { work, failOn = 'error', resolve } = {}) {
  const { scene, facts } = await withParts(native, { resolve, signal: work?.signal }, (parts) =>
    nativeCall(native, work, (token) => native.load(input, limits, { tolerant: failOn === 'none', parts }, token)),
  );
  const model = new Model(scene, JSON.parse(facts));
  refuseWarnings(failOn, model.facts.warnings);
  return model;
}

/**
 * The model as the shot's pose shows it, with the facts of that pose: the model itself where the shot has none.
 * @internal
 * @param {object} native the addon's exports
 * @param {Model} model
 * @param {object} shot not resolved
 * @param {{work?: import('./work.mjs').Work, forget?: boolean}} [options] forget: the model is not used afterwards, so free it with the pose
 * @returns {Promise<Model>}
 * @throws {TelarError} E_SHOT, E_POSE
 */
export async function poseModel(native, model, shot, { work, forget = false } = {}) {
  const { resolvePose } = await shotModule();
  const pose = resolvePose(shot, model.facts);
  if (!pose) return model;
  const { scene, facts } = await nativeCall(native, work, (token) => native.pose(Model.sceneOf(model), pose.animation, pose.time, forget, token));
  return new Model(scene, JSON.parse(facts));
}

/**
 * What resolveShot needs to know of a posed model: its facts, and what the part measures that the shot frames.
 * @internal
 * @param {object} native the addon's exports
 * @param {Model} model in the shot's pose
 * @param {object} shot not resolved
 * @param {import('./work.mjs').Work} [work]
 * @returns {Promise<object>}
 */
export async function measuredFor(native, model, shot, work) {
  const { resolvePart } = await shotModule();
  const part = resolvePart(shot);
  if (!part) return model.facts;
  const variant = typeof shot.variant === 'string' ? shot.variant : '';
  const measured = await nativeCall(native, work, (token) => native.measurePart(Model.sceneOf(model), part.kind, part.which, variant, token));
  return { ...model.facts, part: { frame: part.frame, ...JSON.parse(measured) } };
}

/** Poses of one model that many shots share: each is made when first needed, and let go with the last shot that shows it. */
export class SharedPoses {
  #native;
  #model;
  #begin;
  #poses = new Map();

  /**
   * @param {object} native
   * @param {Model} model
   * @param {object[]} shots all that will be asked for
   * @param {() => import('./work.mjs').Work} begin of each pose
   */
  constructor(native, model, shots, begin) {
    this.#native = native;
    this.#model = model;
    this.#begin = begin;
    for (const shot of shots) {
      const key = keyOf(shot);
      const pose = this.#poses.get(key) ?? { shots: 0 };
      this.#poses.set(key, pose);
      pose.shots += 1;
    }
  }

  /** @returns {Promise<Model>} */
  of(shot) {
    const pose = this.#poses.get(keyOf(shot));
    pose.model ??= poseModel(this.#native, this.#model, shot, { work: this.#begin() });
    return pose.model;
  }

  /** Counts a shot off. @returns {boolean} whether it was the last of its pose */
  isLast(shot) {
    const pose = this.#poses.get(keyOf(shot));
    pose.shots -= 1;
    return pose.shots === 0 && (shot.pose ?? null) !== null;
  }
}

const keyOf = ({ pose }) => JSON.stringify(pose ?? null);
