import { compareImages } from '../compare/index.mjs';
import { TelarError } from '../error/index.mjs';
import { familyOf } from '../predict/settings.mjs';
import { windowCamera, windowOf } from '../predict/window.mjs';
import { shadingName, termsBeside } from '../shot/shading_terms.mjs';
import { SAMPLES_OF_A_PASS } from '../shot/table/quality.mjs';

/**
 * What the error is measured against: light that arrives directly and the environment, path traced. Another seed than the settings':
 * equal paths would hide the noise of both.
 */
export const TRUTH = Object.freeze({ preset: 'reference', transport: 'direct', samples: 16384, noise: 0.6, seed: 2 });

/** Side of the window that shows what a picture costs beside its pixels. */
const TINY = 8;

/**
 * Time of a picture from those of two windows of it, as if all of it were like the larger one: linear in the pixels that the model covers.
 * @param {{ms: number, pixels: number}} small
 * @param {{ms: number, pixels: number}} large ms no less than those of the small one
 * @param {number} pixels of the picture
 */
export const scaledTime = (small, large, pixels) => small.ms + ((large.ms - small.ms) * (pixels - small.pixels)) / (large.pixels - small.pixels);

/**
 * What the time that a window tells is to be multiplied by: how far a window was off in the dearest picture of the same family that was drawn whole. 1 = there is none.
 * @param {Row[]} rows of a scene, from the cheapest setting on
 * @param {string | undefined} family
 */
export function toldFactor(rows, family) {
  const last = rows.findLast((row) => row.family === family && row.timed === 'picture');
  return last ? last.cpuMs / last.toldMs : 1;
}

/** CPU time from which on a window is drawn no second time, and up to which it is drawn a third time. */
const LONG_MS = 4000; // of which a program compiled takes one or two
const SHORT_MS = 300;

/** A shot with a setting: a quality, or that and what of the shadows of its lamps is other. */
const withSetting = (shot, setting) => {
  const { quality = setting, shadow } = setting;
  if (shadow === undefined) return { ...shot, quality };
  const lights = shot.lights.map((light) => (light.castShadow ? { ...light, shadow: { ...light.shadow, ...shadow } } : light));
  return { ...shot, quality, lights };
};

/** A shading as a table names it: its base, and what of it the shot changes. */
const tableName = (shading) =>
  `${shadingName(shading)}${termsBeside(shading)
    .map(([slot, term]) => ` ${slot} ${term}`)
    .join(',')}`;

/** Whether a setting changes what the scene does not have. */
const isIdle = ({ shadow, quality, transmissionScale = quality?.transmissionScale ?? 1, samples, shadowScale }, { shadows }, passes) =>
  // Qualities of several passes have finer maps beside all else.
  (!shadows && (shadow !== undefined || (shadowScale > 1 && samples <= SAMPLES_OF_A_PASS))) || (transmissionScale < 1 && !passes.includes('transmission'));

/** Pictures that are timed, by the milliseconds that one is expected to take: the least of them counts, for whatever else runs only adds, and the first one may compile programs. */
const runsFor = (ms) => (ms < 150 ? 5 : ms < 600 ? 3 : ms < 4000 ? 2 : 1);

/**
 * One scene at one size.
 * @typedef {object} Scene
 * @property {string} model - Its name.
 * @property {string} light - Name of what lights it.
 * @property {string | Uint8Array} source - Of the model.
 * @property {object} shot - Without quality and output.
 *
 * One setting on one scene, as a line of the CSV.
 * @typedef {object} Row
 * @property {string} model, light, shading, setting - shading: with the release of three.js that the scene names, `three@180`.
 * @property {number} size - Pixels of the picture's larger side.
 * @property {number} flip - Mean over the model's pixels of the window, against TRUTH.
 * @property {number} deltaE - CIEDE2000, 95th percentile of the same.
 * @property {number} cpuMs - Of drawing the whole picture, of all threads.
 * @property {'picture' | 'window'} timed - What was drawn for that: the picture itself, or only the window, from whose time its own follows.
 * @property {number} windowMs - CPU time of the window.
 * @property {number} toldMs - What it tells of that of the picture (scaledTime). No window is like the whole: nine of ten pictures took 0.27 to 1.4 times of it.
 * @property {number} samples - That the pixel that took most has taken.
 * @property {object} features - Of js/predict/features.mjs.
 */

