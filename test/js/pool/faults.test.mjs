import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import '../api/support/real.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { workerLibrary } from '../../../js/api/native.mjs';
import { TelarError } from '../../../js/error/index.mjs';
import { ChildJobs } from '../../../js/pool/child_jobs.mjs';
import { until } from '../../until.mjs';
import { buildLibrary, failAllocations, faultsOf } from '../../faults/support.mjs';

// Faults of the machine: no memory, no descriptors, a full or read-only disk, no home, no GL. Each ends in a typed error, with nothing half written.

const BIN = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
const { EMFILE, EROFS, ENOSPC, EIO, EACCES } = os.constants.errno;
/** Files whose path holds this meet the faults. */
const MARK = '/faulty';

let built, model, good;
before(async () => {
  built = buildLibrary();
  model = path.join(built.folder, 'cloth.glb');
  writeFileSync(model, await MODELS.cloth());
  const { out, exit } = await thumbnail({});
  assert.equal(exit, 0);
  good = readFileSync(path.join(out, 'cloth.png'));
});

const run = (file, argv, env) =>
  new Promise((resolve) => {
    execFile(file, argv, { env }, (error, stdout, stderr) => resolve({ exit: error?.code ?? 0, stdout, stderr }));
  });

const withLibrary = (faults) => ({ LD_PRELOAD: built.library, TELAR_FAULT_PATH: MARK, ...faults });

/** Draws into a folder of its own; what the command says, and what is there. */
async function thumbnail(env, { argv = [], drop = [] } = {}) {
  const out = mkdtempSync(path.join(built.folder, 'faulty-'));
  const kept = Object.fromEntries(Object.entries(process.env).filter(([name]) => !drop.includes(name)));
  const told = await run(process.execPath, [BIN, 'thumbnail', model, '-o', path.join(out, 'cloth.png'), '--size', '48', '--json', ...argv], {
    ...kept,
    ...env,
  });
  return { ...told, out, files: readdirSync(out) };
}

/**
 * Before a worker has begun, or near it, which differs by what Node does first: where it ends then, another one draws the job. Then until the GL has the model,
 * and of those that Mesa makes while it draws.
 */
const BEGINNING = [1, 2, 5, 20, 100];
const LOADING = [250, 400, 600, 800, 1000, 1200];
const DRAWING = [1500, 1800, 2100, 2400, 2700, 2806, 2950];
test('an allocation of a worker that fails: the picture or a typed error, and the next job is drawn', async () => {
  const found = await failAllocations(built, [...BEGINNING, ...LOADING, ...DRAWING]);
  assert.deepEqual(
    found.flatMap(({ n, faults }) => faults.map((fault) => `${n}: ${fault}`)),
    [],
  );
  const loading = found.filter(({ n, isHit }) => isHit && LOADING.includes(n));
  assert.ok(loading.length > 4 && loading.every(({ outcome }) => outcome !== 'picture'), JSON.stringify(found));
});

/** What a process with a bound on its memory has counted: at its start, after an allocation within the bound, and after one over it. */
async function counted(preload) {
  const text = `
    import { loadNative } from ${JSON.stringify(new URL('../../../js/api/native.mjs', import.meta.url).href)};
    const native = loadNative();
    native.isolate(2 ** 30);
    const told = [native.failedAllocations()];
    for (const bytes of [1e6, 1.5 * 2 ** 30]) {
      try { new ArrayBuffer(bytes); } catch {}
      told.push(native.failedAllocations());
    }
    console.log(JSON.stringify(told));
    process.exit(0);`;
  const { stdout, stderr } = await run(process.execPath, ['--input-type=module', '-e', text], { ...process.env, LD_PRELOAD: preload.join(' ') });
  return JSON.parse(stdout || assert.fail(stderr));
}

test('an allocation that failed is counted, of another allocator too; planted: without the library nobody does', async () => {
  const { file } = workerLibrary();
  for (const preload of [[file], [file, built.library]]) {
    const [before, within, over] = await counted(preload);
    assert.ok(within === before && over > before, JSON.stringify([before, within, over]));
  }
  assert.deepEqual(await counted([built.library]), [null, null, null]);
});

const lost = () => Promise.reject(new TelarError('X_GL_LOST', 'the GL context was lost'));
const liveObjects = async () => 0;

for (const [method, renderer] of [
  ['factsOf', { factsOf: lost }],
  ['renderAll', { renderAll: async () => [{ status: 'rejected', reason: new TelarError('X_GL_LOST', 'the GL context was lost') }] }],
]) {
  test(`a worker whose GL context was lost is replaced: ${method}; planted: of another error it stays`, async () => {
    const toldOf = async (from) => {
      const told = [];
      const jobs = new ChildJobs({ ...from, liveObjects }, { outputBytes: 1, limits: {} }, { answer: (answer) => told.push(answer), isSpoiled: () => false });
      const loading = { failOn: 'error' };
      jobs.take({ job: { id: 1, method, input: { path: 'a' }, shots: [{}], settled: true, loading } }, []);
      await until(() => told.length > 0);
      return told[0].isSpoiled === true;
    };
    const other = {
      factsOf: () => Promise.reject(new TelarError('E_JSON', 'a')),
      renderAll: async () => [{ status: 'rejected', reason: new TelarError('E_JSON', 'a') }],
    };
    assert.deepEqual([await toldOf(renderer), await toldOf(other)], [true, false]);
  });
}

