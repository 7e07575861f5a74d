// The Dockerfile without Docker: its own lines run one after the other, each stage in a chroot over a bare Debian; the image is then
// started as compose.yaml says: read-only root, no root user, no capability. Draws a picture by the command line and one over HTTP.
// As root, with debootstrap and a network; port 8080 is free.
// node test/install/image.mjs [--packages out/package] [--build-arg NAME=VALUE]...   --packages: in place of the stages that compile
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { once } from 'node:events';
import { mkdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { parse } from 'yaml';
import { stagesOf } from './dockerfile.mjs';
import { make } from './stages.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const VELVET = '/opt/telar/node_modules/telar/js/assets/cloths/velvet.glb';
const READY_WITHIN_MS = 60_000;

// Mounts end with the process.
if (!process.env.TELAR_IMAGE_NAMESPACE) {
  const args = ['--mount', '--propagation', 'private', process.execPath, ...process.argv.slice(1)];
  process.exit(spawnSync('unshare', args, { stdio: 'inherit', env: { ...process.env, TELAR_IMAGE_NAMESPACE: '1' } }).status ?? 1);
}

const { values } = parseArgs({ options: { packages: { type: 'string' }, 'build-arg': { type: 'string', multiple: true, default: [] } } });
const service = parse(readFileSync(path.join(ROOT, 'compose.yaml'), 'utf8')).services.telar;
const stages = stagesOf(
  readFileSync(path.join(ROOT, 'Dockerfile'), 'utf8'),
  Object.fromEntries(values['build-arg'].map((pair) => pair.split(/=(.*)/s).slice(0, 2))),
);
const made = new Map(values.packages ? [['packages', { root: path.resolve(values.packages) }]] : []);
const { root, config } = make(stages.at(-1), { stages, made, context: ROOT });

/** The command line that starts a program in the image as the service runs: by compose.yaml's user, rights and capabilities. */
function started(words, { pids = false } = {}) {
  const [uid, gid] = config.user.split(':');
  const rights = [
    ...(service.security_opt?.includes('no-new-privileges:true') ? ['--no-new-privs'] : []),
    ...(service.cap_drop?.includes('ALL') ? ['--bounding-set=-all', '--inh-caps=-all'] : []),
  ];
  const user = ['setpriv', `--reuid=${uid}`, `--regid=${gid}`, '--clear-groups', ...rights];
  const chroot = ['chroot', root, ...user, 'sh', '-c', `cd ${config.cwd} && exec "$@"`, 'sh', ...words];
  return [pids ? ['unshare', '--pid', '--fork', '--kill-child=SIGTERM', ...chroot] : chroot, { env: config.env }];
}

/** Runs a program to its end. */
function run(...words) {
  const [[command, ...args], options] = started(words);
  return spawnSync(command, args, { ...options, maxBuffer: 1 << 28 });
}

function expect(what, holds, details = '') {
  if (!holds) throw new Error(`${what}: no. ${details}`);
  console.log(`ok: ${what}`);
}

const writes = (file) => run('sh', '-c', `: > ${file}`).status === 0;
const writesAsRoot = (file) => spawnSync('chroot', [root, 'sh', '-c', `: > ${file} && rm ${file}`]).status === 0;

// Planted: before it is read-only, the same look finds that it may be written.
expect('the look at the root tells a writable one', writesAsRoot('/opt/telar/planted'));
if (service.read_only) execFileSync('mount', ['-o', 'remount,ro', root]);
for (const [folder, options] of (service.tmpfs ?? []).map((entry) => entry.split(':'))) {
  mkdirSync(path.join(root, folder), { recursive: true });
  execFileSync('mount', ['-t', 'tmpfs', '-o', options, 'tmpfs', path.join(root, folder)]);
}
expect('the root is read-only, for root too', !writesAsRoot('/opt/telar/planted') && !writesAsRoot('/var/lib/planted'));
expect('/tmp may be written', writes('/tmp/mine'));
const who = run('sh', '-c', 'id -u; grep -E "^(CapEff|CapBnd|NoNewPrivs)" /proc/self/status').stdout.toString();
expect('a user without rights', /^[1-9]\d*\n/.test(who) && /CapEff:\s+0+\n/.test(who) && /CapBnd:\s+0+\n/.test(who) && /NoNewPrivs:\s+1/.test(who), who);
expect('no compiler, no package with headers', run('sh', '-c', 'command -v cc gcc g++ cmake make || ls /usr/include/*.h').status !== 0);

for (const line of run(...config.entrypoint, 'doctor')
  .stdout.toString()
  .split('\n'))
  if (/^(reference|image files|workers|chosen)/.test(line)) console.log(`doctor: ${line}`);
const drawn = run(...config.entrypoint, 'thumbnail', VELVET, '-o', '/tmp/velvet.png');
expect('a picture by the command line', drawn.status === 0, drawn.stderr.toString());
const picture = readFileSync(path.join(root, 'tmp/velvet.png'));
expect('it is one', picture.toString('latin1', 1, 4) === 'PNG' && picture.length > 10_000, `${picture.length} bytes`);

const sheet = run(...config.entrypoint, 'sheet', VELVET, '-o', '/tmp/velvet.pdf');
expect('a tech sheet', sheet.status === 0 && readFileSync(path.join(root, 'tmp/velvet.pdf')).toString('latin1', 0, 5) === '%PDF-', sheet.stderr.toString());

const [[command, ...args], options] = started([...config.entrypoint, ...config.command], { pids: true });
const serving = spawn(command, args, { ...options, stdio: ['ignore', 'inherit', 'ignore'] });
let isReady = false;
for (const end = Date.now() + READY_WITHIN_MS; !isReady && Date.now() < end; await sleep(200)) isReady = run(...config.healthcheck).status === 0;
expect('the health check finds it ready', isReady);
const body = new FormData();
body.set('model', new Blob([readFileSync(path.join(root, VELVET))]), 'velvet.glb');
const answer = await fetch('http://127.0.0.1:8080/v1/thumbnails', { method: 'POST', body });
const overHttp = Buffer.from(await answer.arrayBuffer());
expect('the same picture over HTTP', overHttp.equals(picture), `${answer.status}: ${overHttp.toString('latin1').slice(0, 400)}`);
// As process 1, whose signals the kernel does not handle for it.
const child = Number(readFileSync(`/proc/${serving.pid}/task/${serving.pid}/children`, 'utf8').trim());
process.kill(child, 'SIGTERM');
const [code] = await once(serving, 'exit');
expect('SIGTERM ends it well', code === 0, `code ${code}`);
expect('and then the health check fails', run(...config.healthcheck).status !== 0);

const mib = (folder) => Math.round(Number(execFileSync('du', ['-sxm', folder], { encoding: 'utf8' }).split('\t')[0]));
console.log(
  `layers over the base: ${mib(path.join(root, '../upper'))} MiB; the picture: sha256 ${createHash('sha256').update(picture).digest('hex').slice(0, 16)}`,
);
