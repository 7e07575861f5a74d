import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { addonFile } from './support/real.mjs';
import '../built.mjs';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

/** Runs text in a fresh process inside the package, where `telar` is its own name. */
function run(text, type) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [`--input-type=${type}`, '-e', text], { cwd: ROOT, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  return JSON.parse(stdout);
}
const commonjs = (text) => run(text, 'commonjs');
const module = (text) => run(text, 'module');

const NAMES = ['TelarError', 'animateWebp', 'bake', 'createRenderer', 'doctor', 'evaluateShading', 'inspect', 'pictureKey', 'toTelarError', 'versions'];

test('require and import give the same names', () => {
  assert.deepEqual(commonjs("console.log(JSON.stringify(Object.keys(require('telar')).sort()))"), NAMES);
  assert.deepEqual(module("console.log(JSON.stringify(Object.keys(await import('telar')).sort()))"), NAMES);
  const shot = module("console.log(JSON.stringify(Object.keys(await import('telar/shot')).sort()))");
  assert.ok(shot.includes('resolveShot'));
  assert.deepEqual(commonjs("console.log(JSON.stringify(Object.keys(require('telar/shot')).sort()))"), shot);
  assert.deepEqual(commonjs("console.log(JSON.stringify(Object.keys(require('telar/pool'))))"), ['createPool']);
  assert.deepEqual(commonjs("console.log(JSON.stringify(Object.keys(require('telar/queue')).sort()))"), ['TelarError', 'openQueue', 'startWorker']);
  const compare = module("console.log(JSON.stringify(Object.keys(await import('telar/compare')).sort()))");
  assert.ok(compare.includes('compareImages'));
  assert.deepEqual(commonjs("console.log(JSON.stringify(Object.keys(require('telar/compare')).sort()))"), compare);
});

test('errors of one kind of module are TelarErrors of the other', () => {
  const seen = module(`
    import { createRequire } from 'node:module';
    import { TelarError, createRenderer } from 'telar';
    const cjs = createRequire(import.meta.url)('telar');
    const errors = [await createRenderer({ backend: 'x' }).catch((e) => e), await cjs.createRenderer({ backend: 'x' }).catch((e) => e)];
    console.log(JSON.stringify(errors.map((e) => [e instanceof TelarError, e instanceof cjs.TelarError, e.code])));`);
  assert.deepEqual(seen, [
    [true, true, 'E_OPTION'],
    [true, true, 'E_OPTION'],
  ]);
});

test('a frame drawn through require', () => {
  const seen = commonjs(`
    const { createRenderer } = require('telar');
    (async () => {
      const { MODELS } = await import('${new URL('../../fixtures/index.mjs', import.meta.url)}');
      const renderer = await createRenderer({ cacheDirectory: null });
      const { data, info } = await renderer.render(await MODELS.ball(), { size: { width: 16, height: 16 } });
      await renderer.close();
      console.log(JSON.stringify([data.subarray(1, 4).toString(), info.environmentSource]));
    })();`);
  assert.deepEqual(seen, ['PNG', 'bundled']);
});

test('a frame drawn in a worker through require', () => {
  const seen = commonjs(`
    const { createPool } = require('telar/pool');
    (async () => {
      const { MODELS } = await import('${new URL('../../fixtures/index.mjs', import.meta.url)}');
      const pool = await createPool({ size: 1, cacheDirectory: null });
      const { data } = await pool.render(await MODELS.ball(), { size: { width: 16, height: 16 } });
      await pool.close();
      console.log(JSON.stringify(data.subarray(1, 4).toString()));
    })();`);
  assert.equal(seen, 'PNG');
});

