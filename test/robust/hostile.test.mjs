// Hostile models through the loader, one process a file: the right error, its place, soon, and nothing written.
// TELAR_BUILD_DIR (default out/dev) holds bin/telar_load.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { TABLE } from '../../js/error/table.mjs';
import { makeCases, writeCases } from './make_cases.mjs';

const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const TOOL = join(resolve(ROOT, process.env.TELAR_BUILD_DIR ?? 'out/dev'), 'bin/telar_load');
const SHARED = join(ROOT, '../shared');
// Processor time, which other work on the machine does not change. Builds with sanitizers need more of it.
const REFUSE_MS = Number(process.env.TELAR_REFUSE_MS ?? 250);
const PARALLEL = 2;

/** What telar_load printed; a process that died or printed something else is a failure. */
function load(file, byPath) {
  return new Promise((done, fail) => {
    const options = { timeout: 60_000, maxBuffer: 64 << 20 };
    execFile(TOOL, byPath ? [file] : [file, '--bytes'], options, (error, stdout, stderr) => {
      if (error && error.code !== 3) return fail(new Error(`${file}: ${error.signal ?? error.code}\n${stderr.slice(-4000)}`));
      done(JSON.parse(stdout));
    });
  });
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
    assert.ok(result.cpuMs < REFUSE_MS, `${name}: took ${result.cpuMs} ms`);
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

/** Codes of the manifest under the names that telar's table has for them. */
const ALIASES = { L_IMAGE_DIM: 'L_IMAGE_DIMENSION', W_GLB_UNKNOWN_CHUNK: 'W_GLB_CHUNK', L_TIME: 'L_IMAGE_SCANS', W_EXT: 'W_EXT_IGNORED' };

/** Where telar ends in another way than the manifest's first choice, and why. All stay within its `accept`. */
const OTHERWISE = [
  [/^j-nul-bytes/, 'E_NOT_GLTF'], // by its bytes no other than c-all-zero-4k
  [/^j-padding-nul/, ''], // the JSON in this file needs no padding: it has no NUL
  [/^u-buffer-symlink-escape/, 'E_URI_MISSING'], // the link is absent from this copy of the folder
  [/^h-gpu-instancing/, 'E_INSTANCING'],
  [/^g-matrix-zero/, ''], // three.js takes a matrix without volume for no scale
  [/^e-animation-bad/, 'E_REF'], // a pose may ask for it
  [/^p-(png-ffffffff|png-65536|png-bomb-\d|jpeg-65500|webp-16383)/, 'L_IMAGE_DIMENSION'], // a side is checked before the area
  [/^p-png-bomb-idat-longer/, ''], // all pixels are there: drawing and refusing are both right
  [/^p-png-bomb-idat-longer/, 'E_IMAGE_CORRUPT'],
  [/^p-png-no-iend/, 'E_IMAGE_CORRUPT'], // cut files are refused, whatever was lost
  [/^p-png-palette-index/, ''], // drawn as browsers do
  [/^o-meshopt-optional-broken/, 'E_MESHOPT'], // three.js does not fall back either
  [/^e-(texture-transform|light)-1e400/, 'E_SCHEMA'], // a number that is no double is refused wherever it stands
  [/^d-empty/, 'E_BUFFERVIEW'], // a view of no bytes is wrong in itself
  [/^d-accessor-type-scalar/, 'E_ACCESSOR'], // as is a POSITION of scalars
];

function codesOf(result) {
  if (!result.ok) return [result.code];
  const warnings = result.scene.warnings.map((w) => w.code);
  return warnings.length ? warnings : [''];
}

function isExpected(entry, codes) {
  if (!entry.code || entry.code === 'E_*' || codes.includes(entry.code) || codes.includes(ALIASES[entry.code])) return true;
  return OTHERWISE.some(([file, code]) => file.test(entry.file) && codes.includes(code));
}

const manifest = join(SHARED, 'hostile/manifest.json');
test('each shared case ends within what it accepts', { skip: !existsSync(manifest) && 'no ../shared/hostile' }, async () => {
  const { cases } = JSON.parse(readFileSync(manifest, 'utf8'));
  assert.ok(cases.length > 300);
  await forAll(cases, async (entry) => {
    const result = await load(join(SHARED, 'hostile/cases', entry.file), entry.mode === 'path');
    const outcome = result.ok ? 'render' : result.code.startsWith('L_') ? 'limit' : 'reject';
    const codes = codesOf(result);
    assert.ok(entry.accept.includes(outcome), `${entry.file}: ${outcome} ${codes}, accepted ${entry.accept}`);
    assert.ok(isExpected(entry, codes), `${entry.file}: ${codes}, expected ${entry.code}`);
    for (const code of codes) assert.ok(code === '' || TABLE[code], `${entry.file}: ${code} is not in the table`);
    if (!result.ok) assert.ok(result.cpuMs < REFUSE_MS, `${entry.file}: took ${result.cpuMs} ms`);
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
