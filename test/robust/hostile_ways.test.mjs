// Hostile models by path: all at once by the command line with a manifest, and through a pool. Each ends as it must, no worker is lost, and no
// file is left that is not whole.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { TABLE } from '../../js/error/table.mjs';
import { open } from '../js/pool/support.mjs';
import { makeCases, writeCases } from './make_cases.mjs';
import { faultOf, sharedCases, WITHOUT_SHARED } from './shared_cases.mjs';

const BIN = fileURLToPath(new URL('../../js/cli/telar.mjs', import.meta.url));
const SHOT = { size: { width: 8, height: 8 }, environment: 'none' };
const WORKERS = 2;
/** Kinds of errors that blame the file: no worker was lost, and no time was up. */
const OF_FILES = ['input', 'denied', 'unsupported', 'limit'];

const root = mkdtempSync(path.join(tmpdir(), 'telar-ways-'));
after(() => rmSync(root, { recursive: true }));

/** @typedef {{name: string, path: string, faultOf: (end: {code?: string, warnings?: object[]}) => string | undefined}} HostileFile */

/** Refused where the file comes as bytes alone; by path its neighbours may be read. */
const OF_BYTES = 'E_URI_DENIED';
/** Says of the shot, which has no light, and nothing of the file. */
const OF_SHOT = 'W_EXPOSURE';

const cases = makeCases();
const at = writeCases(root, cases);

/** What of this tree must end as it says. @returns {HostileFile[]} */
const ownFiles = () =>
  cases.map(({ name, code, byPath }) => ({
    name,
    path: path.join(at, name),
    faultOf: ({ code: found = '' }) =>
      found === code || (code === OF_BYTES && !byPath) ? undefined : `${name}: ${found || 'a picture'}, expected ${code || 'a picture'}`,
  }));

/** @returns {HostileFile[]} */
const sharedFiles = () =>
  sharedCases().map((entry) => {
    const expected = { ...entry, code: entry.code === OF_BYTES && entry.mode === 'bytes' ? '' : entry.code };
    return { name: entry.file, path: entry.path, faultOf: (end) => faultOf(expected, end) };
  });

/** @returns {{warnings: object[]}} */
const drawnWith = ({ warnings }) => ({ warnings: warnings.filter(({ code }) => code !== OF_SHOT) });

/** @param {HostileFile[]} files @param {{code?: string, warnings?: object[]}[]} ends */
function assertEnds(files, ends) {
  assert.equal(ends.length, files.length);
  const faults = files.map((file, i) => file.faultOf(ends[i]));
  const blamed = ends.map(({ code }, i) => (code && !OF_FILES.includes(TABLE[code].kind) ? `${files[i].name}: ${code} blames something else` : undefined));
  assert.deepEqual([...faults, ...blamed].filter(Boolean), []);
}

/** @returns {Promise<{status: number, stdout: string, stderr: string}>} */
const telar = (argv) =>
  new Promise((resolve) => {
    execFile(process.execPath, [BIN, ...argv], { maxBuffer: 1 << 28 }, (error, stdout, stderr) => resolve({ status: error ? error.code : 0, stdout, stderr }));
  });

/** Draws all by one command. */
async function byCommandLine(files) {
  const folder = mkdtempSync(path.join(root, 'out-'));
  const manifest = path.join(root, `${path.basename(folder)}.jsonl`);
  writeFileSync(manifest, files.map(({ path: model }, i) => JSON.stringify({ model, output: path.join(folder, `${i}.png`), shot: SHOT })).join('\n'));
  const { status, stdout, stderr } = await telar(['thumbnail', '--manifest', manifest, '--jobs', String(WORKERS), '--json', '--quiet']);
  const { exit, images } = JSON.parse(stdout || assert.fail(stderr));
  assert.equal(status, exit);
  const drawn = images.flatMap(({ ok }, i) => (ok ? [`${i}.png`] : []));
  assert.deepEqual(readdirSync(folder).sort(), drawn.sort(), 'a picture of each that says so, and nothing else');
  for (const file of drawn) assert.equal(readFileSync(path.join(folder, file)).subarray(-8, -4).toString(), 'IEND', file);
  return images.map(({ ok, error, info }) => (ok ? drawnWith(info) : { code: error.code }));
}

async function byPool(files) {
  const pool = await open({ size: WORKERS });
  const pids = () => pool.workers.map(({ pid }) => pid);
  const before = pids();
  const ends = await Promise.all(
    files.map((file) =>
      pool.render(file.path, SHOT).then(
        ({ info }) => drawnWith(info),
        ({ code }) => ({ code }),
      ),
    ),
  );
  assert.deepEqual(pids(), before, 'no worker is lost');
  await pool.close();
  return ends;
}

for (const [way, draw] of [
  ['the command line', byCommandLine],
  ['a pool', byPool],
]) {
  test(`each own case by ${way}`, async () => {
    const files = ownFiles();
    assert.ok(files.length > 100);
    assertEnds(files, await draw(files));
  });

  test(`each shared case by ${way}`, { skip: WITHOUT_SHARED }, async () => {
    const files = sharedFiles();
    assert.ok(files.length > 300);
    assertEnds(files, await draw(files));
  });
}

const file = { name: 'one.glb', faultOf: (end) => faultOf({ file: 'one.glb', accept: ['reject'], code: 'E_JSON' }, end) };
for (const [what, ends] of [
  ['a picture of what must be refused', [{}]],
  ['another code', [{ code: 'E_GRAPH' }]],
  ['an error that blames a worker', [{ code: 'X_CRASH' }]],
  ['no end', []],
])
  test(`planted: ${what} is found`, () => assert.throws(() => assertEnds([file], ends), assert.AssertionError));
test('planted: what is right is not', () => assertEnds([file], [{ code: 'E_JSON' }]));
