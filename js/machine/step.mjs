import { spawn } from 'node:child_process';
import { createWriteStream, mkdirSync } from 'node:fs';
import { once } from 'node:events';
import { constants } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

// The set-up and the build run before `npm ci`: Node built-ins only in this folder.

/** The checkout (or the installed package), absolute. */
export const ROOT = fileURLToPath(new URL('../..', import.meta.url));

/** Exit code 6 of the command line: this machine, not the input. */
const EXIT_MACHINE = 6;
const LOG_ERROR_LINES = 10;
const LOG_TAIL_LINES = 15;
const CLEAR_LINE = '\r\u001b[K';

/** Set-up cannot go on; the message ends with the cure. */
export class SetupError extends Error {
  /**
   * @param {string} message - What went wrong.
   * @param {{cure?: string, exitCode?: number, notFound?: boolean}} [facts]
   */
  constructor(message, { cure = '', exitCode = EXIT_MACHINE, notFound = false } = {}) {
    super(cure ? `${message}\n  Cure: ${cure}` : message);
    this.name = 'SetupError';
    this.exitCode = exitCode;
    this.notFound = notFound;
  }
}

/**
 * Runs one step and reports it as one line on stderr: `name: result`, or `name: what ... result (12.3 s)` when the
 * job announces work by calling its argument. Called again, the argument tells how far the work is, which only a
 * terminal shows, in the same line.
 * @param {string} name
 * @param {(begin: (what: string) => void) => Promise<string>} job - Resolves to the result's few words.
 */
export async function step(name, job) {
  const started = performance.now();
  const terminal = process.stderr.isTTY;
  let begun = '';
  const begin = (what) => {
    if (begun && !terminal) return;
    process.stderr.write(`${begun && CLEAR_LINE}${name}: ${what} ... `);
    begun ||= what;
  };
  const end = (result, time = '') => {
    const line = begun && !terminal ? `${result}${time}` : `${name}: ${begun && `${begun} ... `}${result}${begun && time}`;
    process.stderr.write(`${begun && terminal ? CLEAR_LINE : ''}${line}\n`);
  };
  try {
    const result = await job(begin);
    end(result, ` (${((performance.now() - started) / 1000).toFixed(1)} s)`);
  } catch (error) {
    end('failed');
    throw error;
  }
}

/**
 * Runs a command with its output in a log file under out/setup.
 * @param {string} command
 * @param {string[]} args
 * @param {{log: string, env?: object, cure?: string, printed?: (text: string) => void}} options - `log`: file name without
 *   folder; `cure`: told on failure; `printed`: called with each piece of output.
 * @returns {Promise<string>} What it printed (stdout and stderr together).
 * @throws {SetupError} With the last lines printed.
 */
export async function runLogged(command, args, { log, cure, ...options }) {
  const { status, text } = await runKept(command, args, { log, cure, ...options });
  if (status !== 0) {
    throw new SetupError(`${path.basename(command)} ${args[0]} ended with ${status}; all it said is in out/setup/${log}:\n${excerpt(text)}`, { cure });
  }
  return text;
}

/**
 * The same, whatever its exit status.
 * @returns {Promise<{status: number, text: string}>}
 */
export async function runKept(command, args, { log, env = {}, cure, printed: tell = () => {} }) {
  const folder = path.join(ROOT, 'out', 'setup');
  mkdirSync(folder, { recursive: true });
  const file = createWriteStream(path.join(folder, log));
  const child = spawn(command, args, { cwd: ROOT, env: { ...process.env, ...env }, stdio: ['ignore', 'pipe', 'pipe'] });
  const printed = [];
  for (const stream of [child.stdout, child.stderr]) {
    stream.setEncoding('utf8').on('data', (text) => {
      printed.push(text);
      file.write(text);
      tell(text);
    });
  }
  const status = await exitCode(child, command, cure);
  file.end();
  await once(file, 'close');
  return { status, text: printed.join('') };
}

/** The first lines that speak of an error, wherever they stand, and the last lines. */
function excerpt(text) {
  const lines = text.trimEnd().split('\n');
  const tail = lines.slice(-LOG_TAIL_LINES);
  const errors = lines
    .slice(0, -LOG_TAIL_LINES)
    .filter((line) => /\berror\b/i.test(line))
    .slice(0, LOG_ERROR_LINES);
  return [...errors, ...(errors.length ? ['...'] : []), ...tail].map((line) => `  | ${line}`).join('\n');
}

/**
 * Runs a command on this terminal.
 * @returns {Promise<number>} Its exit status; 128 + signal number stands for a signal's death.
 */
export async function runShown(command, args, { env = {} } = {}) {
  const child = spawn(command, args, { cwd: ROOT, env: { ...process.env, ...env }, stdio: 'inherit' });
  return exitCode(child, command);
}

async function exitCode(child, command, cure) {
  try {
    const [code, signal] = await once(child, 'close');
    return code ?? 128 + constants.signals[signal];
  } catch (error) {
    if (error.code !== 'ENOENT') throw error;
    throw new SetupError(`${command}: no such program`, { cure, notFound: true });
  }
}

/** Runs a script's main function; a SetupError is printed without a stack. */
export async function main(job) {
  try {
    process.exitCode = await job();
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    process.stderr.write(`telar: ${error.message}\n`);
    process.exitCode = error.exitCode;
  }
}
