import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { aptLine, listedPackages, missingPackages } from '../../../js/setup/debian.mjs';
import { ROOT } from '../../../js/setup/step.mjs';

const GROUPS = ['build', 'run', 'test', 'lint'];
const hasDpkg = spawnSync('dpkg-query', ['--version']).status === 0;

test('the list: every line has a name, a known group and a reason', () => {
  const lines = readFileSync(path.join(ROOT, 'js/setup/debian_packages.txt'), 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  assert.ok(lines.length > 20);
  for (const line of lines) assert.match(line, /^[a-z0-9.+-]+ +(build|run|test|lint) +\S.{4,}/);
  const names = listedPackages(GROUPS);
  assert.equal(names.length, lines.length);
  assert.equal(new Set(names).size, names.length, 'no package twice');
});

test('groups select', () => {
  const list = '# comment\na build why\n\nb  run  why\nc test why\n';
  assert.deepEqual(listedPackages(['build', 'test'], list), ['a', 'c']);
});

test('a missing package is told from an installed one', { skip: !hasDpkg && 'no dpkg' }, () => {
  assert.deepEqual(missingPackages(['dpkg', 'no-such-package-of-telar']), ['no-such-package-of-telar']);
});

test('the line to paste names the packages and asks nothing', () => {
  assert.equal(aptLine(['a', 'b']), 'sudo apt-get update && sudo apt-get install -y --no-install-recommends a b');
});

// A library that happens to be on a developer's machine would pass every build until the first fresh one.
test('what CMake found belongs to packages on the list', { skip: !hasDpkg && 'no dpkg' }, (t) => {
  const cache = path.join(process.env.TELAR_BUILD_DIR ?? path.join(ROOT, 'out/dev'), 'CMakeCache.txt');
  if (!existsSync(cache)) return t.skip('no CMake build folder');
  const found = [...readFileSync(cache, 'utf8').matchAll(/^(\w+):(?:FILEPATH|PATH)=(\/usr\/(?:lib|include|share)\/\S+)$/gm)]
    .filter(([, name, file]) => !name.startsWith('CMAKE_') && file !== '/usr/include')
    .map(([, , file]) => file);
  assert.ok(found.some((file) => file.includes('nlohmann_json')), 'the cache was read');
  const listed = new Set(listedPackages(GROUPS));
  // "libgtest-dev:amd64, libgmock-dev:amd64: /path"; empty for what was installed by hand.
  const ownersOf = (file) => spawnSync('dpkg-query', ['-S', file], { encoding: 'utf8' }).stdout.split(': ')[0].split(', ').map((name) => name.split(':')[0]);
  const strangers = found.map((file) => [file, ownersOf(file)]).filter(([, owners]) => owners[0] && !owners.some((owner) => listed.has(owner)));
  assert.deepEqual(strangers, [], 'add these packages to js/setup/debian_packages.txt');
});
