import { readFileSync } from 'node:fs';
import { TelarError, toTelarError } from '../error/index.mjs';
import { Console } from './console.mjs';
import { buildProgram } from './program.mjs';

const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));

/**
 * Runs one command line. Never throws; never ends the process.
 * @param {string[]} argv without node and the script
 * @param {import('./console.mjs').Io & {loadApi: () => Promise<object>, loadPool: () => Promise<object>}} io
 * @param {Record<string, import('./program.mjs').Row>} commands
 * @returns {Promise<number>} exit code
 */
export async function run(argv, io, commands) {
  const flags = { json: argv.includes('--json'), quiet: argv.includes('--quiet') };
  const console = new Console(io, flags);
  let exit = 0;
  const actionOf =
    (load) =>
    async (...args) => {
      const call = await load();
      const values = args.slice(0, -1); // the last one is commander's own command object
      exit = await call(...values, { ...io, console, version, api: await io.loadApi() });
    };
  // The options of the command that is asked for alone are made: those of all take longer than a small picture's shading.
  const [asked] = argv;
  const grammar = Object.hasOwn(commands, asked) ? { [asked]: commands[asked] } : commands;
  // Complaints come as exceptions as well: they are told once, in our own form.
  const output = { writeOut: (text) => io.stdout.write(text), writeErr: (text) => (/^error:/.test(text) ? undefined : io.stderr.write(text)) };
  try {
    await buildProgram(version, grammar, actionOf, output).parseAsync(argv, { from: 'user' });
    return exit;
  } catch (thrown) {
    const error = ofCommander(thrown, () => expected(asked, commands));
    if (!error) return 0;
    console.error(error);
    if (flags.json) await console.result({ ok: false, exit: error.exit, error }).catch(() => {});
    return error.exit;
  }
}

/** What is missing: a command, or one of those that the command which was given has. */
function expected(asked, commands) {
  const inner = Object.hasOwn(commands, asked) ? commands[asked].of : undefined;
  const names = Object.keys(inner ?? commands);
  const listed = names.length > 1 ? `${names.slice(0, -1).join(', ')} or ${names.at(-1)}` : names[0];
  return `expected a command${inner ? ` of ${asked}` : ''}: ${listed}`;
}

/**
 * A commander exception as one of ours; undefined for help and version, which are no errors.
 * @param {unknown} thrown
 * @param {() => string} missing what to say where a command is
 */
function ofCommander(thrown, missing) {
  if (!thrown?.code?.startsWith?.('commander.')) return toTelarError(thrown);
  if (thrown.exitCode === 0) return undefined;
  if (thrown.code === 'commander.help') return new TelarError('E_USAGE', missing());
  return new TelarError('E_USAGE', thrown.message.replace(/^error: /, '').replaceAll('\n', ' '));
}
