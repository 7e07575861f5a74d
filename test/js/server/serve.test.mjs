import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, truncateSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { gradient } from '../../fixtures/environment.mjs';
import { ENDLESS, GLB, MODELS, SHOT, at, bytesOf, connect, post, problemOf, readiness } from './support.mjs';
import { startTelar } from '../../telar_process.mjs';
import { until } from '../../until.mjs';

// The real program: `telar serve`, and its end by SIGTERM.

const glb = await MODELS.cloth();

const folder = mkdtempSync(path.join(tmpdir(), 'telar-serve-'));
after(() => rmSync(folder, { recursive: true }));
mkdirSync(path.join(folder, 'models/shirts'), { recursive: true });
writeFileSync(path.join(folder, 'models/shirts/cloth.glb'), glb);
writeFileSync(path.join(folder, 'models/sky.hdr'), gradient(16));
writeFileSync(path.join(folder, 'secret.glb'), glb);
/** More than Node reads at once; it has holes, and takes no room. */
const LARGE = 3 * 2 ** 30;
writeFileSync(path.join(folder, 'models/large.glb'), '');
truncateSync(path.join(folder, 'models/large.glb'), LARGE);
symlinkSync(path.join(folder, 'secret.glb'), path.join(folder, 'models/link.glb'));

