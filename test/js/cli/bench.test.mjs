import assert from 'node:assert/strict';
import { appendFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { plantedBench } from '../trade/support.mjs';
import { runFake } from './fake.mjs';

const root = mkdtempSync(path.join(tmpdir(), 'telar-bench-'));
after(() => rmSync(root, { recursive: true }));
let folders = 0;
const freshFolder = () => path.join(root, String(folders++));

const run = (argv, fake = plantedBench()) => runFake(['bench', 'trade', ...argv], { fake, api: fake.api });
const SMALL = ['--cloths', 'denim', '--environments', 'studio', '--sizes', '64', '--window', '32', '--settings', 'draft,standard,tracer 8'];

test('a folder with page, CSV, plot; the tables on stdout', async () => {
  const folder = freshFolder();
  const { exit, stdout, stderr, calls } = await run(['-o', folder, ...SMALL]);
  assert.equal(exit, 0, stderr);
  assert.deepEqual(readdirSync(folder).sort(), ['index.html', 'measured.jsonl', 'trade.csv', 'trade.svg', 'truth']);
  const lines = readFileSync(path.join(folder, 'trade.csv'), 'utf8').trim().split('\n');
  assert.equal(lines.length, 4);
  const flips = lines.slice(1).map((line) => Number(line.split(',')[6]));
  assert.ok(flips[0] > flips[1] && flips[1] > flips[2], String(flips));
  assert.match(stdout, /^setting +FLIP, median/);
  assert.equal(calls.closed, 1);
  const seeds = calls.rendered.filter(({ shot }) => shot.quality.preset === 'reference').map(({ shot }) => shot.quality.seed);
  assert.ok(seeds.includes(1) && seeds.includes(2), 'truth and tracer take different paths');
});

test('a run goes on where another stopped, a cut line is measured again', async () => {
  const folder = freshFolder();
  const stopped = plantedBench({
    fail: (count) => {
      if (count === 6) throw new Error('stopped');
    },
  });
  assert.notEqual((await run(['-o', folder, ...SMALL], stopped)).exit, 0);
  const truths = readdirSync(path.join(folder, 'truth'));
  assert.equal(truths.length, 1);
  const { calls } = await run(['-o', folder, ...SMALL]);
  const truth = ({ shot }) => shot.quality.seed === 2;
  assert.equal(calls.rendered.filter(truth).length, 0, 'the truth is kept');
  const again = await run(['-o', folder, ...SMALL]);
  assert.equal(again.calls.rendered.length, 1, 'nothing but the look for the window');
  appendFileSync(path.join(folder, 'measured.jsonl'), '{"key":"cut');
  const cut = await run(['-o', folder, ...SMALL, '--setting', 'own={"samples":16}', '--json']);
  const { rows } = JSON.parse(cut.stdout);
  assert.deepEqual(
    rows.map(({ setting }) => setting),
    ['draft', 'standard', 'tracer 8', 'own'],
  );
});

test('scenes that differ stay apart: releases of three.js, models and environments of one name', async () => {
  const folder = freshFolder();
  for (const name of ['a', 'b']) {
    mkdirSync(path.join(folder, name), { recursive: true });
    for (const file of ['shirt.glb', 'sky.hdr']) writeFileSync(path.join(folder, name, file), '');
  }
  const [models, skies] = ['shirt.glb', 'sky.hdr'].map((file) => ['a', 'b'].map((name) => path.join(folder, name, file)));
  const argv = [...models, '--environments', skies.join(','), '--shadings', 'three@180,three@170,fabric', '--sizes', '64', '--window', '32'];
  const { stdout, stderr, exit } = await run(['-o', path.join(folder, 'out'), ...argv, '--settings', 'draft', '--json']);
  assert.equal(exit, 0, stderr);
  const { rows, tables } = JSON.parse(stdout);
  const scenes = ['shirt 1', 'shirt 2'].flatMap((model) =>
    ['sky 1', 'sky 2'].flatMap((light) => ['three@180', 'three@170', 'fabric'].map((shading) => `${model}, ${light}, ${shading}, 64`)),
  );
  assert.deepEqual(
    tables.cheapest.lines.map(([name]) => name),
    scenes,
  );
  // What is predicted goes by the base.
  assert.deepEqual([...new Set(rows.map(({ features }) => features.shading))], ['three', 'fabric']);
  const one = await run(['-o', path.join(folder, 'out'), models[0], ...argv.slice(2), '--settings', 'draft', '--json']);
  assert.deepEqual([...new Set(JSON.parse(one.stdout).rows.map(({ model }) => model))], ['shirt'], 'named as this run names it');
  assert.equal(one.calls.rendered.length, 6, 'and not measured again');
});

test('times are those of the machine: another one measures again by the same truth', async () => {
  const folder = freshFolder();
  await run(['-o', folder, ...SMALL]);
  const { calls } = await run(['-o', folder, ...SMALL], plantedBench({ gl: 'another' }));
  assert.ok(calls.rendered.length > 3, String(calls.rendered.length));
  assert.equal(calls.rendered.filter(({ shot }) => shot.quality.seed === 2).length, 0);
  assert.equal((await run(['-o', folder, ...SMALL])).calls.rendered.length, 1);
  assert.match(readFileSync(path.join(folder, 'index.html'), 'utf8'), / on .*, \d+ cores?, planted\./);
});

test('--limit reaches the plans of scenes too', async () => {
  const { exit, calls } = await run(['-o', freshFolder(), ...SMALL, '--limit', 'L_TRIANGLES=9000000']);
  assert.equal(exit, 0);
  assert.deepEqual(
    calls.inspected.map(({ limits }) => limits),
    [{ L_TRIANGLES: 9_000_000 }],
  );
});

test('a folder that cannot be written is X_OUTPUT, one of an earlier run that cannot be read E_FILE', async () => {
  const folder = freshFolder();
  mkdirSync(path.join(folder, 'read/measured.jsonl'), { recursive: true });
  writeFileSync(path.join(folder, 'file'), '');
  for (const [output, exit, text] of [
    [path.join(folder, 'file/out'), 6, /cannot be written \((EEXIST|ENOTDIR)\); a file stands where its folder is to be.* \[X_OUTPUT\]/],
    ['/proc/telar', 6, /cannot be written \(ENOENT\); its folder does not exist and cannot be made.* \[X_OUTPUT\]/],
    [path.join(folder, 'read'), 3, /measured\.jsonl" of an earlier run cannot be read \(EISDIR\).* \[E_FILE\]/],
  ]) {
    const found = await run(['-o', output, ...SMALL]);
    assert.deepEqual([found.exit, found.calls.loaded.length], [exit, 0], found.stderr);
    assert.match(found.stderr, text);
  }
});

test('--knobs: each alone, then the steepest together; shadows only where a lamp casts them', async () => {
  const { exit, stdout, stderr } = await run(['-o', freshFolder(), '--knobs', ...SMALL.slice(0, -2), '--json']);
  assert.equal(exit, 0, stderr);
  const { rows, tables } = JSON.parse(stdout);
  const names = rows.map(({ setting }) => setting);
  assert.ok(names.includes('standard') && names.includes('environmentSamples 16') && !names.some((name) => name.startsWith('shadow')), String(names));
  // All but `standard` by each truth, with which the others are compared.
  assert.equal(tables.knobs.lines.length, names.length - 2);
  const lit = JSON.parse((await run(['-o', freshFolder(), '--knobs', ...SMALL.slice(0, -2), '--environments', 'sun', '--json'])).stdout);
  assert.ok(lit.rows.some(({ setting }) => setting === 'shadow.mapSize 512'));
  const { exit: refused, stderr: why } = await run(['-o', freshFolder(), '--knobs', ...SMALL]);
  assert.deepEqual([refused, why.includes('leave --settings out')], [2, true]);
});

test('wrong options are told before anything is opened', async () => {
  const folder = freshFolder();
  const told = async (...argv) => {
    const fake = plantedBench();
    const { exit, stderr } = await run(['-o', folder, ...argv], fake);
    assert.equal(fake.calls.loaded.length, 0);
    return [exit, stderr];
  };
  for (const [argv, text] of [
    [['--settings', 'fast'], /--settings: there is no setting "fast"; expected some of draft, /],
    [['--setting', 'a={"samples":3}'], /--setting .*expected NAME=JSON of a quality \(shot.quality.samples: expected 1, 4/],
    [['--sizes', '2'], /--sizes: expected a whole number in \[16, 8192\], got "2"/],
    [['--environments', 'studoi'], /--environments: .*did you mean studio\?/],
    [['--cap', 'x'], /--cap: expected a whole number/],
    [['--cloths', 'denmi'], /denim/],
  ]) {
    const [exit, stderr] = await told(...argv);
    assert.match(stderr, text);
    assert.ok(exit === 2 || exit === 3, String(exit));
  }
});
