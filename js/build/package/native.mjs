import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readdirSync, realpathSync } from 'node:fs';
import path from 'node:path';
import { SetupError } from '../../machine/step.mjs';
import { targetOf } from './target.mjs';

// The compiled part of telar with the libraries that it links: what a machine needs no compiler and no -dev package for.

/** What the build writes. The others are loaded when first needed; where what they link is missing, that feature is. */
const ADDON = 'telar.node';
const ON_DEMAND = ['libtelar_worker.so', 'libtelar_oiio.so', 'libtelar_reference.so'];

/** Libraries that telar.node loads by name when a model needs them (core/lazy_library). */
const LOADED = ['libzstd.so.1', 'libmeshoptimizer.so.2d'];

/** On each machine that runs Node. */
const OF_THE_SYSTEM = /^(ld-linux-.*|lib(c|m|dl|pthread|rt|gcc_s|stdc\+\+))\.so/;

/** Debian packages whose code is compiled into the addon. */
const COMPILED_IN = ['libdraco-dev', 'libtinygltf-dev', 'nlohmann-json3-dev', 'libglm-dev'];

const run = (command, args) => {
  try {
    return execFileSync(command, args, { encoding: 'utf8', maxBuffer: 1 << 26 });
  } catch (error) {
    throw new SetupError(`${command} ${args[0]} failed: ${(error.stderr || error.message).trim().split('\n')[0]}`, { cure: 'run this on Debian 12' });
  }
};

/** Names of the libraries that a file links. @returns {string[]} */
const linked = (file, { tool }) => [...run(tool('objdump'), ['-p', file]).matchAll(/^ {2}NEEDED +(\S+)$/gm)].map(([, name]) => name);

/**
 * What a folder's addon needs that neither the folder nor each system has.
 * @param {string} folder
 * @param {import('./target.mjs').Target} [target]
 * @returns {string[]} Names of libraries.
 */
export function missingIn(folder, target = targetOf()) {
  const files = readdirSync(folder).filter((name) => name === ADDON || (/\.so/.test(name) && !ON_DEMAND.includes(name)));
  const needed = new Set([...LOADED, ...files.flatMap((name) => linked(path.join(folder, name), target))]);
  return [...needed].filter((name) => !OF_THE_SYSTEM.test(name) && !existsSync(path.join(folder, name))).sort();
}

/** The installed file of a library. */
function installed(name, { tool }) {
  const file = run(tool('g++'), [`-print-file-name=${name}`]).trim();
  if (!path.isAbsolute(file)) throw new SetupError(`${name} is not installed`, { cure: 'npm run setup' });
  return realpathSync(file);
}

/** The newest version of glibc and of libstdc++ that the files ask for. @param {string[]} files */
function oldestSystem(files, { tool }) {
  const symbols = files.map((file) => run(tool('objdump'), ['-T', file])).join('\n');
  const newest = (pattern) =>
    [...new Set([...symbols.matchAll(pattern)].map(([, version]) => version))].sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).at(-1);
  return { glibc: newest(/\bGLIBC_([\d.]+)\b/g), glibcxx: newest(/\bGLIBCXX_([\d.]+)\b/g) };
}

/** @typedef {{name: string, version: string, architecture: string, copyright: string}} DebianPackage copyright: file */

/** @returns {DebianPackage} */
function debianPackage(name, { debian }) {
  const installedOnes = run('dpkg-query', ['-W', '-f=${Architecture} ${Version}\n', name]).split('\n');
  const found = installedOnes.map((line) => line.split(' ')).find(([architecture]) => [debian, 'all'].includes(architecture));
  if (!found) throw new SetupError(`${name} is not installed for ${debian}`, { cure: 'npm run setup' });
  return { name, version: found[1], architecture: found[0], copyright: `/usr/share/doc/${name}/copyright` };
}

/** Packages that files are from, by one search: each reads the lists of all packages. @param {string[]} files @returns {string[]} */
function ownersOf(files, { triple }) {
  const said = run('dpkg-query', ['-S', ...files.map((file) => `*/${triple}/${path.basename(file)}`)]);
  return said
    .trim()
    .split('\n')
    .map((line) => line.split(':')[0]); // name:architecture: file
}

/**
 * Copies the compiled part of a build into a folder, with every library that it links or loads and that is not on each system.
 * @param {string} build - Folder of the build, as out/release.
 * @param {string} folder - Is made.
 * @param {import('./target.mjs').Target} [target]
 * @returns {{packages: DebianPackage[], glibc: string, glibcxx: string}} `packages`: those whose code is inside; the versions: the oldest that do.
 * @throws {SetupError}
 */
export function copyNative(build, folder, target = targetOf()) {
  mkdirSync(folder, { recursive: true });
  for (const name of [ADDON, ...ON_DEMAND]) {
    const file = path.join(build, 'addon', name);
    if (!existsSync(file)) throw new SetupError(`${name} is not built`, { cure: 'npm run setup' });
    copyFileSync(file, path.join(folder, name));
  }
  const libraries = [];
  for (let missing = missingIn(folder, target); missing.length; missing = missingIn(folder, target)) {
    for (const name of missing) {
      const file = installed(name, target);
      libraries.push(file);
      copyFileSync(file, path.join(folder, name));
    }
  }
  const files = readdirSync(folder).map((name) => path.join(folder, name));
  const owners = new Set([...COMPILED_IN, ...ownersOf(libraries, target)]);
  return { packages: [...owners].sort().map((name) => debianPackage(name, target)), ...oldestSystem(files, target) };
}
