import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { addonFile } from '../api/support/real.mjs';
import '../built.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { importedNames } from '../layers/rules.mjs';

// What `npm pack` writes, unpacked: it holds what runs, and leads nowhere that it does not hold.

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const DEMO = /\.(glb|gltf|png|jpe?g|webp|svg|hdr|exr)$/;
const MAX_DEMO_BYTES = 300_000;

const folder = mkdtempSync(path.join(tmpdir(), 'telar-pack-'));
const at = (...names) => path.join(folder, 'package', ...names);
after(() => rmSync(folder, { recursive: true }));

let files;
before(() => {
  // Its hook would write js/dist, which others read meanwhile.
  const out = execFileSync('npm', ['pack', '--ignore-scripts', '--json', '--pack-destination', folder], {
    cwd: ROOT,
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  execFileSync('tar', ['-xzf', path.join(folder, JSON.parse(out)[0].filename), '-C', folder]);
  files = readdirSync(at(), { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => path.relative(at(), path.join(entry.parentPath ?? entry.path, entry.name)));
  symlinkSync(path.join(ROOT, 'node_modules'), path.join(folder, 'node_modules'));
});

/** Links of the pages that lead to nothing: `page: target`. */
function brokenLinks() {
  return files
    .filter((file) => file.endsWith('.md'))
    .flatMap((page) =>
      [...readFileSync(at(page), 'utf8').matchAll(/\]\((?!https?:|#)([^)#\s]+)[^)]*\)/g)]
        .map(([, target]) => target)
        .filter((target) => !existsSync(at(path.dirname(page), target)))
        .map((target) => `${page}: ${target}`),
    );
}

/** Modules that a packed module imports by path and the package lacks: `file: name`. */
function brokenImports() {
  return files
    .filter((file) => /\.mjs$/.test(file) && !file.startsWith('js/dist/view'))
    .flatMap((file) =>
      importedNames(readFileSync(at(file), 'utf8'))
        .filter((name) => name.startsWith('.') && !existsSync(at(path.dirname(file), name)))
        .map((name) => `${file}: ${name}`),
    );
}

/** Files of js that the build graph calls or reads and the package lacks: `CMakeLists.txt: file`. A path with a star is a folder with such files. */
function missingOfBuild() {
  const has = (name) => files.some((file) => (name.includes('*') ? file.startsWith(name.split('*')[0]) : file === name));
  return files
    .filter((file) => /(^|\/)CMakeLists\.txt$|\.cmake$/.test(file))
    .flatMap((file) =>
      [
        ...readFileSync(at(file), 'utf8')
          .replace(/^\s*#.*$/gm, '')
          .matchAll(/\$\{(?:PROJECT|CMAKE)_SOURCE_DIR\}\/(js\/[^\s)"]+)/g),
      ]
        .filter(([, name]) => !has(name))
        .map(([, name]) => `${file}: ${name}`),
    );
}

test('no set-up, no test, no large demo', () => {
  assert.ok(files.length > 300, String(files.length));
  assert.deepEqual(
    files.filter((file) => /^(test|out|node_modules|js\/setup|js\/assets\/make|js\/build\/(docs|shading))\//.test(file)),
    [],
  );
  assert.deepEqual(
    files.filter((file) => DEMO.test(file) && statSync(at(file)).size > MAX_DEMO_BYTES),
    [],
  );
});

test('every link of every page leads to a file that is packed', () => {
  assert.ok(files.includes('README.md') && files.includes('js/docs/options.md'));
  assert.deepEqual(brokenLinks(), []);
  rmSync(at('js/docs/options.md'));
  files = files.filter((file) => file !== 'js/docs/options.md');
  const planted = brokenLinks();
  assert.ok(planted.includes('README.md: js/docs/options.md'), planted.join('\n'));
});

test('every module finds what it imports', () => {
  assert.deepEqual(brokenImports(), []);
  writeFileSync(at('js/api/planted.mjs'), "import {\n  a,\n} from './not_packed.mjs';\n");
  files.push('js/api/planted.mjs');
  assert.deepEqual(brokenImports(), ['js/api/planted.mjs: ./not_packed.mjs']);
});

test('the build graph finds the scripts and tables that it names', () => {
  assert.ok(files.includes('renderer/CMakeLists.txt') && files.includes('js/build/material/index.mjs'));
  assert.deepEqual(missingOfBuild(), []);
  const all = files;
  files = files.filter((file) => !file.startsWith('js/build/material/'));
  const planted = missingOfBuild();
  files = all;
  assert.deepEqual(planted, ['renderer/CMakeLists.txt: js/build/material/*.mjs', 'renderer/CMakeLists.txt: js/build/material/index.mjs']);
});

test('package.json names files that are packed', () => {
  const { bin, exports, main, scripts, types } = JSON.parse(readFileSync(at('package.json'), 'utf8'));
  const filesOf = (entry) => (typeof entry === 'string' ? [entry] : Object.values(entry).flatMap(filesOf));
  const named = [...filesOf(exports), ...filesOf(bin), main, types, scripts.install.split(' ')[1]];
  // An entry with a star stands for the files of a folder.
  const isPacked = (file) => (file.includes('*') ? files.some((packed) => packed.startsWith(file.slice(2, file.indexOf('*')))) : existsSync(at(file)));
  assert.deepEqual(
    named.filter((file) => !isPacked(file)),
    [],
  );
});

test('it draws', async () => {
  writeFileSync(at('ball.glb'), await MODELS.ball());
  const run = (...args) =>
    spawnSync(process.execPath, args, { cwd: at(), encoding: 'utf8', env: { ...process.env, TELAR_BUILD_DIR: path.resolve(addonFile, '../..') } });
  const { bin } = JSON.parse(readFileSync(at('package.json'), 'utf8'));
  const drawn = run(bin.telar, 'thumbnail', 'ball.glb', '-o', 'ball.png', '--size', '32');
  assert.equal(drawn.status, 0, drawn.stderr);
  assert.equal(readFileSync(at('ball.png')).toString('latin1', 1, 4), 'PNG');
  const required = run('-e', "require('./js/dist/index.cjs').createRenderer().then((renderer) => renderer.close()).then(() => console.log('closed'))");
  assert.equal(required.stdout, 'closed\n', required.stderr);
});
