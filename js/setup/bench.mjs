import { readdirSync } from 'node:fs';
import path from 'node:path';
import { setUp } from './index.mjs';
import { main, ROOT, runShown } from '../machine/step.mjs';

// npm run bench [-- NAME...]: every benchmark of test/bench, or those whose names are given, one after the other.

await main(async () => {
  await setUp({ groups: ['build', 'run', 'test'], presets: ['dev', 'release'] });
  const names = process.argv.slice(2);
  const files = readdirSync(path.join(ROOT, 'test/bench'))
    .filter((file) => file.endsWith('.mjs'))
    .sort();
  let worst = 0;
  for (const file of files.filter((name) => names.length === 0 || names.includes(path.basename(name, '.mjs')))) {
    process.stdout.write(`\n== ${file}\n`);
    worst = Math.max(worst, await runShown(process.execPath, [path.join('test/bench', file)]));
  }
  return worst;
});