/** Draws a model, and counts the CPU time of all threads. */
class TimedDrawing {
  constructor(renderer, model, signal) {
    Object.assign(this, { renderer, model, signal });
  }

  async draw(shot) {
    const before = process.cpuUsage();
    const { data, info } = await this.renderer.render(this.model, { ...shot, output: { format: 'raw' } }, { signal: this.signal, timeoutMs: null });
    const { user, system } = process.cpuUsage(before);
    return { data, info, cpuMs: (user + system) / 1000 };
  }

  async leastMs(shot, runs) {
    let least = Infinity;
    for (let i = 0; i < runs; i++) least = Math.min(least, (await this.draw(shot)).cpuMs);
    return least;
  }
}

const coveredOf = ({ coverage, width, height }) => coverage * width * height;

/** One scene, and the window of its picture in which settings are compared. */
class SceneWindow {
  /** Pictures by name. */
  #truths = new Map();

  /** @param {TimedDrawing} timed */
  constructor(timed, store, truth) {
    Object.assign(this, { timed, store, truth });
  }

  async open({ shot }, side, featuresOf) {
    // Over nothing: the model's own pixels tell where it is.
    this.whole = { ...shot, background: 'transparent' };
    const first = await this.timed.draw({ ...this.whole, quality: 'draft' });
    const { shot: resolved, key, picture, passes } = first.info;
    if (picture.coverage === 0) throw new TelarError('E_CAMERA', 'nothing of the model is in the picture');
    const window = windowOf(first.data, resolved.size, side);
    const features = await featuresOf(resolved);
    Object.assign(this, { resolved, key, passes, features, window, covered: coveredOf({ ...resolved.size, coverage: picture.coverage }) });
    this.size = { width: window.width, height: window.height };
    this.shown = this.#seen(resolved, window);
    return this;
  }

