import { refuseWarnings } from './fail_on.mjs';
import { nativeCall } from './native_call.mjs';
import { withParts } from './parts.mjs';
import { versions } from './versions.mjs';
import { digestWithVisibility } from './visibility.mjs';

const NO_CACHE = { directory: '', bytes: 0 };

/** The schema of the shot costs load time, so it comes with the first job. */
export const shotModule = () => import('../shot/index.mjs');

/** For shots that are exposed by their picture. @internal */
export const meteringModule = () => import('../shot/metering.mjs');

/** For shots whose quality is a goal. @internal */
export const goalModule = () => import('./goal.mjs');

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

  /** Documented in js/api/model.d.ts. Few callers measure, so what it needs comes with the first call. */
  async measure(options) {
    const { measureModel } = await import('./measure.mjs');
    return measureModel(this, options);
  }

  /** Documented in js/api/model.d.ts. */
  async flat(shot = {}, options = {}) {
    const { flatOf } = await import('./flat.mjs');
    return flatOf(this, shot, options);
  }

  /** Documented in js/api/model.d.ts. */
  async swatch(options) {
    const { swatchOf } = await import('./swatch.mjs');
    return swatchOf(this, options);
  }

  /** Documented in js/api/model.d.ts. */
  async explode(distance, options = {}) {
    const { explodeModel } = await import('./explode.mjs');
    return explodeModel(this, distance, options);
  }

  /** Documented in js/api/ranges.mjs. @internal */
  async rangesAlong(axes, options) {
    const { rangesOf } = await import('./ranges.mjs');
    return rangesOf(this, axes, options);
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
 * @param {string | object} input of readSource, for this one use
 * @param {object} limits
 * @param {import('./options.mjs').Loading & {work?: import('./work.mjs').Work, cache?: {directory: string, bytes: number}, decodesLater?: boolean}} [options]
 *   cache: of ambient visibility; an empty directory = none; decodesLater: images are decoded while the frame that is drawn next looks for
 *   what is seen of it, and it tells what is wrong with them
 * @returns {Promise<Model>}
 */
export async function loadModel(
  native,
  input,
  limits,
  { work, failOn = 'error', resolve, ambientVisibility: rays, cache = NO_CACHE, decodesLater = false } = {},
) {
  const loaded = await withParts(native, { resolve, signal: work?.signal }, (parts) =>
    nativeCall(native, work, (token) => native.load(input, limits, { tolerant: failOn === 'none', decodesLater: decodesLater && !rays, parts }, token)),
  );
  const kept = { ...cache, version: versions.telar };
  const { scene, facts } = rays ? await nativeCall(native, work, (token) => native.withVisibility(loaded.scene, rays, kept, limits, token)) : loaded;
  const read = JSON.parse(facts);
  const model = new Model(scene, { ...read, sha256: digestWithVisibility(read.sha256, rays) });
  refuseWarnings(failOn, model.facts.warnings);
  return model;
}

/**
 * The model as a shot shows it, in its pose and in its cloths, with the facts of that: the model itself where the shot has neither.
 * @internal
 * @param {object} native the addon's exports
 * @param {Model} model
 * @param {object} shot not resolved
 * @param {object} [options]
 * @param {import('./work.mjs').Work} [options.work]
 * @param {boolean} [options.forget] the model is not used afterwards, so free it with what is made of it
 * @param {Map<string, Promise<Model>>} [options.cloths] of the renderer, decoded
 * @returns {Promise<Model>}
 * @throws {TelarError} E_SHOT, E_POSE, E_CLOTH
 */
export async function shownModel(native, model, shot, { work, forget = false, cloths } = {}) {
  const posed = await poseModel(native, model, shot, { work, forget });
  if (Object.keys(shot.materials ?? {}).length === 0) return posed;
  const { dressModel } = await import('./dress.mjs');
  return dressModel(native, posed, shot, { work, cloths, forget: forget || posed !== model });
}

async function poseModel(native, model, shot, { work, forget }) {
  const { resolvePose } = await shotModule();
  const pose = resolvePose(shot, model.facts);
  if (!pose) return model;
  const { scene, facts } = await nativeCall(native, work, (token) => native.pose(Model.sceneOf(model), pose.animation, pose.time, forget, token));
  return new Model(scene, JSON.parse(facts));
}

/**
 * What resolveShot needs to know of a model: its facts without what the shot leaves out, and what the part measures that the shot frames.
 * @internal
 * @param {object} native the addon's exports
 * @param {Model} model as the shot shows it
 * @param {object} shot not resolved
 * @param {import('./work.mjs').Work} [work]
 * @returns {Promise<object>}
 */
export async function measuredFor(native, model, shot, work) {
  const { resolveLeftOut, resolvePart } = await shotModule();
  const [part, ghost] = [resolvePart(shot), resolveLeftOut(shot)];
  if (!part && !ghost) return model.facts;
  const shown = { variant: typeof shot.variant === 'string' ? shot.variant : '', ghost: JSON.stringify(ghost ?? []) };
  const scene = Model.sceneOf(model);
  const rest = ghost && JSON.parse(await nativeCall(native, work, (token) => native.measureShown(scene, shown, token)));
  const measured = part && JSON.parse(await nativeCall(native, work, (token) => native.measurePart(scene, part.kind, part.which, shown, token)));
  return { ...model.facts, ...rest, ...(part && { part: { frame: part.frame, ...measured } }) };
}

/** What many shots show of one model, in a pose or in cloths: each is made when first needed, and let go with the last shot that shows it. */
export class SharedModels {
  #native;
  #model;
  #make;
  #shown = new Map();

  /**
   * @param {object} native
   * @param {Model} model
   * @param {object[]} shots all that will be asked for
   * @param {() => object} make the options of shownModel, for each
   */
  constructor(native, model, shots, make) {
    this.#native = native;
    this.#model = model;
    this.#make = make;
    for (const shot of shots) {
      const key = keyOf(shot);
      const shown = this.#shown.get(key) ?? { shots: 0 };
      this.#shown.set(key, shown);
      shown.shots += 1;
    }
  }

  /** @returns {Promise<Model>} */
  of(shot) {
    const shown = this.#shown.get(keyOf(shot));
    shown.model ??= shownModel(this.#native, this.#model, shot, this.#make());
    return shown.model;
  }

  /** Counts a shot off. @returns {boolean} whether it was the last that shows it, and it is another than the model */
  isLast(shot) {
    const key = keyOf(shot);
    const shown = this.#shown.get(key);
    shown.shots -= 1;
    return shown.shots === 0 && key !== keyOf({});
  }
}

const keyOf = ({ pose, materials }) => JSON.stringify([pose ?? null, materials ?? {}]);
