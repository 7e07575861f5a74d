import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';

const root = fileURLToPath(new URL('../../../', import.meta.url));

// Notes each module that is loaded on stdout.
const HOOKS = `data:text/javascript,${encodeURIComponent(`
  import { writeSync } from 'node:fs';
  export async function load(url, context, next) { writeSync(1, 'LOADED ' + url + '\\n'); return next(url, context); }`)}`;
const REGISTER = `data:text/javascript,${encodeURIComponent(`import { register } from 'node:module'; register(${JSON.stringify(HOOKS)});`)}`;

function modulesOf(args) {
  const out = execFileSync(process.execPath, ['--import', REGISTER, ...args], { cwd: root, encoding: 'utf8' });
  return out
    .split('\n')
    .filter((line) => line.startsWith('LOADED '))
    .map((line) => line.slice(7));
}

const heavy = (modules) => modules.filter((url) => /node_modules\/(commander|cli-progress|color-name)\/|\/dist\/zod\.mjs$/.test(url));

test('import telar does not load the schema of the shot', () => {
  const modules = modulesOf(['--input-type=module', '-e', "await import('./js/index.mjs')"]);
  assert.ok(
    modules.some((url) => url.endsWith('js/api/renderer.mjs')),
    'the hook sees modules',
  );
  assert.deepEqual(heavy(modules), []);
});

test('resolving a shot loads it', () => {
  assert.ok(heavy(modulesOf(['--input-type=module', '-e', "await import('./js/shot/index.mjs')"])).some((url) => url.endsWith('/zod.mjs')));
});

test('telar --version and telar doctor --help load no schema', () => {
  for (const args of [['--version'], ['doctor', '--help']]) {
    assert.ok(!heavy(modulesOf(['js/cli/telar.mjs', ...args])).some((url) => url.endsWith('/zod.mjs')), args.join(' '));
  }
});
