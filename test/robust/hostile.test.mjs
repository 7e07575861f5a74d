// Hostile models through the loader, one process a file: the right error, its place, soon, and nothing written.
// TELAR_BUILD_DIR (default out/dev) holds bin/telar_load.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { TABLE } from '../../js/error/table.mjs';
import { makeCases, writeCases } from './make_cases.mjs';
import { faultOf, sharedCases, WITHOUT_SHARED } from './shared_cases.mjs';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const TOOL = join(resolve(ROOT, process.env.TELAR_BUILD_DIR ?? 'out/dev'), 'bin/telar_load');
const SHARED = join(ROOT, '../shared');
const PARSED = JSON.stringify(Array.from({ length: 60_000 }, (_, i) => ({ name: `node ${i}`, children: [i + 1], translation: [i / 3, -i / 7, 1e-3 * i] })));
/** How often Node parses that JSON of 6 MB in 250 ms of processor time, where the slowest file takes half of these. */
const PARSES = 14;

/** Processor milliseconds of one parsing on this machine as it is now, the least of ten. */
function parsingMs() {
  const once = () => {
    const before = process.cpuUsage();
    JSON.parse(PARSED);
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  };
  return Math.min(...Array.from({ length: 10 }, once));
}

// Processor time: 250 ms, and more on a machine that is slower, by what parsing takes there. Builds with sanitizers need more of it.
const REFUSE_MS = Number(process.env.TELAR_REFUSE_MS ?? Math.max(250, PARSES * parsingMs()));
const PARALLEL = 2;

/** What telar_load printed; a process that died or printed something else is a failure. */
function load(file, byPath) {
  return new Promise((done, fail) => {
    const options = { timeout: 600_000, maxBuffer: 64 << 20 };
    execFile(TOOL, byPath ? [file] : [file, '--bytes'], options, (error, stdout, stderr) => {
      if (error && error.code !== 3) return fail(new Error(`${file}: ${error.signal ?? error.code}\n${stderr.slice(-4000)}`));
      done(JSON.parse(stdout));
    });
  });
}

/** A file that is refused is refused soon. The least of three looks counts: what shares a core adds to processor time too. */
async function expectSoon(first, name, again) {
  let least = first.cpuMs;
  for (let i = 0; i < 2 && least >= REFUSE_MS; i++) least = Math.min(least, (await again()).cpuMs);
  assert.ok(least < REFUSE_MS, `${name}: took ${least} ms`);
}

/** Runs `work` on all items, a few at once, and gathers what went wrong. */
async function forAll(items, work) {
  const queue = [...items];
  const faults = [];
  const worker = async () => {
    for (let item = queue.shift(); item; item = queue.shift()) {
      try {
        await work(item);
      } catch (error) {
        faults.push(error.message);
      }
    }
  };
  await Promise.all(Array.from({ length: PARALLEL }, worker));
  assert.equal(faults.length, 0, faults.join('\n'));
}

const listing = (folder) => readdirSync(folder, { recursive: true }).sort().join('\n');

let folder;
before(() => {
  assert.ok(existsSync(TOOL), 'telar_load is not built: cmake --preset dev && cmake --build --preset dev');
  folder = mkdtempSync(join(tmpdir(), 'telar-hostile-'));
});
after(() => folder && rmSync(folder, { recursive: true }));

test('the cases are deterministic, and many', () => {
  const digest = () =>
    makeCases()
      .map(({ name, bytes }) => name + createHash('sha256').update(bytes).digest('hex'))
      .join();
  assert.equal(digest(), digest());
  assert.ok(makeCases().filter(({ code }) => code).length >= 40);
});

test('each own case ends as it must', async () => {
  const cases = makeCases();
  const at = writeCases(folder, cases);
  const files = listing(folder);
  await forAll(cases, async ({ name, code, pointer, offset, warning, byPath }) => {
    const result = await load(join(at, name), byPath);
    assert.equal(result.ok ? '' : result.code, code, `${name}: ${JSON.stringify(result).slice(0, 400)}`);
    if (!code) {
      const warnings = result.scene.warnings.map((w) => w.code);
      assert.ok(!warning || warnings.includes(warning), `${name}: expected ${warning}, got [${warnings}]`);
      return;
    }
    if (pointer) assert.equal(result.pointer, pointer, name);
    if (offset !== undefined) assert.equal(result.offset, offset, name);
    assert.ok(['input', 'denied', 'unsupported', 'limit'].includes(TABLE[code].kind), name);
    assert.equal(TABLE[code].exit, code.startsWith('L_') ? 4 : 3, name);
    assert.ok(result.message.length > 10 && result.message.length <= 300, name);
    assert.ok(!result.message.includes(folder), `${name}: the message names a server path`);
    await expectSoon(result, name, () => load(join(at, name), byPath));
  });
  assert.equal(listing(folder), files, 'loading wrote or removed a file');
});

test('the formats of images are named, and the levels that a file brings', async () => {
  const at = writeCases(
    mkdtempSync(join(folder, 'formats-')),
    makeCases().filter(({ code }) => !code),
  );
  const imageOf = async (name) => (await load(join(at, name))).scene.images[0];
  assert.deepEqual(await imageOf('good.glb'), { width: 4, height: 4, format: 'PNG' });
  assert.deepEqual(await imageOf('ktx2-uastc.glb'), { width: 32, height: 16, format: 'KTX2 UASTC', levels: 6 });
  assert.deepEqual(await imageOf('ktx2-etc1s.glb'), { width: 32, height: 16, format: 'KTX2 ETC1S', levels: 6 });
  assert.deepEqual(await imageOf('ktx2-bc7.glb'), { width: 32, height: 16, format: 'KTX2 BC7', levels: 6 });
  assert.deepEqual(await imageOf('ktx2-floats.glb'), { width: 32, height: 16, format: 'KTX2 RG16F', levels: 6 });
  assert.deepEqual(await imageOf('ktx2-zstd.glb'), { width: 8, height: 4, format: 'KTX2 UASTC zstd', levels: 1 });
});

test('each shared case ends within what it accepts', { skip: WITHOUT_SHARED }, async () => {
  const cases = sharedCases();
  assert.ok(cases.length > 300);
  await forAll(cases, async (entry) => {
    const result = await load(entry.path, entry.mode === 'path');
    assert.equal(faultOf(entry, { code: result.ok ? undefined : result.code, warnings: result.scene?.warnings }), undefined);
    for (const { code } of result.ok ? result.scene.warnings : [result]) assert.ok(TABLE[code], `${entry.file}: ${code} is not in the table`);
    if (!result.ok) await expectSoon(result, entry.file, () => load(entry.path, entry.mode === 'path'));
  });
});

const models = join(SHARED, 'models');
test('each shared model loads', { skip: !existsSync(models) && 'no ../shared/models' }, async () => {
  const files = readdirSync(models, { recursive: true }).filter((name) => /\.gl(b|tf)$/.test(name));
  assert.ok(files.length > 30);
  await forAll(files, async (name) => {
    const result = await load(join(models, name), true);
    assert.ok(result.ok, `${name}: ${result.code} ${result.message}`);
    assert.ok(result.scene.triangles > 0 && result.scene.size.some((side) => side > 0), name);
  });
});
