import path from 'node:path';
import { main, ROOT, step } from '../machine/step.mjs';
import { writePackages, writeSbom } from '../build/package/index.mjs';
import { setUp } from './index.mjs';

// npm run package: all set-up, then the packages that install without a compiler and their bill of materials, in out/package.
// npm run sbom: the bill alone.

const JOBS = { packages: ['Packages', writePackages], sbom: ['Bill of materials', writeSbom] };

await main(async () => {
  await setUp({ groups: ['build', 'run'], presets: ['release'] });
  const folder = path.join(ROOT, 'out/package');
  const [title, write] = JOBS[process.argv[2] ?? 'packages'];
  let files;
  await step(title, async () => {
    ({ files } = write({ build: path.join(ROOT, 'out/release'), folder }));
    return `${files.length} ${files.length === 1 ? 'file' : 'files'}`;
  });
  process.stdout.write(`${files.map((file) => path.relative(ROOT, file)).join('\n')}\n`);
  return 0;
});
