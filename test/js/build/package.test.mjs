import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { missingIn } from '../../../js/build/package/native.mjs';
import { writePackages, writeSbom } from '../../../js/build/package/index.mjs';
import { missingTexts } from '../../../js/build/package/licences.mjs';
import { withParts } from '../../../js/build/package/sbom.mjs';
import { addonFile } from '../api/support/real.mjs';
import '../built.mjs';

// What `npm run package` writes, unpacked as npm does, with the build of the tests in place of the release.

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const NATIVE = `telar-linux-${process.arch}`;
const folder = mkdtempSync(path.join(tmpdir(), 'telar-packages-'));
const modules = path.join(folder, 'app/node_modules');
after(() => rmSync(folder, { recursive: true }));

let bill;
before(() => {
  const { files } = writePackages({ build: path.resolve(addonFile, '../..'), folder });
  bill = JSON.parse(readFileSync(files[2], 'utf8'));
  for (const [name, file] of [
    ['telar', files[0]],
    [NATIVE, files[1]],
  ]) {
    mkdirSync(path.join(modules, name), { recursive: true });
    execFileSync('tar', ['-xzf', file, '--strip-components=1', '-C', path.join(modules, name)]);
  }
  for (const name of readdirSync(path.join(ROOT, 'node_modules'))) {
    if (!name.startsWith('.')) symlinkSync(path.join(ROOT, 'node_modules', name), path.join(modules, name));
  }
});

const manifest = (name) => JSON.parse(readFileSync(path.join(modules, name, 'package.json'), 'utf8'));

/** Runs a script in the application, which has no build of telar but the package. */
function run(...args) {
  const { TELAR_BUILD_DIR, TELAR_LIBRARY_DIR, ...env } = process.env;
  return spawnSync(process.execPath, args, { cwd: path.join(folder, 'app'), encoding: 'utf8', env });
}

test('nothing is compiled and no script runs', () => {
  const { scripts, gypfile, dependencies, optionalDependencies, version } = manifest('telar');
  assert.deepEqual([scripts, gypfile], [undefined, undefined]);
  assert.deepEqual(
    Object.keys(dependencies).filter((name) => name.startsWith('node-a')),
    [],
  );
  assert.equal(optionalDependencies[NATIVE], version);
  const { os, cpu, libc, scripts: native } = manifest(NATIVE);
  assert.deepEqual([os, cpu, libc, native], [['linux'], [process.arch], ['glibc'], undefined]);
  // npm compiles whatever has this file.
  assert.ok(!existsSync(path.join(modules, 'telar/binding.gyp')));
});

test('all that the addon links or loads is beside it, or on each system', () => {
  const at = path.join(modules, NATIVE);
  assert.deepEqual(missingIn(at), []);
  for (const name of ['libpng16.so.16', 'libzstd.so.1']) {
    renameSync(path.join(at, name), path.join(folder, name));
    assert.deepEqual(missingIn(at), [name], 'planted');
    renameSync(path.join(folder, name), path.join(at, name));
  }
});

test('it draws with its own libraries', () => {
  const script = `
    import { createRenderer } from 'telar';
    import { readFileSync } from 'node:fs';
    const renderer = await createRenderer();
    const { data } = await renderer.render('node_modules/telar/js/assets/cloths/velvet.glb', { size: { width: 64, height: 64 } });
    await renderer.close();
    const mapped = readFileSync('/proc/self/maps', 'utf8');
    console.log(JSON.stringify([data.toString('latin1', 1, 4), [...new Set(mapped.match(/\\S+libpng16\\S+/g))]]));`;
  const { stdout, stderr } = run('--input-type=module', '-e', script);
  assert.match(stdout, /PNG/, stderr);
  assert.deepEqual(
    JSON.parse(stdout)[1].filter((file) => !file.startsWith(path.join(modules, NATIVE))),
    [],
  );
});

test('without the compiled part the cure is an installation, not a compiler', () => {
  renameSync(path.join(modules, NATIVE), path.join(folder, 'away'));
  try {
    const { stdout } = run(
      '--input-type=module',
      '-e',
      "import { createRenderer } from 'telar'; await createRenderer().catch((error) => console.log(error.code, error.message));",
    );
    assert.match(stdout, /^X_NATIVE_MISSING/);
    assert.match(stdout, new RegExp(`optional dependencies, of which ${NATIVE} is one`));
  } finally {
    renameSync(path.join(folder, 'away'), path.join(modules, NATIVE));
  }
});

test('the bill of materials names each package of Debian inside, with a licence whose text is in the package', () => {
  assert.equal(bill.specVersion, '1.5');
  const debian = bill.components.filter(({ purl }) => purl.startsWith('pkg:deb/'));
  const licences = path.join(modules, NATIVE, 'licences');
  assert.deepEqual(
    [...debian.map(({ name }) => `${name}.txt`), 'node-addon-api.txt', 'node-api-headers.txt'].sort(),
    readdirSync(licences)
      .filter((name) => name.endsWith('.txt'))
      .sort(),
  );
  assert.deepEqual(missingTexts(licences), [], 'a licence that leads to a Debian');
  renameSync(path.join(licences, 'common/Apache-2.0'), path.join(folder, 'Apache-2.0'));
  assert.deepEqual(missingTexts(licences), ['Apache-2.0'], 'planted');
  const known = new Set(['telar@0.1.0', ...bill.components.map((component) => component['bom-ref'])]);
  assert.deepEqual(
    bill.dependencies.flatMap(({ ref, dependsOn = [] }) => [ref, ...dependsOn]).filter((ref) => !known.has(ref)),
    [],
  );
  assert.deepEqual(
    ['three', 'zod', 'draco', 'basis_universal'].filter((name) => !bill.components.some((component) => component.name === name)),
    [],
    'what js/dist holds',
  );
  const empty = { metadata: { component: { 'bom-ref': 'a', version: '1' } }, components: [], dependencies: [] };
  assert.throws(() => withParts(empty, { packages: [{ name: 'libnew1', version: '1' }], nativeName: 'b' }), /no licence for libnew1/);
});

test('what NOTICE names as a licence text is in the package', () => {
  const named = (notice) => [...notice.matchAll(/js\/dist\/[\w./-]+(?:LICENSE\.txt|README\.md)/g)].map(([file]) => file);
  const missing = (notice) => named(notice).filter((file) => !existsSync(path.join(modules, 'telar', file)));
  const notice = readFileSync(path.join(modules, 'telar/NOTICE'), 'utf8');
  assert.equal(named(notice).length, 5);
  assert.deepEqual(missing(notice), []);
  assert.deepEqual(missing(notice.replace('zod.LICENSE', 'planted.LICENSE')), ['js/dist/planted.LICENSE.txt']);
});

test('npm run sbom: the same bill without the packages', () => {
  const alone = path.join(folder, 'alone');
  const { files } = writeSbom({ build: path.resolve(addonFile, '../..'), folder: alone });
  assert.deepEqual(readdirSync(alone), ['telar.cdx.json']);
  const { components, dependencies } = JSON.parse(readFileSync(files[0], 'utf8'));
  assert.deepEqual([components, dependencies], [bill.components, bill.dependencies]);
});
