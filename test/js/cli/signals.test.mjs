import assert from 'node:assert/strict';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { MODELS } from '../../fixtures/index.mjs';
import { overdrawGlb } from '../../fixtures/overdraw.mjs';
import '../api/support/real.mjs';

// The real program on a file that would draw for hours, and on a pipe that nobody writes to.

const BIN = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
const SMALL = ['--size', '64', '--limit', 'L_FRAGMENTS=900000000000000'];

const root = mkdtempSync(path.join(tmpdir(), 'telar-signals-'));
after(() => rmSync(root, { recursive: true }));
const at = (name) => path.join(root, name);
writeFileSync(at('much.glb'), overdrawGlb(250_000));
writeFileSync(at('ball.glb'), await MODELS.ball());
execFileSync('mkfifo', [at('pipe.hdr')]);

let outputs = 0;
/** Runs telar until `begun`, ends it by a signal: which one it died of. The work would take hours, or for ever. */
async function end(signal, argv, begun) {
  const folder = at(`out${++outputs}`);
  const child = spawn(BIN, ['thumbnail', ...argv, '-o', `${folder}/{name}.png`], { stdio: 'ignore' });
  const ended = once(child, 'exit');
  await begun(child.pid);
  child.kill(signal);
  const [, diedOf] = await ended;
  return { diedOf, files: files(folder) };
}

function files(folder) {
  try {
    return readdirSync(folder);
  } catch {
    return [];
  }
}

/** Seconds of CPU of a process so far. */
const cpuOf = (pid) =>
  readFileSync(`/proc/${pid}/stat`, 'utf8')
    .split(') ')[1]
    .split(' ')
    .slice(11, 13)
    .reduce((sum, ticks) => sum + Number(ticks), 0) / 100;

/** All that comes before takes less. */
async function drawing(pid) {
  while (cpuOf(pid) < 2.5) await sleep(20);
}

for (const signal of ['SIGTERM', 'SIGINT']) {
  test(`${signal} ends a draw that would take hours`, async () => {
    const { diedOf, files: left } = await end(signal, [at('much.glb'), '--timeout-ms', 'none', ...SMALL], drawing);
    assert.equal(diedOf, signal);
    assert.deepEqual(left, []);
  });
}

test('SIGTERM ends what waits for a pipe, and leaves nothing half-written', async () => {
  const { diedOf, files: left } = await end('SIGTERM', [at('ball.glb'), '--environment', at('pipe.hdr'), ...SMALL], () => sleep(1500));
  // Where pipes are refused the run has ended before.
  if (diedOf !== null) assert.equal(diedOf, 'SIGTERM');
  assert.deepEqual(left, []);
});

test('SIGTERM ends what waits for a shot from a pipe', async () => {
  const { files: left } = await end('SIGTERM', [at('ball.glb'), '--shot', at('pipe.hdr'), ...SMALL], () => sleep(1000));
  assert.deepEqual(left, []);
});

test('--timeout-ms: exit code 5, and the other models are drawn', () => {
  const folder = at('timeout');
  const { status, stdout, stderr } = spawnSync(BIN, ['thumbnail', at('much.glb'), at('ball.glb'), '-o', folder, '--json', '--timeout-ms', '3000', ...SMALL]);
  assert.equal(status, 5, stderr);
  const { images } = JSON.parse(stdout);
  assert.deepEqual(
    images.map(({ ok, error }) => error?.code ?? ok),
    ['X_TIMEOUT', true],
  );
  assert.deepEqual(readdirSync(folder), ['ball.png']);
});

test('a wrong --timeout-ms is told', () => {
  for (const text of ['0', '-5', '2s', '1.5', '']) {
    const { status, stderr } = spawnSync(BIN, ['thumbnail', at('ball.glb'), '-o', at('a.png'), '--timeout-ms', text]);
    assert.equal(status, 2);
    assert.match(String(stderr), /--timeout-ms: expected milliseconds or none/);
  }
});
