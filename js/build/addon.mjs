import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildCure } from '../machine/debian.mjs';
import { main, ROOT, runLogged, runShown, SetupError } from '../machine/step.mjs';

// Compiles the addon with CMake and bundles js/dist: node js/build/addon.mjs [preset]. binding.gyp and npm's install hook end
// here too, so that sources and flags stand in CMakeLists.txt alone. Node's own headers are not needed: the addon is plain
// Node-API.

/** Where the header packages lie: beside us in a checkout, higher up where telar is a dependency. */
function headerFolders() {
  const require = createRequire(import.meta.url);
  try {
    return {
      TELAR_NODE_API_HEADERS_DIR: path.join(path.dirname(require.resolve('node-api-headers/package.json')), 'include'),
      TELAR_NODE_ADDON_API_DIR: path.dirname(require.resolve('node-addon-api/package.json')),
    };
  } catch {
    throw new SetupError('the npm packages node-api-headers and node-addon-api are missing', { cure: 'npm ci --ignore-scripts' });
  }
}

/** Every CMakeLists.txt, the presets, and the folder they lie in: what a configured build folder stands for. */
function configureStamp(headers) {
  const hash = createHash('sha256').update(JSON.stringify([ROOT, headers]));
  const visit = (folder) => {
    for (const entry of readdirSync(path.join(ROOT, folder), { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1))) {
      const file = path.join(folder, entry.name);
      if (entry.isDirectory()) visit(file);
      else if (entry.name === 'CMakeLists.txt' || entry.name.endsWith('.cmake')) hash.update(file).update(readFileSync(path.join(ROOT, file)));
    }
  };
  for (const file of ['CMakeLists.txt', 'CMakePresets.json']) hash.update(readFileSync(path.join(ROOT, file)));
  for (const folder of ['addon', 'renderer', 'shaders', 'test/cpp', 'test/numerics']) if (existsSync(path.join(ROOT, folder))) visit(folder);
  return hash.digest('hex');
}

/** What ninja puts before a command: how many of how many. */
const NINJA_PROGRESS = /(?<=^\[)\d+\/\d+(?=\])/gm;

/** One a core: two more, as Ninja has it, take an eighth more of CPU time, as each pushes the others out of the caches. */
const COMPILERS = os.availableParallelism();

/**
 * The two CMake command lines; `configure` is null when the build folder stands already.
 * @param {string} preset
 * @param {{targets?: string[], compilers?: number}} [options] - What is built, all where it is left out; how many compilers at once.
 */
function plan(preset, { targets = [], compilers = COMPILERS } = {}) {
  const headers = headerFolders();
  const folder = path.join('out', preset);
  const stampFile = path.join(ROOT, folder, '.configured');
  const stamp = configureStamp(headers);
  const configured = existsSync(stampFile) && readFileSync(stampFile, 'utf8') === stamp;
  const definitions = Object.entries(headers).map(([name, value]) => `-D${name}=${value}`);
  return {
    // --fresh: a cache from other inputs (a moved checkout, a removed library) must not leak into this one.
    configure: configured ? null : ['--fresh', '--preset', preset, ...definitions],
    compile: ['--build', folder, '--parallel', String(compilers), ...(targets.length ? ['--target', ...targets] : [])],
    markConfigured: () => {
      mkdirSync(path.dirname(stampFile), { recursive: true });
      writeFileSync(stampFile, stamp);
    },
  };
}

/**
 * Configures where needed and builds; ninja decides what is stale.
 * @param {string} preset - Of CMakePresets.json.
 * @param {(what: string) => void} begin - Told when work begins, and how far it is.
 * @param {{targets?: string[], compilers?: number}} [options] - As of `plan`.
 * @returns {Promise<string>} What was done, in a few words.
 * @throws {SetupError} With the compiler's last lines.
 */
export async function ensureBuild(preset, begin, options) {
  const { configure, compile, markConfigured } = plan(preset, options);
  const cure = buildCure();
  if (configure) {
    begin('compiling');
    await runLogged('cmake', configure, { log: `configure-${preset}.log`, cure });
    markConfigured();
  }
  const printed = (output) => {
    const [progress] = output.match(NINJA_PROGRESS)?.slice(-1) ?? [];
    if (!progress) return;
    begin('compiling');
    begin(`compiling ${progress}`);
  };
  const text = await runLogged('cmake', compile, { log: `build-${preset}.log`, cure, printed });
  return text.includes('no work to do') ? 'up to date' : 'done';
}

/** The same with CMake's own output on this terminal, and the CommonJS bundles. */
async function buildShown(preset) {
  const { configure, compile, markConfigured } = plan(preset);
  for (const [args, done] of [
    [configure, markConfigured],
    [compile, () => {}],
  ]) {
    const status = args ? await cmakeShown(args) : 0;
    if (status !== 0) {
      const cure = buildCure();
      throw new SetupError(`cmake ${args[0]} ended with ${status}`, { cure });
    }
    done();
  }
  // A packed telar brings js/dist along; a checkout makes it, with its development packages.
  return existsSync(path.join(ROOT, 'node_modules/esbuild')) ? runShown(process.execPath, [path.join(ROOT, 'js/build/dist.mjs')]) : 0;
}

async function cmakeShown(args) {
  try {
    return await runShown('cmake', args);
  } catch (error) {
    throw error.notFound ? new SetupError('cmake: no such program', { cure: buildCure() }) : error;
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main(() => buildShown(process.argv[2] ?? 'release'));
