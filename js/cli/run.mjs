import { readFileSync } from 'node:fs';
import { TelarError, toTelarError } from '../error/index.mjs';
import { Console } from './console.mjs';
import { buildProgram } from './program.mjs';

const { version } = JSON.parse(readFileSync(new URL('../../package.json', import.meta.url), 'utf8'));

/** Commands load when they run: --help and --version need none of them, doctor not the shot's schema. */
const COMMANDS = {
  thumbnail: async () => (await import('./thumbnail.mjs')).thumbnail,
  inspect: async () => (await import('./inspect.mjs')).inspect,
  compare: async () => (await import('./compare.mjs')).compare,
  sheet: async () => (await import('./sheet.mjs')).sheet,
  analyse: async () => (await import('./analyse.mjs')).analyse,
  view: async () => (await import('./view.mjs')).view,
  serve: async () => (await import('./serve.mjs')).serve,
  sign: async () => (await import('./sign.mjs')).sign,
  worker: async () => (await import('./worker.mjs')).worker,
  bake: async () => (await import('./bake.mjs')).bake,
  benchTrade: async () => (await import('./bench.mjs')).benchTrade,
  looks: async () => (await import('./looks.mjs')).looks,
  doctor: async () => (await import('./doctor.mjs')).doctor,
};

/**
 * Runs one command line. Never throws; never ends the process.
 * @param {string[]} argv without node and the script
 * @param {import('./console.mjs').Io & {loadApi: () => Promise<object>, loadPool: () => Promise<object>}} io
 * @returns {Promise<number>} exit code
 */
export async function run(argv, io) {
  const flags = { json: argv.includes('--json'), quiet: argv.includes('--quiet') };
  const console = new Console(io, flags);
  let exit = 0;
  const action =
    (name) =>
    async (...args) => {
      const call = await COMMANDS[name]();
      const values = args.slice(0, -1); // the last one is commander's own command object
      exit = await call(...values, { ...io, console, version, api: await io.loadApi() });
    };
  const actions = Object.fromEntries(Object.keys(COMMANDS).map((name) => [name, action(name)]));
  // Complaints come as exceptions as well: they are told once, in our own form.
  const output = { writeOut: (text) => io.stdout.write(text), writeErr: (text) => (/^error:/.test(text) ? undefined : io.stderr.write(text)) };
  try {
    await buildProgram(version, actions, output).parseAsync(argv, { from: 'user' });
    return exit;
  } catch (thrown) {
    const error = ofCommander(thrown);
    if (!error) return 0;
    console.error(error);
    if (flags.json) await console.result({ ok: false, exit: error.exit, error }).catch(() => {});
    return error.exit;
  }
}

/** A commander exception as one of ours; undefined for help and version, which are no errors. */
function ofCommander(thrown) {
  if (!thrown?.code?.startsWith?.('commander.')) return toTelarError(thrown);
  if (thrown.exitCode === 0) return undefined;
  if (thrown.code === 'commander.help')
    return new TelarError(
      'E_USAGE',
      'expected a command: thumbnail, inspect, compare, sheet, analyse, view, serve, sign, worker, bake, bench, looks or doctor',
    );
  return new TelarError('E_USAGE', thrown.message.replace(/^error: /, '').replaceAll('\n', ' '));
}
