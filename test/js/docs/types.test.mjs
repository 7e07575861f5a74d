import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const tsc = fileURLToPath(new URL('../../../node_modules/typescript/bin/tsc', import.meta.url));

test('the types hold for ESM and CommonJS users, and refuse what is wrong', () => {
  const { status, stdout, stderr } = spawnSync(process.execPath, [tsc, '-p', 'test/types'], { cwd: root, encoding: 'utf8' });
  assert.equal(`${stdout}${stderr}`, '');
  assert.equal(status, 0);
});

test('each entry declares exactly what it exports', async () => {
  for (const entry of ['js/index', 'js/shot/index', 'js/compare/index', 'js/pool/index', 'js/queue/index', 'js/three/index']) {
    const declared = [...readFileSync(`${root}${entry}.d.ts`, 'utf8').matchAll(/^export (?:class|function|const) (\w+)|^export \{ ([\w, ]+) \}/gm)].flatMap(
      ([, one, many]) => one ?? many.split(', '),
    );
    const exported = Object.keys(await import(`${root}${entry}.mjs`));
    assert.deepEqual(declared.sort(), exported.sort(), entry);
  }
});
