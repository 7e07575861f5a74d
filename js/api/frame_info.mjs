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
  if (!drawsThinCloth(shading) && extensionsUsed.includes(NOT_IN_THREE)) {
    warnings.push({
      code: 'W_EXT_IGNORED', pointer: `/extensionsUsed/${extensionsUsed.indexOf(NOT_IN_THREE)}`,
      message: `shading "${shading.base ?? shading}" does not draw the optional extension "${NOT_IN_THREE}"; use shading "fabric"`,
    });
  }
  return warnings;
}

/**
 * `info` of one frame.
 * @param {object} parts
 * @param {{width: number, height: number, info: string, queueMs: number, drawMs: number, encodeMs: number}} parts.frame native
 * @param {object} parts.resolved the shot that was drawn
 * @param {{load: number, pose: number, resolve: number, total: number}} parts.milliseconds
 * @param {{backend: string, gl: object}} parts.renderer
 * @param {string} [parts.key] of picture_key.mjs
 * @param {object[]} [parts.warnings] of the model
 */
export function frameInfo({ frame, resolved, milliseconds, renderer, key, warnings = [] }) {
  // The stages of drawing come from the renderer itself; `draw` alone where it tells none.
  const { ms = { draw: frame.drawMs }, ...drawn } = JSON.parse(frame.info);
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
    milliseconds: { load, pose, resolve, queue: frame.queueMs, ...ms, encode: frame.encodeMs, total },
    warnings: [...warnings, ...(drawn.warnings ?? [])],
    // Largest resident memory of this process so far, the GL driver's included where it draws in software.
    peakBytes: process.resourceUsage().maxRSS * 1024,
    shot: resolved,
  };
}
