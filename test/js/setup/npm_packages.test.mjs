import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { npmPackagesPresent } from '../../../js/setup/npm_packages.mjs';
import { ROOT } from '../../../js/machine/step.mjs';

/** A checkout whose lock file wants `wanted` and whose node_modules holds `installed`. */
function checkout(t, wanted, installed, folders = Object.keys(installed ?? {})) {
  const root = mkdtempSync(path.join(tmpdir(), 'telar-npm-'));
  t.after(() => rmSync(root, { recursive: true }));
  writeFileSync(path.join(root, 'package-lock.json'), JSON.stringify({ packages: { '': { name: 'telar' }, ...wanted } }));
  if (!installed) return root;
  mkdirSync(path.join(root, 'node_modules'));
  writeFileSync(path.join(root, 'node_modules/.package-lock.json'), JSON.stringify({ packages: installed }));
  for (const folder of folders) {
    mkdirSync(path.join(root, folder), { recursive: true });
    writeFileSync(path.join(root, folder, 'package.json'), '{}');
  }
  return root;
}

const A = { 'node_modules/a': { version: '1.0.0', integrity: 'sha512-x' } };
const CASES = [
  ['nothing installed', A, null, false],
  ['the same', A, A, true],
  ['more than wanted', A, { ...A, 'node_modules/b': { version: '2.0.0' } }, true],
  ['another version', A, { 'node_modules/a': { version: '1.0.1', integrity: 'sha512-x' } }, false],
  ['other bytes', A, { 'node_modules/a': { version: '1.0.0', integrity: 'sha512-y' } }, false],
  ['one missing', { ...A, 'node_modules/b': { version: '2.0.0' } }, A, false],
  ['an optional one missing', { ...A, 'node_modules/b': { version: '2.0.0', optional: true } }, A, true],
];

for (const [name, wanted, installed, expected] of CASES) {
  test(`npm packages: ${name}`, (t) => assert.equal(npmPackagesPresent(checkout(t, wanted, installed)), expected));
}

test('npm packages: a folder deleted by hand', (t) => assert.equal(npmPackagesPresent(checkout(t, A, A, [])), false));

test('the lock file is complete and names no registry', () => {
  const { packages } = JSON.parse(readFileSync(path.join(ROOT, 'package-lock.json'), 'utf8'));
  for (const [folder, entry] of Object.entries(packages)) {
    if (folder !== '') assert.ok(entry.version && entry.integrity && !entry.resolved, folder);
    // npm leaves out what a registry did not have when the lock file was made, and `npm ci` then refuses it.
    for (const name of Object.keys({ ...entry.dependencies, ...entry.optionalDependencies })) {
      const places = folder.split('/node_modules/').map((_, i, parts) => `${parts.slice(0, i + 1).join('/node_modules/')}/node_modules/${name}`);
      assert.ok(
        [`node_modules/${name}`, ...places].some((place) => packages[place]),
        `${folder}: ${name}`,
      );
    }
  }
});

/** Whether a range of engines.node has a release of this major. */
const takes = (range, major) =>
  range.split('||').some((alternative) => {
    const [, sign, least] = /^\s*(\^|~|>=?|)\s*v?(\d+)/.exec(alternative) ?? [];
    return least === undefined || (sign.startsWith('>') ? Number(least) <= major : Number(least) === major);
  });

// light-my-request is held at 6.6.0 by an override for this: later ones need cookie 2, which needs Node 22. Fastify loads it for tests alone.
test('every package of the lock file runs on the oldest Node that telar takes', () => {
  const { packages } = JSON.parse(readFileSync(path.join(ROOT, 'package-lock.json'), 'utf8'));
  const oldest = Number(/\d+/.exec(packages[''].engines.node)[0]);
  const tooNew = (entries) => Object.keys(entries).filter((folder) => !takes(entries[folder].engines?.node ?? '*', oldest));
  assert.deepEqual(tooNew(packages), []);
  assert.deepEqual(tooNew({ ...packages, planted: { engines: { node: '>=22' } } }), ['planted']);
  assert.deepEqual(tooNew({ ...packages, planted: { engines: { node: '^18.2 || ^22' } } }), ['planted']);
});
