import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { TELAR as INSTALLED } from '../../installed_command.mjs';

// The command as npm installs it, from js/build/dist.mjs, beside the sources that the other tests run.

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));
const SOURCES = path.join(ROOT, 'js/cli/telar.mjs');
const SHIRT = path.join(ROOT, 'js/assets/tshirt.glb');

const folder = mkdtempSync(path.join(tmpdir(), 'telar-installed-'));
after(() => rmSync(folder, { recursive: true }));

const run = (program, args) => spawnSync(program, args, { encoding: 'utf8', timeout: 120_000, maxBuffer: 1 << 28 });

/** What both do, exit code, stdout and stderr; they are the same. */
function both(...args) {
  const [installed, sources] = [INSTALLED, SOURCES].map((program) => run(program, args)).map(({ status, stdout, stderr }) => ({ status, stdout, stderr }));
  assert.deepEqual(installed, sources);
  return installed;
}

/** Files of sources that look for something beside themselves. */
const placesIn = (text) => [...text.matchAll(/urlOf\("([^"]+)"\)/g)].map(([, file]) => file);

/** What the command is: what starts it, and one file for thumbnails beside one for all commands. */
const [start, thumbnail, commands] = ['telar', 'thumbnail', 'commands'].map((name) => readFileSync(path.join(path.dirname(INSTALLED), `${name}.cjs`), 'utf8'));

test('it ends and complains as its sources do', () => {
  assert.equal(both('--version').status, 0);
  assert.match(both('thumbnail', '--help').stdout, /--contact-sheet/);
  assert.match(both('inspect', SHIRT, '--json').stdout, /58421/);
  assert.match(both('looks', '--json').stdout, /flat-lay/);
  assert.equal(both('thumbnail', '--json').status, 2);
  assert.equal(both('inspect', path.join(folder, 'missing.glb')).status, 3);
  for (const text of [thumbnail, commands]) assert.ok(!/\brequire\("\.\.?\/(?!zod\.cjs)/.test(text), 'of its sources it reads none');
  // Node reads a file as a whole before it starts.
  assert.ok(start.length < 200 && thumbnail.length < 0.6 * commands.length, `${start.length}, ${thumbnail.length}, ${commands.length}`);
});

test('it draws what its sources draw', () => {
  const pictures = [INSTALLED, SOURCES].map((program, i) => {
    const file = path.join(folder, `${i}.png`);
    const { status, stderr } = run(program, ['thumbnail', SHIRT, '-o', file, '--size', '64', '--material', '*=denim', '--quiet']);
    assert.equal(status, 0, stderr);
    return readFileSync(file);
  });
  assert.ok(pictures[0].equals(pictures[1]));
});

test('what a source finds beside itself, it finds from there', () => {
  const places = [thumbnail, commands].flatMap(placesIn);
  assert.ok(places.includes('sheet/engine.mjs') && places.includes('predict/index.mjs'), places.join(', '));
  const missing = (files) => files.filter((file) => !existsSync(path.join(ROOT, 'js', file)));
  assert.deepEqual(missing(places), []);
  assert.deepEqual(missing(placesIn('urlOf("api/planted.mjs")')), ['api/planted.mjs']);
  const sheet = path.join(folder, 'sheet.pdf');
  const { status, stderr } = run(INSTALLED, ['sheet', SHIRT, '-o', sheet]);
  assert.equal(status, 0, stderr);
  assert.equal(readFileSync(sheet).toString('latin1', 0, 5), '%PDF-');
});
