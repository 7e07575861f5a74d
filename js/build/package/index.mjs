import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { ROOT } from '../../machine/step.mjs';
import { copyNative } from './native.mjs';
import { copyLicences } from './licences.mjs';
import { billOf } from './sbom.mjs';
import { targetOf } from './target.mjs';

// Packages that install without a compiler and without a script: telar in JavaScript, and its compiled part for one platform, which npm
// takes by `os`, `cpu` and `libc`.

/** What compiles, and package.json, which is another one: not in a package that brings the compiled part. */
const LEFT_OUT = /^(addon|renderer|shaders|js\/build|js\/setup)\/|^(binding\.gyp|CMake.*|package\.json)$/;
const COMPILER_PACKAGES = ['node-addon-api', 'node-api-headers'];

const json = (value) => `${JSON.stringify(value, null, 2)}\n`;

/** Packs a folder. @returns {string} The file. */
function packed(folder, into) {
  const said = execFileSync('npm', ['pack', '--ignore-scripts', '--json', '--pack-destination', into], {
    cwd: folder,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  return path.join(into, JSON.parse(said)[0].filename);
}

/** package.json of the part in JavaScript. Without `files`: all that stands beside it is packed. @param {string[]} natives - Names of compiled parts */
function scriptless(own, natives) {
  const { scripts, config, allowScripts, devDependencies, private: _, files, dependencies, ...rest } = own;
  return {
    ...rest,
    dependencies: Object.fromEntries(Object.entries(dependencies).filter(([name]) => !COMPILER_PACKAGES.includes(name))),
    optionalDependencies: { ...rest.optionalDependencies, ...Object.fromEntries(natives.map((name) => [name, own.version])) },
  };
}

/** Files that `files` of package.json names, as npm reads them, are copied; then npm packs the copy with another package.json, which names each
 * compiled part that lies there. */
function packScripts(own, work, into) {
  const listed = JSON.parse(
    execFileSync('npm', ['pack', '--ignore-scripts', '--dry-run', '--json'], { cwd: ROOT, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }),
  );
  const folder = path.join(work, 'telar');
  for (const { path: file } of listed[0].files) {
    if (LEFT_OUT.test(file)) continue;
    mkdirSync(path.dirname(path.join(folder, file)), { recursive: true });
    copyFileSync(path.join(ROOT, file), path.join(folder, file));
  }
  const natives = readdirSync(into).flatMap((file) => (file.endsWith(`-${own.version}.tgz`) ? (/^telar-linux-[a-z0-9]+(?=-)/.exec(file) ?? []) : []));
  writeFileSync(path.join(folder, 'package.json'), json(scriptless(own, natives)));
  return packed(folder, into);
}

function packNative(own, target, build, work, into) {
  const { arch, packageName: name } = target;
  const folder = path.join(work, name);
  const { packages, glibc, glibcxx } = copyNative(build, folder, target);
  copyLicences(packages, path.join(folder, 'licences'));
  const facts = { name, version: own.version, description: `The compiled part of telar for Linux on ${arch}`, license: own.license };
  writeFileSync(path.join(folder, 'package.json'), json({ ...facts, main: 'telar.node', os: ['linux'], cpu: [arch], libc: ['glibc'], glibc, glibcxx }));
  writeFileSync(
    path.join(folder, 'README.md'),
    `# ${name}\n\n${facts.description}: npm installs it with telar. It needs glibc ${glibc} and libstdc++ with GLIBCXX_${glibcxx}, or newer ones.\n` +
      'What it holds of others is in licences/.\n',
  );
  return { file: packed(folder, into), packages };
}

/**
 * Writes telar-VERSION.tgz, telar-linux-ARCH-VERSION.tgz and telar.cdx.json. The build and js/dist stand already.
 * @param {{build: string, folder: string, arch?: string}} options - Folder of the build, as out/release; where to; of which machines.
 * @returns {{files: string[], packages: {name: string, version: string}[]}}
 * @throws {SetupError}
 */
export function writePackages({ build, folder, arch }) {
  const target = targetOf(arch);
  const own = JSON.parse(readFileSync(path.join(ROOT, 'package.json'), 'utf8'));
  mkdirSync(folder, { recursive: true });
  const work = mkdtempSync(path.join(tmpdir(), 'telar-package-'));
  try {
    const { file, packages } = packNative(own, target, build, work, folder);
    const scripts = packScripts(own, work, folder);
    return { files: [scripts, file, writeBill(packages, target, folder)], packages };
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}

/** @returns {string} The file. */
function writeBill(packages, { arch, packageName }, folder) {
  const file = path.join(folder, arch === process.arch ? 'telar.cdx.json' : `${packageName}.cdx.json`);
  writeFileSync(file, json(billOf(packages, packageName)));
  return file;
}

/**
 * Writes the bill of materials alone.
 * @param {{build: string, folder: string}} options - As of writePackages.
 * @returns {{files: string[]}}
 * @throws {SetupError}
 */
export function writeSbom({ build, folder, arch }) {
  const target = targetOf(arch);
  mkdirSync(folder, { recursive: true });
  const work = mkdtempSync(path.join(tmpdir(), 'telar-package-'));
  try {
    return { files: [writeBill(copyNative(build, work, target).packages, target, folder)] };
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}
