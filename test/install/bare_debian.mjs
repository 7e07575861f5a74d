// npm install of what `npm run package` wrote, on a bare Debian: no compiler, no -dev package, Node and Mesa alone. Draws the bundled velvet,
// and says how long it took from `npm install` to the picture. As root, with debootstrap, a network, and out/package.
// node test/install/bare_debian.mjs [bookworm|trixie]... [--node 20,22,24]
import { spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { addNode, system } from '../../js/setup/bare_system.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const MESA = ['libegl1', 'libgles2', 'libgl1-mesa-dri'];
const { values, positionals } = parseArgs({ options: { node: { type: 'string', default: '20,22,24' } }, allowPositionals: true });
const releases = positionals.length ? positionals : ['bookworm', 'trixie'];

/** Installs and draws. @returns {{seconds: number, png: Buffer, doctor: string}} */
function installAndDraw(folder) {
  const app = path.join(folder, 'app');
  rmSync(app, { recursive: true, force: true });
  mkdirSync(app);
  const own = new RegExp(`^telar-(linux-${process.arch}-)?\\d.*\\.tgz$`);
  const packages = readdirSync(path.join(ROOT, 'out/package')).filter((name) => own.test(name));
  for (const name of packages) copyFileSync(path.join(ROOT, 'out/package', name), path.join(app, name));
  writeFileSync(path.join(app, 'package.json'), '{"private": true}');
  const started = performance.now();
  const inside = (command) => {
    const { status, stdout, stderr } = spawnSync('chroot', [folder, 'sh', '-c', `cd /app && ${command}`], { encoding: 'utf8', timeout: 240_000 });
    if (status !== 0) throw new Error(`${command} ended with ${status}\n${stdout}\n${stderr}`);
    return stdout;
  };
  inside(`npm install --no-audit --no-fund ${packages.map((name) => `./${name}`).join(' ')}`);
  inside('node node_modules/telar/js/cli/telar.mjs thumbnail node_modules/telar/js/assets/cloths/velvet.glb -o velvet.png');
  const seconds = (performance.now() - started) / 1000;
  return { seconds, png: readFileSync(path.join(app, 'velvet.png')), doctor: inside('node node_modules/telar/js/cli/telar.mjs doctor || true') };
}

for (const release of releases) {
  const folder = system(release, MESA);
  if (existsSync(path.join(folder, 'usr/bin/cc'))) throw new Error(`${release} has a compiler: it is not bare`);
  for (const version of values.node.split(',')) {
    const full = addNode(folder, version);
    const { seconds, png, doctor } = installAndDraw(folder);
    if (png.toString('latin1', 1, 4) !== 'PNG' || png.length < 10_000) throw new Error(`no picture: ${png.length} bytes`);
    const lacks = doctor.split('\n').filter((line) => /missing|not installed|cannot be loaded/i.test(line));
    console.log(`${release}, node ${full}: first picture after ${seconds.toFixed(1)} s, ${png.length} bytes`);
    for (const line of lacks) console.log(`  ${line.trim()}`);
  }
}
