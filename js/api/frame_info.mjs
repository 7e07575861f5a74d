/**
 * `info` of one frame.
 * @param {object} parts
 * @param {{width: number, height: number, info: string, queueMs: number, drawMs: number, encodeMs: number}} parts.frame native
 * @param {object} parts.resolved the shot that was drawn
 * @param {{load: number, pose: number, resolve: number, total: number}} parts.milliseconds
 * @param {{backend: string, gl: object}} parts.renderer
 * @param {object[]} [parts.warnings] of the model
 */
export function frameInfo({ frame, resolved, milliseconds, renderer, warnings = [] }) {
  // The stages of drawing come from the renderer itself; `draw` alone where it tells none.
  const { ms = { draw: frame.drawMs }, ...drawn } = JSON.parse(frame.info);
  const { load, pose, resolve, total } = milliseconds;
  return {
    ...drawn,
    width: frame.width,
    height: frame.height,
    format: resolved.output.format,
    backend: renderer.backend,
    gl: renderer.gl,
    quality: resolved.quality,
    milliseconds: { load, pose, resolve, queue: frame.queueMs, ...ms, encode: frame.encodeMs, total },
    warnings: [...warnings, ...(drawn.warnings ?? [])],
    // Largest resident memory of this process so far, the GL driver's included where it draws in software.
    peakBytes: process.resourceUsage().maxRSS * 1024,
    shot: resolved,
  };
}