/** Runs the program until it listens. */
async function serve(argv, env) {
  const { said, found, ...rest } = await startTelar(['serve', ...argv], { says: /http:\S+\n/, env });
  assert.ok(found, said.err);
  const [url] = /http:[^"\s]+/.exec(found);
  return { ...rest, said, url, port: Number(new URL(url).port) };
}

/** Runs the program to its end. */
async function ends(argv) {
  const { ended, said } = await startTelar(['serve', ...argv]);
  return { code: (await ended).code, text: said.err };
}

test('with no more than a port it draws at once, on this machine alone; models beneath a folder, environments by name', async () => {
  const models = path.join(folder, 'models');
  const { child, url, ended, said } = await serve(['--port', '0', '--workers', '1', '--models', models, '--environment', `sky=${models}/sky.hdr`]);
  assert.match(url, /^http:\/\/127\.0\.0\.1:\d+$/);
  const drawn = await bytesOf(await post(url, '/v1/thumbnails', glb, { shot: SHOT }));
  assert.equal(drawn.subarray(1, 4).toString(), 'PNG');
  const ask = (model, shot = SHOT) => fetch(at(url, '/v1/thumbnails', { model, shot }));
  assert.ok((await bytesOf(await ask('shirts/cloth.glb'))).equals(drawn));
  for (const model of ['secret.glb', '../secret.glb', 'link.glb', 'shirts/../../secret.glb', 'shirts', '', `${models}/../secret.glb`, '/etc/passwd']) {
    assert.equal((await problemOf(await ask(model))).code, 'E_NOT_FOUND', model);
  }
  const large = await problemOf(await ask('large.glb'));
  assert.deepEqual([large.code, large.limit.actual], ['L_FILE_BYTES', LARGE], 'it is not read');
  const lit = await ask('shirts/cloth.glb', { ...SHOT, environment: 'sky' });
  assert.deepEqual([lit.status, (await bytesOf(lit)).equals(drawn)], [200, false]);
  child.kill('SIGTERM');
  assert.deepEqual(await ended, { code: 0, signal: null }, said.err);
  const log = said.err
    .split('\n')
    .filter((line) => line.startsWith('{'))
    .map(JSON.parse);
  assert.equal(log.filter(({ msg }) => msg === 'answered').length, 12);
  assert.ok(!said.err.includes(folder) && !said.err.includes('Warning'), said.err);
});

test('SIGTERM: what runs is finished, what is new is told to go elsewhere, and it ends well', async () => {
  const { child, url, port, ended, said } = await serve(['--port', '0', '--workers', '1', '--json', '--log-level', 'silent']);
  assert.deepEqual(Object.keys(JSON.parse(said.out)), ['ok', 'url', 'port']);
  // Its body is half there.
  const half = await connect({ port });
  const body = Buffer.from(glb);
  const address = `/v1/thumbnails?shot=${encodeURIComponent(JSON.stringify(SHOT))}`;
  half.socket.write(`POST ${address} HTTP/1.1\r\nhost: here\r\nconnection: close\r\ncontent-type: ${GLB}\r\ncontent-length: ${body.length}\r\n\r\n`);
  half.socket.write(body.subarray(0, 100));
  await until(async () => /^telar_uploads 1$/m.test(await (await fetch(new URL('/metrics', url))).text()));
  child.kill('SIGTERM');
  const refused = await until(async () => {
    const response = await post(url, '/v1/thumbnails', glb, { shot: SHOT });
    return response.status === 503 && response;
  });
  assert.equal(refused.headers.get('retry-after'), '5');
  assert.equal((await problemOf(refused)).code, 'X_SHUTDOWN');
  const ready = await fetch(new URL('/readyz', url));
  assert.deepEqual([ready.status, (await ready.json()).status], [503, 'ending']);
  assert.equal((await fetch(new URL('/healthz', url))).status, 200);
  half.socket.write(body.subarray(100));
  const answer = await half.said;
  assert.equal(answer.slice(0, 15), 'HTTP/1.1 200 OK');
  assert.ok(answer.includes('\r\n\r\n\x89PNG'));
  assert.deepEqual(await ended, { code: 0, signal: null });
});

test('SIGTERM: what takes longer than the time to drain is told so', async () => {
  const { child, url, ended } = await serve(['--port', '0', '--workers', '1', '--drain-ms', '300', '--log-level', 'silent']);
  const endless = post(url, '/v1/thumbnails', glb, { shot: ENDLESS });
  await until(async () => (await readiness(url)).running === 1);
  child.kill('SIGTERM');
  const { status, code } = await problemOf(await endless);
  assert.deepEqual([status, code], [503, 'X_SHUTDOWN']);
  assert.deepEqual(await ended, { code: 0, signal: null });
});

test('a second signal does not wait', async () => {
  const { child, url, ended } = await serve(['--port', '0', '--workers', '1', '--log-level', 'silent']);
  const endless = post(url, '/v1/thumbnails', glb, { shot: ENDLESS }).catch(() => 'cut');
  await until(async () => (await readiness(url)).running === 1);
  child.kill('SIGTERM');
  await until(async () => (await readiness(url)).status === 'ending');
  child.kill('SIGTERM');
  assert.deepEqual(await ended, { code: null, signal: 'SIGTERM' });
  assert.equal(await endless, 'cut');
});

test('what cannot be served is told with the exit code of its error', async () => {
  const { child, port, ended } = await serve(['--port', '0', '--workers', '1', '--log-level', 'silent']);
  const taken = await ends(['--port', String(port), '--workers', '1']);
  assert.deepEqual([taken.code, /X_PORT/.test(taken.text)], [6, true], taken.text);
  child.kill('SIGTERM');
  await ended;
  for (const [argv, message] of [
    [['--port', '70000'], /options\.port: expected a whole number in \[0, 65535\], got 70000/],
    [['--upload-ms', 'soon'], /options\.uploadMs: expected a whole number in \[1, [^\]]+\], got "soon"/],
    [['--log-level', 'loud'], /Allowed choices are/],
    [['--no-draw-jobs'], /options\.drawJobs: expected true, or a queue on Redis or in SQLite/],
    [['--environment', 'sky'], /expected NAME=FILE/],
    [['--workers', 'none'], /--workers: expected processes from 1 to 1024, or auto, got "none"/],
    [['--cgroup', folder], /options\.cgroup: expected a cgroup with the memory controller/],
  ]) {
    const { code, text } = await ends(argv);
    assert.equal(code, 2, text);
    assert.match(text, message);
  }
  for (const argv of [
    ['--models', path.join(folder, 'none')],
    ['--environment', `sky=${folder}/none.hdr`],
  ]) {
    const { code, text } = await ends(argv);
    assert.deepEqual([code, /E_FILE/.test(text)], [3, true], text);
  }
});
