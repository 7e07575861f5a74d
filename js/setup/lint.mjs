import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { ensureDebianPackages } from './debian.mjs';
import { ensureNpmPackages } from './npm_packages.mjs';
import { main, ROOT, runShown, step } from '../machine/step.mjs';

// npm run lint: clang-format over C++, biome over JavaScript, clang-tidy over the C++ that changed since the branch left
// main (all of it would take many minutes). `npm run format` (--fix) writes what clang-format wants.

/** Holds the commands that clang-tidy parses with. */
const BUILD = 'out/dev';

const cppFiles = ['addon', 'renderer', 'test'].flatMap((folder) =>
  readdirSync(path.join(ROOT, folder), { recursive: true })
    .filter((file) => /\.(h|cpp)$/.test(file))
    .map((file) => path.join(folder, file)),
);

const git = (...args) => execFileSync('git', args, { cwd: ROOT, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim();

/** First of several git commands that answers. */
function firstOf(...commands) {
  for (const command of commands) {
    try {
      return git(...command);
    } catch {
      // No such branch, no parent, or no git: the next one.
    }
  }
  return undefined;
}

/** Sources of the product that differ from main, or on main itself from the commit before; committed or not. Less brdf/,
 * whose aggregates in parentheses clang 14 does not parse. */
function changedSources() {
  const head = firstOf(['rev-parse', 'HEAD']);
  const left = firstOf(['merge-base', 'HEAD', 'origin/main'], ['merge-base', 'HEAD', 'main']);
  const base = left && left !== head ? left : firstOf(['rev-parse', 'HEAD~1']);
  if (!base) return [];
  const files = `${git('diff', '--name-only', '--diff-filter=d', base)}\n${git('ls-files', '--others', '--exclude-standard')}`;
  return files.split('\n').filter((file) => /^(addon|renderer)\/(?!brdf\/).*\.cpp$/.test(file));
}

/** @returns {Promise<[number, string]>} Exit status, and the closing line. */
async function tidy() {
  if (!existsSync(path.join(ROOT, BUILD, 'compile_commands.json'))) return [0, `left out, as nothing is built in ${BUILD}; npm run build:dev`];
  const files = changedSources();
  if (files.length === 0) return [0, 'no source changed'];
  const status = await runShown('run-clang-tidy', ['-quiet', '-p', BUILD, ...files.map((file) => `/${file}$`)]);
  return [status, status === 0 ? `clean (${files.length} changed)` : 'see above'];
}

await main(async () => {
  await step('Debian packages', (begin) => ensureDebianPackages(['lint'], begin));
  await step('npm packages', ensureNpmPackages);
  const fix = process.argv.includes('--fix');
  const format = await runShown('clang-format', [...(fix ? ['-i'] : ['--dry-run', '-Werror']), ...cppFiles]);
  const lint = await runShown(process.execPath, ['node_modules/@biomejs/biome/bin/biome', 'lint', '--error-on-warnings']);
  const [tidied, tidyText] = await tidy();
  process.stdout.write(`clang-format: ${format === 0 ? 'clean' : 'see above; npm run format'}\nbiome: ${lint === 0 ? 'clean' : 'see above'}\nclang-tidy: ${tidyText}\n`);
  return format || lint || tidied ? 1 : 0;
});
