import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { isMainThread } from 'node:worker_threads';
import { TelarError } from '../error/index.mjs';

// The only file that loads the native part: telar.node, which the addon/ folder builds.

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const require = createRequire(import.meta.url);
const PLATFORM = `telar-${process.platform}-${process.arch}`;

/** What to do where there is no addon. The package of the sources has no set-up, but the build and its list of Debian packages. @param {string} root */
export function cureIn(root) {
  const has = (name) => existsSync(path.join(root, name));
  if (has('js/setup')) return 'run `npm run build` in the folder of telar (it needs the Debian packages that `npm run setup` installs)';
  if (has('CMakeLists.txt'))
    return 'run `npm run build` in the folder of telar (it names the Debian packages that are missing; js/machine/debian_packages.txt lists them all)';
  return `install telar with its optional dependencies, of which ${PLATFORM} is one (Linux with glibc), or compile it from its sources`;
}

const CURE = cureIn(ROOT);

/** Where a build puts the addon, or npm the package of this platform: the first that exists wins. TELAR_BUILD_DIR names one build folder and no other. */
function candidates() {
  const { TELAR_BUILD_DIR } = process.env;
  if (TELAR_BUILD_DIR) return [path.join(path.resolve(TELAR_BUILD_DIR), 'addon/telar.node')];
  return [...['out/release/addon/telar.node', 'build/Release/telar.node'].map((file) => path.join(ROOT, file)), ...packaged()];
}

/** The addon of the package that npm chose for this platform (js/build/package). */
function packaged() {
  try {
    return [require.resolve(PLATFORM)];
  } catch {
    return [];
  }
}

/** Folder of the data that the renderer reads: the bundled environment. */
export const ASSET_DIRECTORY = path.join(ROOT, 'js/assets');

/** What a worker says of the library below, and what `telar doctor` says of it. */
export const NOTICES_ALLOCATIONS = 'failed allocations noticed';

/**
 * The library of workers, as LD_PRELOAD takes it: it lies beside the addon. It counts allocations which fail, and gives up what a process can
 * give up at its start alone.
 * @returns {{file: string, failure: null} | {failure: string}}
 * @throws {TelarError} X_NATIVE_MISSING
 */
export function workerLibrary() {
  loaded ??= load();
  return libraryBeside(loaded.file);
}

/** @param {string} addon its file */
export function libraryBeside(addon) {
  const file = path.join(path.dirname(addon), 'libtelar_worker.so');
  if (!existsSync(file)) return { failure: 'libtelar_worker.so is not beside telar.node' };
  // What the loader takes for a border between two names, or for a variable.
  if (/[\s:$]/.test(file)) return { failure: 'LD_PRELOAD takes no path with a space, a colon or a dollar sign, and the folder of telar.node has one' };
  return { file, failure: null };
}

/**
 * What the addon reports of isolation, with the steps of that library.
 * @param {string} report JSON; a step that nobody took has no failure
 * @param {string | null} absent why the library is not there
 * @returns {{step: string, failure: string | null}[]}
 */
export function isolationSteps(report, absent) {
  const steps = JSON.parse(report).map(({ step, failure = absent ?? 'not taken' }) => ({ step, failure }));
  return [...steps, { step: NOTICES_ALLOCATIONS, failure: absent }];
}

let loaded;

/**
 * The addon's exports; loaded once for each Node environment.
 * @returns {object}
 * @throws {TelarError} X_NATIVE_MISSING
 */
export function loadNative() {
  loaded ??= load();
  return loaded.exports;
}

/** The file that loadNative() took, relative to telar's folder where it lies inside. */
export function nativePath() {
  loaded ??= load();
  return shortened(loaded.file);
}

function load() {
  const tried = candidates();
  const file = tried.find((candidate) => existsSync(candidate));
  if (!file) {
    throw new TelarError('X_NATIVE_MISSING', `the native part of telar is not built (tried ${tried.map(shortened).join(', ')}): ${CURE}`);
  }
  try {
    return { file, exports: endWithProcess(require(file)) };
  } catch (cause) {
    const why = cause.message.split('\n')[0].replaceAll(ROOT, '');
    throw new TelarError('X_NATIVE_MISSING', `${shortened(file)} does not load (${why}): ${CURE}`, { cause });
  }
}

/**
 * Ends the addon's threads before process.exit() runs the exit handlers of the GL driver. A worker has no such handlers,
 * and its environment ends its threads by itself.
 * @internal
 */
export function endWithProcess(native) {
  if (isMainThread) process.once('exit', (code) => native.shutDown(code));
  return native;
}

const shortened = (file) => (file.startsWith(ROOT) ? path.relative(ROOT, file) : path.basename(file));
