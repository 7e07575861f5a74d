import path from 'node:path';
import { main, ROOT, step } from '../machine/step.mjs';
import { writePackages } from '../build/package/index.mjs';
import { setUp } from './index.mjs';

// npm run package: all set-up, then the packages that install without a compiler, in out/package.

await main(async () => {
  await setUp({ groups: ['build', 'run'], presets: ['release'] });
  const folder = path.join(ROOT, 'out/package');
  let files;
  await step('Packages', async () => {
    ({ files } = writePackages({ build: path.join(ROOT, 'out/release'), folder }));
    return `${files.length} files`;
  });
  process.stdout.write(`${files.map((file) => path.relative(ROOT, file)).join('\n')}\n`);
  return 0;
});
