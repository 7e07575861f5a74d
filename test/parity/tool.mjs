import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

/** The shot with `map` in place of the file name that stands for the case's environment. */
export const withMap = (shot, map) => (map ? { ...shot, environment: { ...shot.environment, map } } : shot);

/**
 * Runs telar_draw MODEL SHOT.json OUT.raw [--env FILE] [OPTION...], the command-line tool of a C++ build.
 * @param {string} executable
 * @param {{shot: object, model: Uint8Array | string, environment?: Uint8Array, bundled?: boolean}} input - As of inputs.mjs.
 * @param {string[]} [options]
 * @returns {Promise<Buffer>} The frame's bytes.
 */
export async function runTool(executable, { shot, model, environment, bundled }, options = []) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-parity-'));
  const file = (name, bytes) => {
    if (bytes) writeFileSync(path.join(folder, name), bytes);
    return path.join(folder, name);
  };
  try {
    const own = environment && !bundled;
    const map = bundled ? 'studio' : own && { bytes: environment.length };
    const args = [
      typeof model === 'string' ? model : file('model.glb', model),
      file('shot.json', JSON.stringify(withMap(shot, map))),
      file('out.raw'),
      ...(own ? ['--env', file('environment', environment)] : []),
      ...options,
    ];
    await execute(executable, args);
    return readFileSync(file('out.raw'));
  } finally {
    rmSync(folder, { recursive: true });
  }
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
