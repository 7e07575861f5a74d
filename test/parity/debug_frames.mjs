// Debug outputs of telar: float pictures of one quantity of the shading each (quantities.mjs).
import { runTool, withMap } from './tool.mjs';

/** @typedef {Record<string, Float32Array>} DebugFrames - By quantity: RGBA fp32, top row first; alpha 1 where the material
 * has the quantity, else all 0. */

/** A shot whose frame holds values as the shader wrote them. */
const debugShot = (shot) => ({
  ...shot,
  // The presets have other samples.
  quality: { ...shot.quality, preset: undefined, samples: 1 },
  output: { ...shot.output, format: 'raw', bitDepth: 32 },
});

/**
 * Debug outputs by the command-line tool.
 * @param {string} executable
 * @param {object} input - As of inputs.mjs, with `shot`.
 * @param {string[]} names
 * @param {string[]} [options] - More options of the tool.
 * @returns {Promise<DebugFrames>}
 */
export async function debugByTool(executable, input, names, options = []) {
  const bytes = await runTool(executable, { ...input, shot: debugShot(input.shot) }, ['--debug', names.join(','), ...options]);
  const values = floatsOf(bytes);
  const size = values.length / names.length;
  return Object.fromEntries(names.map((name, i) => [name, values.subarray(i * size, (i + 1) * size)]));
}

/**
 * Debug outputs by the API: the model in the pose and in the cloths of the shot.
 * @param {object} renderer - Of createRenderer().
 * @param {object} input - As of inputs.mjs, with `shot`.
 * @param {string[]} names
 * @returns {Promise<DebugFrames>}
 */
export async function debugByApi(renderer, { shot, model, environment, bundled, failOn }, names) {
  const loaded = await renderer.load(model, { failOn });
  try {
    const plain = withMap(debugShot(shot), bundled ? 'studio' : environment);
    const frames = {};
    for (const name of names) frames[name] = (await renderer.renderQuantity(loaded, plain, name)).data;
    return frames;
  } finally {
    await renderer.release(loaded);
  }
}

/** A view where the bytes lie as floats do, else a copy. */
function floatsOf({ buffer, byteOffset, length }) {
  const isAligned = byteOffset % Float32Array.BYTES_PER_ELEMENT === 0;
  return isAligned ? new Float32Array(buffer, byteOffset, length / 4) : new Float32Array(buffer.slice(byteOffset, byteOffset + length));
}
