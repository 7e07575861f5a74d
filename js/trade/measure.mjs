import { compareImages } from '../compare/index.mjs';
import { TelarError } from '../error/index.mjs';
import { familyOf } from '../predict/settings.mjs';
import { windowCamera, windowOf } from '../predict/window.mjs';

/**
 * What the error is measured against: light that arrives directly and the environment, path traced. Another seed than the settings':
 * equal paths would hide the noise of both.
 */
export const TRUTH = Object.freeze({ preset: 'reference', transport: 'direct', samples: 16384, noise: 0.6, seed: 2 });

/** Side of the window that shows what a picture costs beside its pixels. */
const TINY = 8;

/**
 * Time of a picture from those of two windows of it: linear in the pixels that the model covers.
 * @param {{ms: number, pixels: number}} small
 * @param {{ms: number, pixels: number}} large ms no less than those of the small one
 * @param {number} pixels of the picture
 */
export const scaledTime = (small, large, pixels) => small.ms + ((large.ms - small.ms) * (pixels - small.pixels)) / (large.pixels - small.pixels);

/** CPU time from which on a window is drawn no second time, and up to which it is drawn a third time. */
const LONG_MS = 1500;
const SHORT_MS = 300;

/** A shot with a setting: a quality, or that and what of the shadows of its lamps is other. */
const withSetting = (shot, setting) => {
  if (setting.shadow === undefined) return { ...shot, quality: setting };
  const lights = shot.lights.map((light) => (light.castShadow ? { ...light, shadow: { ...light.shadow, ...setting.shadow } } : light));
  return { ...shot, quality: setting.quality, lights };
};

/** Pictures that are timed, by the milliseconds that one is expected to take: the least of them counts, for whatever else runs only adds. */
const runsFor = (ms) => (ms < 150 ? 5 : ms < 600 ? 3 : 1);

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
 * @property {string} model, light, shading, setting
 * @property {number} size - Pixels of the picture's larger side.
 * @property {number} flip - Mean over the model's pixels of the window, against TRUTH.
 * @property {number} deltaE - CIEDE2000, 95th percentile of the same.
 * @property {number} cpuMs - Of drawing the whole picture, of all threads.
 * @property {'picture' | 'window'} timed - What was drawn for that: the picture itself, or only the window, from whose time its own follows (scaledTime).
 * @property {number} windowMs - CPU time of the window.
 * @property {number} samples - That the pixel that took most has taken.
 * @property {object} features - Of js/predict/features.mjs.
 */

/**
 * Draws one scene with each setting.
 * @param {object} renderer of api.createRenderer
 * @param {object} model loaded
 * @param {Scene} scene
 * @param {object} plan
 * @param {Record<string, object | string>} plan.settings quality by name, or {quality, shadow}: those are left out where no lamp casts a shadow
 * @param {number} plan.window side in pixels
 * @param {object} [plan.truth] quality
 * @param {number} plan.capMs CPU time above which a setting is drawn in the window alone
 * @param {(shot: object) => Promise<import('../predict/features.mjs').Features>} plan.featuresOf of a resolved shot of the scene
 * @param {{row(key: string): Row | undefined, keep(key: string, row: Row): Promise<void>, truth(key: string): Promise<Uint8Array | undefined>, keepTruth(key: string, data: Uint8Array): Promise<void>, keyOf(parts: object): string}} store
 * @param {{signal?: AbortSignal, step?: (name: string) => void}} [options] step: after each setting
 * @returns {Promise<Row[]>}
 */
