import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { CLI, openView, SHIRT } from './support.mjs';

// The command itself: what it prints, how it ends.

const run = (args, options = {}) => spawnSync(process.execPath, [CLI, 'view', ...args], { encoding: 'utf8', timeout: 600_000, ...options });

const isListening = (port) =>
  new Promise((resolve) => {
    const socket = connect(port, '127.0.0.1', () => resolve(true)).on('error', () => resolve(false));
    socket.on('close', () => socket.destroy());
    socket.setTimeout(5000, () => socket.destroy());
    socket.once('connect', () => socket.end());
  });

test('--json is one object with the address; SIGINT ends the server and the process, by that signal', async () => {
  const view = await openView(SHIRT, ['--size', '32']);
  const { ok, url, port, model } = view.told;
  assert.deepEqual([ok, model, new URL(url).port], [true, SHIRT, String(port)]);
  assert.equal((await fetch(url)).status, 200);
  // The page keeps its connections open; they must not hold the end up.
  assert.deepEqual(await view.stop(), [null, 'SIGINT']);
  assert.equal(await isListening(port), false);
});

test('a GLB on stdin', () => {
  const script = `
    import { spawn } from 'node:child_process';
    import { createReadStream } from 'node:fs';
    const child = spawn(process.execPath, [${JSON.stringify(CLI)}, 'view', '-', '--size', '32'], { stdio: ['pipe', 'pipe', 'inherit'] });
    createReadStream(${JSON.stringify(SHIRT)}).pipe(child.stdin);
    child.stdout.once('data', async (text) => {
      const url = String(text).trim();
      const { name } = await (await fetch(url + 'session')).json();
      const bytes = await (await fetch(url + 'model/' + name)).arrayBuffer();
      console.log(JSON.stringify([name, bytes.byteLength]));
      child.kill('SIGTERM');
    });`;
  const { stdout, stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8', timeout: 600_000 });
  assert.deepEqual(JSON.parse(stdout), ['model.glb', readFileSync(SHIRT).length], stderr);
  assert.match(stderr, /^Ctrl-C ends\.$/m);
});

test('wrong usage and wrong models end before there is a page', () => {
  for (const [args, exit, message] of [
    [[], 2, /model.*E_USAGE/],
    [[SHIRT, '--port', '0'], 2, /--port.*1 to 65535.*E_USAGE/],
    [[SHIRT, '--port', 'http'], 2, /--port.*E_USAGE/],
    [[SHIRT, '--set', 'exposure=bright'], 2, /shot\.exposure.*E_SHOT/],
    [['no such.glb'], 3, /E_FILE/],
    [[CLI], 3, /E_JSON/],
    [[SHIRT, '--variant', 'plaid'], 3, /E_VARIANT/],
    [['-', '--shot', '-'], 2, /stdin.*E_USAGE/],
  ]) {
    const { status, stdout, stderr } = run(args);
    assert.deepEqual([status, stdout], [exit, ''], `${args}: ${stderr}`);
    assert.match(stderr, message);
  }
});

test('--spec: a first spec is made, measured and saved whole; wrong ones end it', async (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-view-cli-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const file = path.join(folder, 'shirt.json');
  const view = await openView(SHIRT, ['--size', '32', '--spec', file]);
  t.after(() => view.stop());
  const { name, isNew, version, callouts, measures } = await (await fetch(`${view.url}spec`)).json();
  assert.deepEqual([name, isNew, callouts.length, readdirSync(folder).length], ['shirt.json', true, 0, 0]);
  const post = async (target, body) =>
    (await fetch(view.url + target, { method: 'POST', headers: { 'content-type': 'application/json' }, body: JSON.stringify(body) })).json();
  // The outline's farthest points are the model's own: the first spec says what is measured.
  const { millimetres } = await post('measure', { measure: measures[0], index: 0 });
  assert.ok(Math.abs(millimetres / 10 - measures[0].values.M) < 0.06, `${millimetres} mm`);
  assert.match((await post('spec', { version, callouts, measures })).version, /^[0-9a-f]{64}$/);
  assert.deepEqual(readdirSync(folder), ['shirt.json'], 'no temporary file is left');
  assert.deepEqual(JSON.parse(readFileSync(file)).measures, measures);
  mkdirSync(path.join(folder, 'folder.json'));
  writeFileSync(path.join(folder, 'wrong.json'), '{"paper": {"size": "A9"}}');
  for (const [spec, exit, message] of [
    ['shirt.txt', 2, /--spec "shirt\.txt": expected the name of a \.json file.*E_USAGE/],
    [path.join(folder, 'folder.json'), 3, /cannot be read \(EISDIR\).*E_FILE/],
    [path.join(folder, 'wrong.json'), 2, /spec\.paper\.size: expected "A4".*E_SPEC/],
  ]) {
    const { status, stdout, stderr } = run([SHIRT, '--spec', spec]);
    assert.deepEqual([status, stdout], [exit, ''], stderr);
    assert.match(stderr, message);
  }
});