test('what a worker finds after a failed allocation is not told; planted: one that does not look tells it', async () => {
  const endOf = async (isSpoiled, factsOf) => {
    const told = [];
    const jobs = new ChildJobs({ factsOf, liveObjects }, { outputBytes: 1, limits: {} }, { answer: (answer) => told.push(answer), isSpoiled });
    jobs.take({ job: { id: 1, method: 'factsOf', input: { path: 'a' }, shots: [{}] } }, []);
    await until(() => told.length > 0);
    const [{ value, error, isSpoiled: isOver = false }] = told;
    return [value, error?.code, isOver];
  };
  const [good, wrong, full] = [() => 'facts', () => Promise.reject(new TelarError('E_JSON', 'a')), () => Promise.reject(new TelarError('X_GL_MEMORY', 'a'))];
  const all = (isSpoiled) => Promise.all([good, wrong, full].map((factsOf) => endOf(isSpoiled, factsOf)));
  const spoiled = [
    [undefined, 'X_MEMORY', true],
    [undefined, 'X_MEMORY', true],
    [undefined, 'X_GL_MEMORY', true],
  ];
  assert.deepEqual(await all(() => true), spoiled);
  assert.notDeepEqual(await all(() => false), spoiled);
});

test('planted: what must not come of it', () => {
  const [drawn, other] = [{ data: Buffer.from('good') }, { data: Buffer.from('other') }];
  const of = (told, again) => faultsOf(told, again, drawn.data);
  assert.deepEqual([of(drawn, drawn), of({ code: 'X_MEMORY' }, drawn), of({ code: 'X_CRASH' }, drawn)], [[], [], []]);
  assert.deepEqual(of(other, drawn), ['another picture']);
  assert.deepEqual(of({ code: 'E_JSON', message: 'no' }, drawn), ['E_JSON: no']);
  assert.deepEqual([of(drawn, other), of(drawn, { code: 'X_WORKERS' })], [['afterwards another picture'], ['afterwards X_WORKERS']]);
});

const REFUSED = {
  'no descriptor for the output (EMFILE)': { TELAR_FAULT_OPEN: EMFILE },
  'a read-only disk (EROFS)': { TELAR_FAULT_OPEN: EROFS },
  'a disk that is full in the middle (ENOSPC)': { TELAR_FAULT_WRITE: ENOSPC },
  'a disk that breaks (EIO)': { TELAR_FAULT_SYNC: EIO },
  'a name that is not given (EACCES)': { TELAR_FAULT_RENAME: EACCES },
};
for (const [name, faults] of Object.entries(REFUSED)) {
  test(`${name}: X_OUTPUT, and nothing half written`, async () => {
    const { exit, stdout, files } = await thumbnail(withLibrary(faults));
    assert.deepEqual([exit, JSON.parse(stdout).images[0].error?.code], [6, 'X_OUTPUT'], stdout);
    assert.deepEqual(files, []);
  });
}

test('short writes: the whole file', async () => {
  const { exit, out, files, stderr } = await thumbnail(withLibrary({ TELAR_FAULT_SHORT: 1 }));
  assert.deepEqual([exit, files], [0, ['cloth.png']], stderr);
  assert.ok(readFileSync(path.join(out, 'cloth.png')).equals(good));
});

test('planted: what writes in place leaves half of a file on a full disk', async () => {
  const out = path.join(built.folder, 'faulty-planted');
  mkdirSync(out);
  const script = `require('node:fs').writeFileSync(${JSON.stringify(path.join(out, 'half'))}, 'more than seven bytes')`;
  const { stderr } = await run(process.execPath, ['-e', script], { ...process.env, ...withLibrary({ TELAR_FAULT_WRITE: ENOSPC }) });
  assert.match(stderr, /ENOSPC/);
  assert.equal(readFileSync(path.join(out, 'half')).length, 7);
});

test('no home, or one that cannot be written to: it draws', async () => {
  const home = path.join(built.folder, 'faulty-home');
  mkdirSync(home);
  const homes = ['HOME', 'XDG_CACHE_HOME', 'XDG_CONFIG_HOME', 'XDG_DATA_HOME'];
  const all = [
    await thumbnail({}, { drop: homes }),
    await thumbnail({ HOME: '/nowhere' }, { drop: homes }),
    await thumbnail({ ...withLibrary({ TELAR_FAULT_OPEN: EROFS }), TELAR_FAULT_PATH: home, HOME: home }, { drop: homes }),
  ];
  for (const { exit, out, stderr } of all) {
    assert.equal(exit, 0, stderr);
    assert.ok(readFileSync(path.join(out, 'cloth.png')).equals(good));
  }
});

test('no GL: X_GL with its cure, from a renderer and from a pool', async () => {
  const none = { __EGL_VENDOR_LIBRARY_FILENAMES: '/nowhere.json' };
  for (const argv of [[], ['--jobs', '2']]) {
    const { exit, stdout, files } = await thumbnail(none, { argv: ['--backend', 'egl-surfaceless', ...argv] });
    assert.deepEqual([exit, files], [6, []], stdout);
    assert.match(stdout, /"X_GL"|"X_WORKERS"/);
  }
});