export async function measureScene(
  renderer,
  model,
  scene,
  { settings, window: side, truth = TRUTH, capMs, featuresOf },
  store,
  { signal, step = () => {} } = {},
) {
  const draw = async (shot) => {
    const before = process.cpuUsage();
    const { data, info } = await renderer.render(model, { ...shot, output: { format: 'raw' } }, { signal, timeoutMs: null });
    const { user, system } = process.cpuUsage(before);
    return { data, info, cpuMs: (user + system) / 1000 };
  };
  const leastOf = async (shot, runs) => {
    let least = Infinity;
    for (let i = 0; i < runs; i++) least = Math.min(least, (await draw(shot)).cpuMs);
    return least;
  };
  // Over nothing: the model's own pixels tell where it is.
  const whole = { ...scene.shot, background: 'transparent' };
  const first = await draw({ ...whole, quality: 'draft' });
  const { shot: resolved, key, picture } = first.info;
  if (picture.coverage === 0) throw new TelarError('E_CAMERA', 'nothing of the model is in the picture');
  const features = await featuresOf(resolved);
  const window = windowOf(first.data, resolved.size, side);
  const size = { width: window.width, height: window.height };
  const shown = { ...resolved, size, camera: windowCamera(resolved.camera, resolved.size, window) };
  const keyOf = (more) => store.keyOf({ key, window, truth, ...more });
  let expected;
  const truthOf = async () => {
    if (expected) return expected;
    const name = keyOf({});
    expected = await store.truth(name);
    if (!expected) {
      expected = (await draw({ ...shown, quality: truth })).data;
      await store.keepTruth(name, expected);
    }
    return expected;
  };
  const covered = ({ coverage, width, height }) => coverage * width * height;
  const wholeTime = async (shot, windowMs) => {
    // Vertices and the start of each pass cost the same in any window: a tiny one shows what that is.
    const tiny = { ...window, x: window.x + window.width / 2 - TINY / 2, y: window.y + window.height / 2 - TINY / 2, width: TINY, height: TINY };
    const tinyShot = { ...shot, size: { width: TINY, height: TINY }, camera: windowCamera(resolved.camera, resolved.size, tiny) };
    const { cpuMs, info } = await draw(tinyShot);
    const again = cpuMs < SHORT_MS ? await leastOf(tinyShot, 1) : cpuMs;
    return scaledTime(
      { ms: Math.min(cpuMs, again, windowMs), pixels: covered({ ...tiny, coverage: info.picture.coverage }) },
      { ms: windowMs, pixels: covered(window) },
      covered({ ...resolved.size, coverage: picture.coverage }),
    );
  };
  const rows = [];
  for (const [setting, quality] of Object.entries(settings)) {
    if (quality.shadow !== undefined && !features.shadows) {
      step(`${scene.model}, ${scene.light}: ${setting}`);
      continue;
    }
    const name = keyOf({ setting, quality, capMs });
    let row = store.row(name);
    if (!row) {
      const reference = await truthOf();
      const shot = withSetting(shown, quality);
      const drawn = await draw(shot);
      // The first picture may compile programs.
      const again = drawn.cpuMs < LONG_MS ? await leastOf(shot, 1) : drawn.cpuMs;
      const windowMs = Math.min(drawn.cpuMs, again < SHORT_MS ? await leastOf(shot, 1) : again, again);
      const { flip, deltaE } = compareImages({ ...size, data: reference }, { ...size, data: drawn.data }).object;
      const expectedMs = await wholeTime(shot, windowMs);
      const fits = expectedMs <= capMs;
      const cpuMs = fits ? await leastOf(withSetting({ ...whole, lights: resolved.lights }, quality), runsFor(expectedMs)) : expectedMs;
      row = {
        model: scene.model,
        light: scene.light,
        shading: features.shading,
        size: Math.max(resolved.size.width, resolved.size.height),
        setting,
        flip: flip.mean,
        deltaE: deltaE.p95,
        cpuMs,
        timed: fits ? 'picture' : 'window',
        windowMs,
        samples: drawn.info.samples ?? 1,
        family: familyOf(setting) ?? 'other',
        features,
      };
      await store.keep(name, row);
    }
    // What a scene is told by may be more than when the row was kept.
    rows.push({ ...row, features });
    step(`${scene.model}, ${scene.light}, ${row.size}: ${setting}`);
  }
  return rows;
}
