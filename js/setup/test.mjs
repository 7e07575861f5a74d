import { readdirSync } from 'node:fs';
import path from 'node:path';
import { setUp } from './index.mjs';
import { main, ROOT, runShown } from '../machine/step.mjs';

// npm test: all set-up, then every test. `node js/setup/test.mjs cpp` or `js [FILE...]` runs one half.

const PRESET = 'dev';
const SUITES = {
  cpp: { title: 'C++ (ctest)', run: () => runShown('ctest', ['--preset', PRESET, '--no-tests=error']) },
  js: { title: 'JavaScript (node --test)', run: runNodeTests },
};

/** All test files under test/, as paths from the root. Node 20 takes no glob here. */
function testFiles() {
  return readdirSync(path.join(ROOT, 'test'), { recursive: true })
    .filter((file) => file.endsWith('.test.mjs'))
    .map((file) => path.join('test', file))
    .sort();
}

function runNodeTests(files) {
  // One file at a time: software GL and Chromium use every core on their own.
  const args = ['--test', '--test-concurrency=1', '--test-reporter=spec', ...(files.length ? files : testFiles())];
  return runShown(process.execPath, args, { env: { TELAR_BUILD_DIR: path.join(ROOT, 'out', PRESET) } });
}

await main(async () => {
  const [only, ...files] = process.argv.slice(2);
  await setUp({ groups: ['build', 'run', 'test'], presets: [PRESET] });
  const lines = [];
  for (const [name, suite] of Object.entries(SUITES)) {
    if (only && only !== name) continue;
    const started = performance.now();
    const status = await suite.run(files);
    lines.push({ status, text: `${suite.title}: ${status === 0 ? 'passed' : `FAILED (exit ${status})`} in ${((performance.now() - started) / 1000).toFixed(0)} s` });
  }
  process.stdout.write(`\n${lines.map((line) => line.text).join('\n')}\n`);
  return lines.some((line) => line.status !== 0) ? 1 : 0;
});
