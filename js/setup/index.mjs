import { fileURLToPath } from 'node:url';
import { ensureBuild } from '../build/addon.mjs';
import { ensureBundles } from './bundles.mjs';
import { ensureDebianPackages } from './debian.mjs';
import { ensureNpmPackages } from './npm_packages.mjs';
import { main, step } from '../machine/step.mjs';

/**
 * Everything between a clean clone and a run; each step does nothing when it is done already.
 * @param {{groups: string[], presets: string[], targets?: string[]}} what - Package groups of debian_packages.txt; presets of CMakePresets.json, and what is built of
 *   them, all where it is left out.
 */
export async function setUp({ groups, presets, targets }) {
  await step('Debian packages', (begin) => ensureDebianPackages(groups, begin));
  await step('npm packages', ensureNpmPackages);
  await step('CommonJS bundles', ensureBundles);
  for (const preset of presets) await step(`Build (${preset})`, (begin) => ensureBuild(preset, begin, { targets }));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    await setUp({ groups: ['build', 'run'], presets: ['release'] });
    return 0;
  });
}
