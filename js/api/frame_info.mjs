import { worldToPixel } from './world_to_pixel.mjs';

/**
 * `info` of one frame.
 * @param {object} parts
 * @param {{width: number, height: number, info: string, queueMs: number, drawMs: number, encodeMs: number}} parts.frame native
 * @param {object} parts.resolved the shot that was drawn
 * @param {{load: number, resolve: number, total: number}} parts.milliseconds
 * @param {{backend: string, gl: object}} parts.renderer
 * @param {object[]} [parts.warnings] of the model
 */
export function frameInfo({ frame, resolved, milliseconds, renderer, warnings = [] }) {
  const drawn = JSON.parse(frame.info);
  return {
    ...drawn,
    width: frame.width,
    height: frame.height,
    format: resolved.output.format,
    backend: renderer.backend,
    gl: renderer.gl,
    quality: resolved.quality,
    milliseconds: {
      ...drawn.milliseconds,
      load: milliseconds.load,
      resolve: milliseconds.resolve,
      queue: frame.queueMs,
      draw: frame.drawMs,
      encode: frame.encodeMs,
      total: milliseconds.total,
    },
    warnings: [...warnings, ...(drawn.warnings ?? [])],
    // Largest resident memory of this process so far, the GL driver's included where it draws in software.
    peakBytes: process.resourceUsage().maxRSS * 1024,
    worldToPixel: worldToPixel(resolved),
    shot: resolved,
  };
}
