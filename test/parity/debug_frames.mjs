// Debug outputs of telar: float pictures of one quantity of the shading each (quantities.mjs).
import { ASSET_DIRECTORY, loadNative } from '../../js/api/native.mjs';
import { runTool, withMap } from './tool.mjs';

/** @typedef {Record<string, Float32Array>} DebugFrames - By quantity: RGBA fp32, top row first; alpha 1 where the material
 * has the quantity, else all 0. */

/** A shot whose frame holds values as the shader wrote them. */
const debugShot = (shot) => ({
  ...shot,
  quality: { ...shot.quality, samples: 1 },
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
 * Debug outputs by the addon on a native renderer of its own: the shot is drawn as it was resolved, where `renderQuantity` of the
 * API resolves one, in front of nothing.
 * @returns {Promise<{draw: (input: object, names: string[]) => Promise<DebugFrames>, close: () => Promise<void>}>}
 */
export async function openDebugAddon() {
  const native = loadNative();
  const token = () => new native.CancelToken();
  const options = { backend: 'auto', assetDirectory: ASSET_DIRECTORY, cacheDirectory: '', limits: {}, allFeatures: false, maxQueued: 1 };
  const { renderer } = await native.createRenderer(options, token());
  return {
    async draw({ shot, model, environment, bundled, failOn }, names) {
      const input = typeof model === 'string' ? model : new native.Bytes(model, model.length);
      const { scene } = await native.load(input, {}, { tolerant: failOn === 'none' }, token());
      const own = environment && !bundled ? new native.Bytes(environment, environment.length) : undefined;
      const plain = withMap(debugShot(shot), bundled ? 'studio' : own && { bytes: environment.length });
      const frames = {};
      for (const name of names) {
        const request = { scene, shot: JSON.stringify({ ...plain, debugOutput: name }), environment: own, releaseScene: false };
        frames[name] = floatsOf((await renderer.render(request, token())).data);
      }
      await renderer.release(scene, true);
      return frames;
    },
    close: () => renderer.close(),
  };
}

/** A view where the bytes lie as floats do, else a copy. */
function floatsOf({ buffer, byteOffset, length }) {
  const isAligned = byteOffset % Float32Array.BYTES_PER_ELEMENT === 0;
  return isAligned ? new Float32Array(buffer, byteOffset, length / 4) : new Float32Array(buffer.slice(byteOffset, byteOffset + length));
}
