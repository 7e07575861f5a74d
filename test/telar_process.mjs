import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { until } from './until.mjs';

const BIN = fileURLToPath(new URL('../js/cli/telar.mjs', import.meta.url));

const left = new Set();
after(() => left.forEach((child) => child.kill('SIGKILL')));

/**
 * The program in a process of its own, which does not outlive the test.
 * @param {string[]} argv
 * @param {{says?: RegExp, env?: Record<string, string>}} [how] says: what its output is waited for; without it, it is not waited for
 * @returns {Promise<{child: import('node:child_process').ChildProcess, said: {out: string, err: string}, found?: string,
 *   ended: Promise<{code: number | null, signal: string | null}>}>} found: what says found, nothing where the program ended before
 */
export async function startTelar(argv, { says, env } = {}) {
  const child = spawn(BIN, argv, { stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, ...env } });
  left.add(child);
  const said = { out: '', err: '' };
  child.stdout.on('data', (text) => {
    said.out += text;
  });
  child.stderr.on('data', (text) => {
    said.err += text;
  });
  let isOver = false;
  const ended = once(child, 'exit').then(([code, signal]) => {
    isOver = true;
    left.delete(child);
    return { code, signal };
  });
  const [found] = says ? await until(() => says.exec(said.out) ?? (isOver && [])) : [];
  return { child, said, found, ended };
}
