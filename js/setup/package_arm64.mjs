import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { listedPackages } from '../machine/debian.mjs';
import { main, ROOT, runLogged, SetupError, step } from '../machine/step.mjs';
import { addNode, CROSS_SYSTEM, system } from './bare_system.mjs';
import { setUp } from './index.mjs';

// npm run package:arm64: what `npm run package` writes, for arm64, compiled on x64. The cross compiler and the libraries of arm64 are installed into
// a chroot, so that this machine's packages stay as they are. As root, with debootstrap. test/install/arm64.mjs draws with it under emulation.

const RELEASE = 'bookworm';
const NODE = '24';

/** Compilers and what they are driven by, of this machine. */
const TOOLS = ['g++-aarch64-linux-gnu', 'cmake', 'ninja-build', 'file'];

/** A system with the cross compiler and the libraries of arm64, made once. */
function crossSystem() {
  const folder = system(RELEASE, TOOLS, CROSS_SYSTEM);
  if (existsSync(path.join(folder, '.arm64'))) return folder;
  const libraries = listedPackages(['build', 'run']).filter((name) => !['g++', 'cmake', 'ninja-build'].includes(name));
  const apt = 'apt-get -q -y -o DPkg::Lock::Timeout=300';
  const names = libraries.map((name) => `${name}:arm64`).join(' ');
  const script = `export DEBIAN_FRONTEND=noninteractive; dpkg --add-architecture arm64; ${apt} update; ${apt} install --no-install-recommends ${names}; touch /.arm64`;
  execFileSync('chroot', [folder, 'bash', '-euc', script], { stdio: 'ignore' });
  return folder;
}

/** Runs a command in the checkout, which is at its own place in the chroot. Mounts end with it. */
function inCross(folder, command, log) {
  const mounts = `mount --bind ${ROOT} ${folder}${ROOT}; mount -t proc proc ${folder}/proc; mount --rbind /dev ${folder}/dev`;
  const script = `${mounts}; exec chroot ${folder} bash -euc 'cd ${ROOT}; export PATH=$PATH:/usr/local/bin; ${command}'`;
  return runLogged('unshare', ['--mount', '--propagation', 'private', 'bash', '-euc', script], { log });
}

await main(async () => {
  if (process.arch === 'arm64') throw new SetupError('this machine is arm64', { cure: 'npm run package' });
  if (process.getuid() !== 0) throw new SetupError('a chroot needs root');
  if (spawnSync('debootstrap', ['--version']).error) throw new SetupError('debootstrap is missing', { cure: 'sudo apt-get install debootstrap' });
  await setUp({ groups: [], presets: [] });
  let folder;
  await step('System with a cross compiler', async (begin) => {
    begin('making, or present');
    folder = crossSystem();
    addNode(folder, NODE);
    mkdirSync(path.join(folder, ROOT), { recursive: true });
    return 'done';
  });
  await step('Build (release-arm64)', async (begin) => {
    begin('compiling');
    await inCross(folder, 'node js/build/addon.mjs release-arm64', 'arm64-build.log');
    return 'done';
  });
  await step('Packages', async () => {
    await inCross(folder, 'node js/build/package/write.mjs arm64', 'arm64-package.log');
    return readdirSync(path.join(ROOT, 'out/package')).join(' ');
  });
  return 0;
});
