import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

const BIN = fileURLToPath(new URL('../../js/cli/telar.mjs', import.meta.url));
/** Milliseconds before it begins again. */
const AGAIN_MS = 200;

/**
 * Runs a command, and again whenever it ends, as a supervisor does.
 * @param {string} name
 * @param {string[]} argv of telar
 * @param {{env: object, planted?: string}} how planted: a module that is loaded first
 */
export function supervise(name, argv, { env, planted }) {
  let isEnding = false;
  let starts = 0;
  let child;
  const start = () => {
    if (isEnding) return;
    starts += 1;
    const before = planted ? ['--import', planted] : [];
    child = spawn(process.execPath, [...before, BIN, ...argv], { stdio: 'ignore', env: { ...process.env, ...env } });
    child.once('exit', () => setTimeout(start, AGAIN_MS));
  };
  start();
  return {
    name,
    /** How often it was started. */
    get starts() {
      return starts;
    },
    get pid() {
      return child.pid;
    },
    async end() {
      isEnding = true;
      if (child.exitCode !== null || child.signalCode !== null) return;
      child.kill('SIGKILL');
      await once(child, 'exit');
    },
  };
}
