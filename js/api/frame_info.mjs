import { familyOf, isRelease, releaseOf, revisionRemark } from '../shot/three_terms.mjs';

/** Extension that stock three.js does not have: only "fabric" and one diffuse term of the principled shadings draw it. */
const NOT_IN_THREE = 'KHR_materials_diffuse_transmission';
const THIN = 'disney-2015-thin';
const drawsThinCloth = (shading) => shading === 'fabric' || shading.diffuse === THIN;

/**
 * What the shot asks for, or the model holds, and this frame does not show.
 * @param {object} resolved
 * @param {string[]} [extensionsUsed] - Of the model.
 * @returns {{code: string, message: string, pointer?: string}[]}
 */
export function shotWarnings({ lens, quality, shading }, extensionsUsed = []) {
  const warnings = [];
  if (lens?.focusDistance != null && quality.preset !== 'reference') {
    warnings.push({ code: 'W_LENS', message: 'shot.lens.focusDistance: the raster shows everything sharp; quality "reference" blurs what is out of focus' });
  }
  const remark = isRelease(shading) && revisionRemark(releaseOf(shading));
  if (remark) warnings.push({ code: 'W_THREE_REVISION', pointer: '/shading/revision', message: `shot.shading.revision: ${remark}` });
  if (!drawsThinCloth(shading) && extensionsUsed.includes(NOT_IN_THREE)) {
    warnings.push({
      code: 'W_EXT_IGNORED',
      pointer: `/extensionsUsed/${extensionsUsed.indexOf(NOT_IN_THREE)}`,
      message: `shading "${shading.base ?? shading}" does not draw the optional extension "${NOT_IN_THREE}"; use shading "fabric"`,
    });
  }
  return warnings;
}

/** Part of a picture below which its model is not to be seen, and of a model above which its exposure is wrong. */
const EMPTY = 0.001;
const MOST = 0.5;

const percent = (part) => `${Number((100 * part).toPrecision(2))} %`;

/**
 * What nobody wants of a picture: one without the model, one that is all black or white.
 * @param {{coverage: number, dark: number, bright: number, saturated: number} | undefined} picture - As the renderer counted its pixels.
 */
export function pictureWarnings(picture) {
  if (!picture) return [];
  const { coverage, dark, bright, saturated } = picture;
  if (coverage < EMPTY) {
    const message = `the model covers ${percent(coverage)} of the picture: the camera looks past it, or it is too small, or see-through`;
    return [{ code: 'W_EMPTY', message }];
  }
  if (dark + bright + saturated <= MOST) return [];
  const message =
    `${percent(dark + bright + saturated)} of the model shows no shading: ${percent(dark)} is black, ${percent(bright)} white, ` +
    `${percent(saturated)} saturated; change shot.exposure, the lights or the environment`;
  return [{ code: 'W_EXPOSURE', message }];
}

/** The release of three.js that a shading is of, and those that draw as it does; undefined where it is of none. */
function familyOfShading(shading) {
  if (!isRelease(shading)) return undefined;
  const revision = releaseOf(shading);
  return { revision, family: familyOf(revision) };
}

/** Millimetres of the model on a pixel, exact; null in perspective, where it differs from place to place. */
const scaleOf = ({ camera, size }) => (camera.projection === 'orthographic' ? (1000 * camera.height) / size.height : null);

/**
 * `info` of one frame.
 * @param {object} parts
 * @param {{width: number, height: number, info: string, queueMs: number, drawMs: number, encodeMs: number}} parts.frame native
 * @param {object} parts.resolved the shot that was drawn
 * @param {{load: number, pose: number, resolve: number, total: number}} parts.milliseconds
 * @param {{backend: string, gl: object}} parts.renderer
 * @param {string} [parts.key] of picture_key.mjs
 * @param {object[]} [parts.warnings] of the model
 * @param {number} [parts.metered] factor of the shot's `metering`
 * @param {object} [parts.goal] of goal.mjs
 */
export function frameInfo({ frame, resolved, milliseconds, renderer, key, warnings = [], metered, goal }) {
  // The stages of drawing come from the renderer itself; `draw` alone where it tells none.
  const { ms = { draw: frame.drawMs }, spentMs, ...drawn } = JSON.parse(frame.info);
  const { load, pose, resolve, total } = milliseconds;
  return {
    ...drawn,
    width: frame.width,
    height: frame.height,
    format: resolved.output.format,
    key,
    // A path traced frame says so itself: no GL drew it.
    backend: drawn.backend ?? renderer.backend,
    gl: drawn.backend === 'reference' ? {} : renderer.gl,
    quality: resolved.quality,
    three: familyOfShading(resolved.shading),
    milliseconds: { load, pose, resolve, queue: frame.queueMs, ...ms, encode: frame.encodeMs, total },
    warnings: [...warnings, ...(drawn.warnings ?? []), ...pictureWarnings(drawn.picture)],
    // Largest resident memory of this process so far, the GL driver's included where it draws in software.
    peakBytes: process.resourceUsage().maxRSS * 1024,
    millimetresPerPixel: scaleOf(resolved),
    ...(metered !== undefined && { meteredExposure: metered }),
    ...(goal && { goal: { ...goal, ...(spentMs !== undefined && { reached: { cpuMs: spentMs } }) } }),
    shot: resolved,
  };
}
