import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { aptLine, listedPackages, missingPackages } from '../../../js/machine/debian.mjs';
import { ROOT } from '../../../js/machine/step.mjs';
import { rootCommands } from '../../../js/setup/debian.mjs';

const GROUPS = ['build', 'run', 'test', 'lint', 'fuzz'];
const hasDpkg = spawnSync('dpkg-query', ['--version']).status === 0;

test('the list: every line has a name, a known group and a reason', () => {
  const lines = readFileSync(path.join(ROOT, 'js/machine/debian_packages.txt'), 'utf8')
    .split('\n')
    .filter((line) => line && !line.startsWith('#'));
  assert.ok(lines.length > 20);
  for (const line of lines) assert.match(line, /^[a-z0-9.+-]+ +(build|run|test|lint|fuzz) +\S.{4,}/);
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

test('what runs as root: with sudo where one is not, which waits for a password only at a terminal', () => {
  const apt = 'env DEBIAN_FRONTEND=noninteractive apt-get -y -q -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3';
  const lines = (who) => rootCommands(['a', 'b'], who).map((command) => command.join(' '));
  assert.deepEqual(lines({ root: true, terminal: false }), [`${apt} update`, `${apt} install --no-install-recommends a b`]);
  assert.deepEqual(lines({ root: false, terminal: true }), [`sudo ${apt} update`, `sudo ${apt} install --no-install-recommends a b`]);
  assert.deepEqual(lines({ root: false, terminal: false }), [`sudo -n ${apt} update`, `sudo -n ${apt} install --no-install-recommends a b`]);
});

/**
 * The step on a machine where no package is installed until apt-get says so: dpkg-query, apt-get and sudo are ours, and tell what they
 * are called with.
 */
function onBareMachine(t, { aptStatus = 0, env = {} } = {}) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-apt-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const program = (name, text) => {
    writeFileSync(path.join(folder, name), `#!/bin/sh\n${text}\n`);
    chmodSync(path.join(folder, name), 0o755);
  };
  const [calls, installed] = ['calls', 'installed'].map((name) => path.join(folder, name));
  program('dpkg-query', `[ -e ${installed} ] && shift 2 && for name; do echo "$name installed"; done; exit 0`);
  program('apt-get', `echo "apt-get $*" >> ${calls}; case "$*" in *install*) touch ${installed};; esac; exit ${aptStatus}`);
  program('sudo', '[ "$1" = -n ] && shift; exec "$@"');
  const script = `
    import { ensureDebianPackages } from ${JSON.stringify(path.join(ROOT, 'js/setup/debian.mjs'))};
    import { main, step } from ${JSON.stringify(path.join(ROOT, 'js/machine/step.mjs'))};
    await main(async () => step('Debian packages', (begin) => ensureDebianPackages(['lint'], begin)));`;
  const { status, stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', script], {
    encoding: 'utf8',
    env: { ...process.env, TELAR_NO_SYSTEM: '', ...env, PATH: `${folder}:${process.env.PATH}` },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  const ran = existsSync(calls) ? readFileSync(calls, 'utf8').trim().split('\n') : [];
  const told = stderr.split('\n').filter((line) => line.startsWith('as root: '));
  return { status, stderr, ran, told };
}

const NAMES = listedPackages(['lint']).join(' ');

test('the very lines that run as root are told, and before they run', (t) => {
  const { status, stderr, ran, told } = onBareMachine(t);
  assert.equal(status, 0, stderr);
  assert.equal(ran.length, 2);
  assert.deepEqual(
    told.map((line) => line.replace(/^as root: (sudo -n )?env DEBIAN_FRONTEND=noninteractive /, '')),
    ran,
  );
  assert.ok(ran[1].endsWith(` install --no-install-recommends ${NAMES}`));
  assert.match(stderr, /^as root: .*\nas root: .*\nDebian packages: installing 2 of 2 \(.*\) \.\.\. done/);
  // apt-get that fails at once was told all the same, with the install that then never ran.
  const failed = onBareMachine(t, { aptStatus: 100 });
  assert.deepEqual([failed.status, failed.ran.length, failed.told.length], [6, 1, 2]);
  assert.match(failed.stderr, /Cure: run this, then the same command again:\n {4}sudo apt-get update/);
});

test('TELAR_NO_SYSTEM=1: the lines are told, nothing runs, and the cure stands at the end', (t) => {
  const { status, stderr, ran, told } = onBareMachine(t, { env: { TELAR_NO_SYSTEM: '1' } });
  assert.deepEqual([status, ran, told.length], [6, [], 2]);
  assert.ok(told[1].endsWith(` install --no-install-recommends ${NAMES}`));
  assert.ok(
    stderr.endsWith(
      `telar: 2 Debian packages are missing, and TELAR_NO_SYSTEM is set: nothing was run\n  Cure: run this, then the same command again:\n    ${aptLine(NAMES.split(' '))}\n`,
    ),
    stderr,
  );
  assert.equal(onBareMachine(t, { env: { TELAR_NO_SYSTEM: '0' } }).ran.length, 2);
});

test('TELAR_NO_SYSTEM=1 where nothing is missing changes nothing', { skip: !hasDpkg && 'no dpkg' }, () => {
  const script = `
    import { ensureDebianPackages } from ${JSON.stringify(path.join(ROOT, 'js/setup/debian.mjs'))};
    process.stdout.write(await ensureDebianPackages(['none'], () => {}));`;
  const { stdout, stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', script], {
    encoding: 'utf8',
    env: { ...process.env, TELAR_NO_SYSTEM: '1' },
  });
  assert.equal(stdout, 'all 0 present', stderr);
});

// A library that happens to be on a developer's machine would pass every build until the first fresh one.
test('what CMake found belongs to packages on the list', { skip: !hasDpkg && 'no dpkg' }, (t) => {
  const cache = path.join(process.env.TELAR_BUILD_DIR ?? path.join(ROOT, 'out/dev'), 'CMakeCache.txt');
  if (!existsSync(cache)) return t.skip('no CMake build folder');
  const found = [...readFileSync(cache, 'utf8').matchAll(/^(\w+):(?:FILEPATH|PATH)=(\/usr\/(?:lib|include|share)\/\S+)$/gm)]
    .filter(([, name, file]) => !name.startsWith('CMAKE_') && file !== '/usr/include')
    .map(([, , file]) => file);
  assert.ok(
    found.some((file) => file.includes('nlohmann_json')),
    'the cache was read',
  );
  const listed = new Set(listedPackages(GROUPS));
  // "libgtest-dev:amd64, libgmock-dev:amd64: /path"; empty for what was installed by hand.
  const ownersOf = (file) =>
    spawnSync('dpkg-query', ['-S', file], { encoding: 'utf8' })
      .stdout.split(': ')[0]
      .split(', ')
      .map((name) => name.split(':')[0]);
  const strangers = found.map((file) => [file, ownersOf(file)]).filter(([, owners]) => owners[0] && !owners.some((owner) => listed.has(owner)));
  assert.deepEqual(strangers, [], 'add these packages to js/machine/debian_packages.txt');
});
