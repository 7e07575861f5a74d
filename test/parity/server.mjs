import path from 'node:path';
import { debugByApi, debugByTool } from './debug_frames.mjs';
import { premultiply } from './metrics.mjs';
import { serial } from './serial.mjs';
import { runTool, withMap } from './tool.mjs';

/**
 * telar.
 * @typedef {object} Server
 * @property {(input: object) => Promise<Uint8Array>} draw - Of {shot, model, environment, bundled} as of inputs.mjs: RGBA8,
 *   premultiplied, top row first.
 * @property {(input: object, names: string[]) => Promise<import('./debug_frames.mjs').DebugFrames>} debug - Quantities of
 *   the shading (quantities.mjs).
 * @property {object} [renderer] - telar's own, where it is the JavaScript API that draws.
 * @property {() => Promise<void>} close
 */

/**
 * Opens telar: through its JavaScript API, or through the command-line tool of a C++ build where TELAR_DRAW names one.
 * @returns {Promise<Server>}
 * @throws {import('../../js/error/index.mjs').TelarError} With the cure, when there is no build.
 */
export async function openServer() {
  return process.env.TELAR_DRAW ? openTool(path.resolve(process.env.TELAR_DRAW)) : openApi();
}

async function openApi() {
  const { createRenderer } = await import('../../js/index.mjs');
  // Environments prefiltered by this build, not by one that left its cubes on the disk.
  const renderer = await createRenderer({ cacheDirectory: null });
  return {
    renderer,
    async draw({ shot, model, environment, bundled, failOn }) {
      const { data } = await renderer.render(model, withMap(shot, bundled ? 'studio' : environment), { failOn });
      return premultiply(data);
    },
    debug: (input, names) => debugByApi(renderer, input, names),
    close: () => renderer.close(),
  };
}

/**
 * telar_draw.
 * @param {string} executable
 * @param {string[]} [options] - More options of the tool.
 * @returns {Server}
 */
export function openTool(executable, options = []) {
  return {
    draw: serial(async (input) => premultiply(await runTool(executable, input, options))),
    debug: (input, names) => debugByTool(executable, input, names, options),
    close: async () => {},
  };
}
