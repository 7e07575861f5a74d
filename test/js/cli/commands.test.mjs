import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { runFake } from './fake.mjs';

const schema = JSON.parse(readFileSync(new URL('../../../js/shot/schema.json', import.meta.url), 'utf8'));
const { version } = JSON.parse(readFileSync(new URL('../../../package.json', import.meta.url), 'utf8'));

test('help comes from the schema and costs no error', async () => {
  const { exit, stdout, stderr } = await runFake(['thumbnail', '--help']);
  assert.deepEqual([exit, stderr], [0, '']);
  const text = stdout.replaceAll(/\s+/g, ' ');
  assert.ok(text.includes(schema.properties.variant.description));
  assert.ok(text.includes(schema.properties.background.description));
  assert.match((await runFake(['--help'])).stdout, /Exit codes: 0 done, 1 over the gate, 2 usage/);
  assert.equal((await runFake(['--version'])).stdout, `${version}\n`);
});

test('inspect prints facts, features, passes and sizes', async () => {
  const { exit, stdout, stderr } = await runFake(['inspect', 'warn.glb']);
  assert.equal(exit, 0);
  assert.match(stdout, /^size +2 m x 2 m x 2 m/m);
  assert.match(stdout, /^geometry +12 triangles/m);
  assert.match(stdout, /^variants +navy$/m);
  assert.match(stdout, /^features +normalMap$/m);
  assert.match(stdout, /^passes +opaque$/m);
  assert.match(stderr, /W_RANGE/);
});

test('inspect plans for the shot that is given', async () => {
  const { calls } = await runFake(['inspect', '-', '--background', 'environment', '--limit', 'L_NODES=5'], { stdin: 'bytes' });
  const [{ source, options }] = calls.inspected;
  assert.equal(source.toString(), 'bytes');
  assert.deepEqual([options.shot, options.limits], [{ background: 'environment' }, { L_NODES: 5 }]);
});

test('inspect --json: facts, or the error', async () => {
  const good = await runFake(['inspect', 'm.glb', '--json']);
  const facts = JSON.parse(good.stdout);
  assert.deepEqual([facts.ok, facts.model, facts.plan.features], [true, 'm.glb', ['normalMap']]);
  const bad = await runFake(['inspect', 'E_INDEX.glb', '--json']);
  assert.equal(bad.exit, 3);
  assert.equal(JSON.parse(bad.stdout).error.code, 'E_INDEX');
});

test('doctor names backends, the choice and the cure', async () => {
  const { exit, stdout } = await runFake(['doctor']);
  assert.equal(exit, 0);
  assert.match(stdout, /egl-device: no: no libEGL\n +cure: apt-get install libegl1/);
  assert.match(stdout, /osmesa: llvmpipe, OpenGL ES 3\.2, in software/);
  assert.match(stdout, /^chosen +osmesa: first$/m);
  assert.match(stdout, /^reference +Embree 3$/m);
  assert.match(stdout, /^image files +PNG, JPEG and WebP alone: no OpenImageIO$/m);
  assert.equal(JSON.parse((await runFake(['doctor', '--json'])).stdout).chosen, 'osmesa');
});

test('doctor fails where nothing can draw', async () => {
  const api = {
    doctor: async () => ({
      ok: false,
      versions: {},
      system: 'x',
      native: { error: { message: 'not built' } },
      chosen: null,
      reason: 'not built',
      backends: [],
      reference: { works: false, failure: 'not built' },
      imageFiles: { works: false, failure: 'not built' },
    }),
  };
  const { exit, stdout } = await runFake(['doctor'], { api });
  assert.equal(exit, 6);
  assert.match(stdout, /^chosen +none: not built$/m);
});

test('a fault of ours is internal', async () => {
  const api = {
    doctor: async () => {
      throw new TypeError('x is not a function');
    },
  };
  const { exit, stdout } = await runFake(['doctor', '--json'], { api });
  assert.equal(exit, 7);
  assert.equal(JSON.parse(stdout).error.code, 'X_INTERNAL');
});

test('a reader that has seen enough of the help is no fault', () => {
  const bin = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
  const program = `(sleep 0.3; '${process.execPath}' '${bin}' thumbnail --help; echo $? >&2) | true`;
  assert.equal(spawnSync('sh', ['-c', program], { encoding: 'utf8' }).stderr, '0\n');
});

test('the program itself answers --version, and a usage error ends with 2', () => {
  const bin = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
  assert.equal(execFileSync(process.execPath, [bin, '--version'], { encoding: 'utf8' }), `${version}\n`);
  const { status, stdout } = spawnSync(process.execPath, [bin, 'thumbnail', '--json'], { encoding: 'utf8' });
  assert.deepEqual([status, JSON.parse(stdout).error.code], [2, 'E_USAGE']);
});
