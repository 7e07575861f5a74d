import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const tsc = fileURLToPath(new URL('../../../node_modules/typescript/bin/tsc', import.meta.url));

test('the types hold for ESM and CommonJS users, and refuse what is wrong', () => {
  const { status, stdout, stderr } = spawnSync(process.execPath, [tsc, '-p', 'test/types'], { cwd: root, encoding: 'utf8' });
  assert.equal(`${stdout}${stderr}`, '');
  assert.equal(status, 0);
});

/** Names of the values that a declaration exports. */
const declaredIn = (file) =>
  [...readFileSync(file, 'utf8').matchAll(/^export (?:class|function|const) (\w+)|^export \{ ([\w, ]+) \}|^export \* from '(.+)\.js'/gm)].flatMap(
    ([, one, many, all]) => (all ? declaredIn(path.join(path.dirname(file), `${all}.d.ts`)) : (one ?? many.split(', '))),
  );

test('each entry declares exactly what it exports', async () => {
  for (const entry of ['js/index', 'js/shot/index', 'js/compare/index', 'js/pool/index', 'js/queue/index', 'js/three/index']) {
    const exported = Object.keys(await import(`${root}${entry}.mjs`));
    assert.deepEqual(declaredIn(`${root}${entry}.d.ts`).sort(), exported.sort(), entry);
  }
});
