import { createWriteStream } from 'node:fs';
import { run } from 'node:test';
import { spec } from 'node:test/reporters';
import skipped from './skipped_reporter.mjs';

// node run_tests.mjs '{"files", "concurrency", "timeout", "log"}': files of tests in the order that is given. `node --test` sorts them by name.

const { log, ...options } = JSON.parse(process.argv[2]);
const tests = run(options);
tests.on('test:fail', ({ todo }) => {
  if (todo === undefined || todo === false) process.exitCode = 1;
});
tests.compose(skipped).pipe(createWriteStream(log));
tests.compose(new spec()).pipe(process.stdout);