test('a job of each queue through require', () => {
  const seen = commonjs(`
    const { openQueue } = require('telar/queue');
    const { mkdtempSync, rmSync } = require('node:fs');
    (async () => {
      const folder = mkdtempSync(require('node:path').join(require('node:os').tmpdir(), 'telar-entries-'));
      const codes = [];
      for (const place of [{}, { sqlite: folder + '/jobs.db' }, { redis: 'redis://127.0.0.1:1' }]) {
        const queue = await openQueue(place).catch(({ code }) => codes.push(code));
        if (!queue.add) continue;
        codes.push((await queue.add({ kind: 'inspect', asked: {}, files: { model: Buffer.from('a') } })).state);
        await queue.close();
      }
      rmSync(folder, { recursive: true });
      console.log(JSON.stringify(codes));
    })();`);
  assert.deepEqual(seen, ['waiting', 'waiting', 'X_QUEUE']);
});

test("both kinds of module share one addon and its renderers' threads in a process", () => {
  const kinds = module(`
    import { createRequire } from 'node:module';
    import { readFileSync } from 'node:fs';
    import { createRenderer } from 'telar';
    const cjs = createRequire(import.meta.url)('telar');
    const renderers = await Promise.all([createRenderer(), cjs.createRenderer()]);
    await Promise.all(renderers.map((renderer) => renderer.close()));
    console.log(JSON.stringify(new Set(readFileSync('/proc/self/maps', 'utf8').match(/\\S+telar\\.node/g)).size));`);
  assert.equal(kinds, 1);
});

const HEAVY = /OpenImageIO|OSMesa|libLLVM|libEGL|libGL|opencv|libtelar_oiio|libtelar_reference|libembree|libtbb|libzstd|libmeshoptimizer/;
const MAPS = `require('node:fs').readFileSync('/proc/self/maps', 'utf8').match(/\\S+\\.(so[.\\d]*|node)$/gm)`;

test("require('telar') with its addon maps no OpenImageIO, OSMesa, EGL, LLVM, zstd or meshoptimizer, and loads no zod", () => {
  const [files, modules] = commonjs(`
    require('telar');
    require('${addonFile}');
    console.log(JSON.stringify([[...new Set(${MAPS})], Object.keys(require.cache)]));`);
  assert.ok(files.includes(addonFile), 'the addon is mapped');
  assert.deepEqual(
    files.filter((file) => HEAVY.test(file)),
    [],
  );
  assert.deepEqual(
    modules.filter((file) => /zod/.test(file)),
    [],
  );
});

test('a thumbnail with the bundled environment maps no OpenImageIO and no OSMesa', () => {
  const files = commonjs(`
    const { createRenderer } = require('telar');
    (async () => {
      const { MODELS } = await import('${new URL('../../fixtures/index.mjs', import.meta.url)}');
      const renderer = await createRenderer({ cacheDirectory: null, backend: 'egl-surfaceless' });
      await renderer.render(await MODELS.ball(), { size: { width: 16, height: 16 } });
      await renderer.close();
      console.log(JSON.stringify([...new Set(${MAPS})]));
    })();`);
  assert.ok(
    files.some((file) => /libEGL/.test(file)),
    'the check sees what is mapped',
  );
  assert.deepEqual(
    files.filter((file) => /OpenImageIO|OSMesa|libtelar_oiio|libtelar_reference|libembree|libtbb|libmeshoptimizer/.test(file)),
    [],
  );
});

test('the addon exports its two Node-API symbols and nothing else', () => {
  const names = execFileSync('nm', ['-D', '--defined-only', addonFile], { encoding: 'utf8' })
    .trim()
    .split('\n')
    .map((line) => line.split(' ').at(-1));
  assert.deepEqual(names.sort(), ['napi_register_module_v1', 'node_api_module_get_api_version_v1']);
});

test('every file that package.json exports is there', () => {
  const manifest = JSON.parse(readFileSync(path.join(ROOT, 'package.json'), 'utf8'));
  const filesOf = (entry) => (typeof entry === 'string' ? [entry] : Object.values(entry).flatMap(filesOf));
  // An entry with a star stands for the files of its folder.
  const files = [...filesOf(manifest.exports), manifest.main].map((file) => (file.includes('*') ? path.dirname(file) : file));
  assert.deepEqual(
    files.filter((file) => !existsSync(path.join(ROOT, file))),
    [],
  );
});