  #seen(shot, window) {
    return { ...shot, size: { width: window.width, height: window.height }, camera: windowCamera(this.resolved.camera, this.resolved.size, window) };
  }

  /** The truth of a setting: of its transport, where it names one. */
  #truthFor({ transport = this.truth.transport }) {
    return { ...this.truth, transport };
  }

  keyOf(setting, more) {
    return this.store.keyOf({ key: this.key, window: this.window, truth: this.#truthFor(setting), ...more });
  }

  /** Drawn for the first setting that is not kept. */
  async expected(setting) {
    const name = this.keyOf(setting, {});
    if (!this.#truths.has(name)) {
      const kept = await this.store.truth(name);
      this.#truths.set(name, kept ?? (await this.timed.draw({ ...this.shown, quality: this.#truthFor(setting) })).data);
      if (!kept) await this.store.keepTruth(name, this.#truths.get(name));
    }
    return this.#truths.get(name);
  }

  /** Milliseconds of the whole picture that those of the window tell. */
  async toldMs(shot, windowMs) {
    // Vertices and the start of each pass cost the same in any window: a tiny one shows what that is.
    const { x, y, width, height } = this.window;
    const tiny = { ...this.window, x: x + width / 2 - TINY / 2, y: y + height / 2 - TINY / 2, width: TINY, height: TINY };
    const tinyShot = this.#seen(shot, tiny);
    const { cpuMs, info } = await this.timed.draw(tinyShot);
    const again = cpuMs < SHORT_MS ? await this.timed.leastMs(tinyShot, 1) : cpuMs;
    return scaledTime(
      { ms: Math.min(cpuMs, again, windowMs), pixels: coveredOf({ ...tiny, coverage: info.picture.coverage }) },
      { ms: windowMs, pixels: coveredOf(this.window) },
      this.covered,
    );
  }

  /**
   * Time and error of a setting.
   * @param {number} factor of toldFactor
   * @param {() => Promise<object>} visibleModel the model with ambient visibility
   */
  async measure(quality, capMs, factor, visibleModel) {
    const { model } = this.timed;
    const reference = await this.expected(quality);
    try {
      if (quality.ambientVisibility) this.timed.model = await visibleModel();
      return await this.#against(reference, quality, capMs, factor);
    } finally {
      this.timed.model = model;
    }
  }

  async #against(reference, quality, capMs, factor) {
    const shot = withSetting(this.shown, quality);
    const drawn = await this.timed.draw(shot);
    // The first picture may compile programs and prefilter the environment, which no later one does.
    const { environment: once = 0, compile = 0 } = drawn.info.milliseconds;
    const again = drawn.cpuMs - once - compile < LONG_MS ? await this.timed.leastMs(shot, 1) : drawn.cpuMs;
    const windowMs = Math.min(drawn.cpuMs, again < SHORT_MS ? await this.timed.leastMs(shot, 1) : again, again);
    const { flip, deltaE } = compareImages({ ...this.size, data: reference }, { ...this.size, data: drawn.data }).object;
    const toldMs = await this.toldMs(shot, windowMs);
    const expectedMs = toldMs * factor;
    const fits = expectedMs <= capMs;
    const all = withSetting({ ...this.whole, lights: this.resolved.lights }, quality);
    return {
      flip: flip.mean,
      deltaE: deltaE.p95,
      cpuMs: fits ? await this.timed.leastMs(all, runsFor(expectedMs)) : expectedMs,
      timed: fits ? 'picture' : 'window',
      windowMs,
      toldMs,
      samples: drawn.info.samples ?? 1,
    };
  }
}

/**
 * Draws one scene with each setting.
 * @param {object} renderer of api.createRenderer
 * @param {object} model loaded
 * @param {Scene} scene
 * @param {object} plan
 * @param {Record<string, object | string>} plan.settings quality by name, or {quality, shadow, transport, ambientVisibility}. Left out where no lamp casts a
 *   shadow, or nothing transmits, that they change. transport: of the truth. ambientVisibility: of the model
 * @param {() => Promise<object>} [plan.visibleModel] the model with ambient visibility
 * @param {number} plan.window side in pixels
 * @param {object} [plan.truth] quality
 * @param {number} plan.capMs CPU time above which a setting is drawn in the window alone
 * @param {string} [plan.machine] what times depend on: those of another machine are not taken for its own
 * @param {(shot: object) => Promise<import('../predict/features.mjs').Features>} plan.featuresOf of a resolved shot of the scene
 * @param {{row(key: string): Row | undefined, keep(key: string, row: Row): Promise<void>, truth(key: string): Promise<Uint8Array | undefined>, keepTruth(key: string, data: Uint8Array): Promise<void>, keyOf(parts: object): string}} store
 * @param {{signal?: AbortSignal, step?: (name: string) => void}} [options] step: after each setting
 * @returns {Promise<Row[]>}
 */
export async function measureScene(
  renderer,
  model,
  scene,
  { settings, window: side, truth = TRUTH, capMs, machine, featuresOf, visibleModel },
  store,
  { signal, step = () => {} } = {},
) {
  const window = await new SceneWindow(new TimedDrawing(renderer, model, signal), store, truth).open(scene, side, featuresOf);
  const { features, resolved } = window;
  const named = { model: scene.model, light: scene.light, shading: tableName(scene.shot.shading ?? features.shading) };
  const rows = [];
  for (const [setting, quality] of Object.entries(settings)) {
    if (isIdle(quality, features, window.passes)) {
      step(`${scene.model}, ${scene.light}: ${setting}`);
      continue;
    }
    const name = window.keyOf(quality, { setting, quality, capMs, machine });
    let row = store.row(name);
    if (!row) {
      const size = Math.max(resolved.size.width, resolved.size.height);
      const family = familyOf(setting);
      const measured = await window.measure(quality, capMs, toldFactor(rows, family), visibleModel);
      row = { ...named, size, setting, ...measured, family: family ?? 'other', features };
      await store.keep(name, row);
    }
    // What a scene is called and told by may be other than when the row was kept.
    rows.push({ ...row, ...named, features });
    step(`${scene.model}, ${scene.light}, ${row.size}: ${setting}`);
  }
  return rows;
}
