import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { premultiply } from './metrics.mjs';
import { serial } from './serial.mjs';

/**
 * Opens telar: through its JavaScript API, or through the command-line tool of a C++ build where TELAR_DRAW names one.
 * draw({shot, model, environment, bundled}) gives RGBA8, premultiplied, top row first; inputs as of inputs.mjs.
 *
 * @returns {Promise<{draw: Function, close: Function, renderer?: object}>} `renderer`: telar's own, but with TELAR_DRAW.
 * @throws {import('../../js/error/index.mjs').TelarError} With the cure, when there is no build.
 */
export async function openServer() {
  if (process.env.TELAR_DRAW) return openTool(path.resolve(process.env.TELAR_DRAW));
  const { createRenderer } = await import('../../js/index.mjs');
  // Environments prefiltered by this build, not by one that left its cubes on the disk.
  const renderer = await createRenderer({ cacheDirectory: null });
  return {
    renderer,
    async draw({ shot, model, environment, bundled }) {
      const { data } = await renderer.render(model, withEnvironment(shot, bundled ? 'studio' : environment));
      return premultiply(data);
    },
    close: () => renderer.close(),
  };
}

/** The shot with `map` in place of the file name that stands for the case's environment. */
const withEnvironment = (shot, map) => (map ? { ...shot, environment: { ...shot.environment, map } } : shot);

/** telar_draw MODEL SHOT.json OUT.raw [--env FILE] */
function openTool(executable) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-parity-'));
  const file = (name) => path.join(folder, name);
  return {
    draw: serial(async ({ shot, model, environment, bundled }) => {
      const modelFile = typeof model === 'string' ? model : file('model.glb');
      if (modelFile !== model) writeFileSync(modelFile, model);
      const own = environment && !bundled;
      const map = bundled ? 'studio' : own && { bytes: environment.length };
      writeFileSync(file('shot.json'), JSON.stringify(withEnvironment(shot, map)));
      if (own) writeFileSync(file('environment.hdr'), environment);
      const options = own ? ['--env', file('environment.hdr')] : [];
      await execute(executable, [modelFile, file('shot.json'), file('out.raw'), ...options]);
      return premultiply(readFileSync(file('out.raw')));
    }),
    close: async () => rmSync(folder, { recursive: true }),
  };
}

function execute(command, args) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { stdio: ['ignore', 'ignore', 'pipe'] });
    let text = '';
    child.stderr.on('data', (chunk) => (text += chunk));
    child.on('error', reject);
    child.on('close', (code, signal) => (code === 0 ? resolve() : reject(new Error(`${path.basename(command)}: ${signal ?? `exit ${code}`}\n${text}`))));
  });
}
