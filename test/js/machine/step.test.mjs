import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { ROOT, runLogged, runShown, SetupError } from '../../../js/machine/step.mjs';

const node = (code) => [process.execPath, ['-e', code], { log: 'test.log', cure: 'turn it off and on' }];

test('a command that works returns what it printed, on both streams', async () => {
  assert.equal(await runLogged(...node('console.log("out"); console.error("err")')).then((text) => text.split('\n').sort().join()), ',err,out');
});

test('a command that fails tells its errors, its last lines and the cure; the log holds all', async () => {
  const noise = 'for (let i = 0; i < 40; i++) console.log("noise", i);';
  const failing = node(`console.log("x.cpp:1: error: first"); ${noise} process.exitCode = 3`);
  await assert.rejects(runLogged(...failing), (error) => {
    assert.ok(error instanceof SetupError);
    assert.match(error.message, /^node -e ended with 3; all it said is in out\/setup\/test\.log:\n {2}\| x\.cpp:1: error: first\n/);
    assert.match(error.message, /noise 39\n {2}Cure: turn it off and on$/);
    assert.doesNotMatch(error.message, /noise 10\n/);
    return true;
  });
  assert.match(readFileSync(path.join(ROOT, 'out/setup/test.log'), 'utf8'), /noise 10\n/);
});

test('a program that is not there', async () => {
  await assert.rejects(runLogged('telar-no-such-program', [], { log: 'test.log', cure: 'install it' }), {
    message: 'telar-no-such-program: no such program\n  Cure: install it',
    notFound: true,
    exitCode: 6,
  });
});

test('the exit status and the signal of a shown command', async () => {
  assert.equal(await runShown(process.execPath, ['-e', 'process.exit(5)']), 5);
  assert.equal(await runShown(process.execPath, ['-e', 'process.kill(process.pid, "SIGKILL")']), 128 + 9);
});

test('a step is one line', () => {
  const script = `
    import { main, SetupError, step } from ${JSON.stringify(path.join(ROOT, 'js/machine/step.mjs'))};
    await main(async () => {
      await step('A', async () => 'present');
      await step('B', async (begin) => { begin('working'); return 'done'; });
      await step('C', async (begin) => { begin('working'); throw new SetupError('no luck', { cure: 'try again' }); });
    });`;
  const { status, stderr, stdout } = spawnSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8' });
  assert.equal(status, 6);
  assert.equal(stdout, '');
  assert.match(stderr, /^A: present\nB: working \.\.\. done \(\d+\.\d s\)\nC: working \.\.\. failed\ntelar: no luck\n {2}Cure: try again\n$/);
});
