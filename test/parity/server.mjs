import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { Browser } from './browser/chromium.mjs';
import { premultiply } from './metrics.mjs';

/**
 * Opens telar: through its JavaScript API, or through the command-line tool of a C++ build where TELAR_DRAW names one.
 * draw({shot, model, environment, bundled}) gives RGBA8, premultiplied, top row first; inputs as of inputs.mjs.
 *
 * @returns {Promise<{draw: Function, close: Function}>}
 * @throws {import('../../js/error/index.mjs').TelarError} With the cure, when there is no build.
 */
export async function openServer() {
  if (process.env.TELAR_DRAW) return openTool(path.resolve(process.env.TELAR_DRAW));
  const { createRenderer } = await import('../../js/index.mjs');
  const renderer = await createRenderer();
  return {
    async draw({ shot, model, environment, bundled }) {
      const { data } = await renderer.render(model, withEnvironment(shot, bundled ? 'studio' : environment));
      return premultiply(data);
    },
    close: () => renderer.close(),
  };
}

/**
 * Chromium with its own software rasteriser in telar's place: how far the client is from itself.
 * @returns {Promise<{draw: Function, close: Function}>}
 */
export async function openSecondBrowser() {
  const browser = await Browser.start({ rasterizer: 'swiftshader' });
  return { draw: async (input) => (await browser.draw(input)).image, close: () => browser.close() };
}

/** The shot with `map` in place of the file name that stands for the case's environment. */
const withEnvironment = (shot, map) => (map ? { ...shot, environment: { ...shot.environment, map } } : shot);

/** telar_draw MODEL SHOT.json OUT.raw [--env FILE] */
function openTool(executable) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-parity-'));
  const file = (name) => path.join(folder, name);
  return {
    async draw({ shot, model, environment, bundled }) {
      const modelFile = typeof model === 'string' ? model : file('model.glb');
      if (modelFile !== model) writeFileSync(modelFile, model);
      const own = environment && !bundled;
      const map = bundled ? 'studio' : own && { bytes: environment.length };
      writeFileSync(file('shot.json'), JSON.stringify(withEnvironment(shot, map)));
      if (own) writeFileSync(file('environment.hdr'), environment);
      const options = own ? ['--env', file('environment.hdr')] : [];
      await execute(executable, [modelFile, file('shot.json'), file('out.raw'), ...options]);
      return premultiply(readFileSync(file('out.raw')));
    },
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
