import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readdirSync, realpathSync } from 'node:fs';
import path from 'node:path';
import { SetupError } from '../../machine/step.mjs';

// The compiled part of telar with the libraries that it links: what a machine needs no compiler and no -dev package for.

/** What the build writes. The second and third are loaded when first needed; where what they link is missing, that feature is. */
const ADDON = 'telar.node';
const ON_DEMAND = ['libtelar_oiio.so', 'libtelar_reference.so'];

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

/** Names of the libraries that a file links. @param {string} file @returns {string[]} */
const linked = (file) => [...run('objdump', ['-p', file]).matchAll(/^ {2}NEEDED +(\S+)$/gm)].map(([, name]) => name);

/**
 * What a folder's addon needs that neither the folder nor each system has.
 * @param {string} folder
 * @returns {string[]} Names of libraries.
 */
export function missingIn(folder) {
  const files = readdirSync(folder).filter((name) => name === ADDON || (/\.so/.test(name) && !ON_DEMAND.includes(name)));
  const needed = new Set([...LOADED, ...files.flatMap((name) => linked(path.join(folder, name)))]);
  return [...needed].filter((name) => !OF_THE_SYSTEM.test(name) && !existsSync(path.join(folder, name))).sort();
}

/** The installed file of a library. */
function installed(name) {
  const file = run('g++', [`-print-file-name=${name}`]).trim();
  if (!path.isAbsolute(file)) throw new SetupError(`${name} is not installed`, { cure: 'npm run setup' });
  return realpathSync(file);
}

/** The newest version of glibc and of libstdc++ that the files ask for. @param {string[]} files */
function oldestSystem(files) {
  const symbols = files.map((file) => run('objdump', ['-T', file])).join('\n');
  const newest = (pattern) =>
    [...new Set([...symbols.matchAll(pattern)].map(([, version]) => version))].sort((a, b) => a.localeCompare(b, 'en', { numeric: true })).at(-1);
  return { glibc: newest(/\bGLIBC_([\d.]+)\b/g), glibcxx: newest(/\bGLIBCXX_([\d.]+)\b/g) };
}

/** @typedef {{name: string, version: string, copyright: string}} DebianPackage copyright: file */

/** @returns {DebianPackage} */
function debianPackage(name) {
  const version = run('dpkg-query', ['-W', '-f=${Version}', name]);
  return { name, version, copyright: `/usr/share/doc/${name}/copyright` };
}

const ownerOf = (file) => run('dpkg-query', ['-S', `*/${path.basename(file)}`]).split(':')[0];

/**
 * Copies the compiled part of a build into a folder, with every library that it links or loads and that is not on each system.
 * @param {string} build - Folder of the build, as out/release.
 * @param {string} folder - Is made.
 * @returns {{packages: DebianPackage[], glibc: string, glibcxx: string}} `packages`: those whose code is inside; the versions: the oldest that do.
 * @throws {SetupError}
 */
export function copyNative(build, folder) {
  mkdirSync(folder, { recursive: true });
  for (const name of [ADDON, ...ON_DEMAND]) {
    const file = path.join(build, 'addon', name);
    if (!existsSync(file)) throw new SetupError(`${name} is not built`, { cure: 'npm run setup' });
    copyFileSync(file, path.join(folder, name));
  }
  const owners = new Set(COMPILED_IN);
  for (let missing = missingIn(folder); missing.length; missing = missingIn(folder)) {
    for (const name of missing) {
      const file = installed(name);
      owners.add(ownerOf(file));
      copyFileSync(file, path.join(folder, name));
    }
  }
  const files = readdirSync(folder).map((name) => path.join(folder, name));
  return { packages: [...owners].sort().map(debianPackage), ...oldestSystem(files) };
}
