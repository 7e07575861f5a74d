import { copyFileSync, mkdirSync } from 'node:fs';
import path from 'node:path';
import { main, ROOT, runShown, step } from '../machine/step.mjs';
import { installPackages, npmPackagesPresent } from './npm_packages.mjs';

// npm run site: the documentation as a site, in out/site; a link that leads nowhere ends it. What makes it (VitePress, TypeDoc: 150 MB) is installed
// by its own lock file into out/site-tools, so that `npm ci` and the tests do without.

const TOOLS = path.join(ROOT, 'out/site-tools');

await main(async () => {
  mkdirSync(TOOLS, { recursive: true });
  for (const file of ['package.json', 'package-lock.json']) copyFileSync(path.join(ROOT, 'js/build/site', file), path.join(TOOLS, file));
  await step('VitePress and TypeDoc', async (begin) => {
    if (npmPackagesPresent(TOOLS)) return 'present';
    begin('npm ci');
    return installPackages(['--prefix', TOOLS], 'npm-ci-site.log');
  });
  return runShown(process.execPath, [path.join(ROOT, 'js/build/site/make.mjs'), TOOLS]);
});
