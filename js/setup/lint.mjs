import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { main, ROOT, runShown, step } from '../machine/step.mjs';
import { ensureDebianPackages } from './debian.mjs';
import { ensureNpmPackages } from './npm_packages.mjs';

// npm run lint: clang-format over C++, biome over JavaScript, clang-tidy over the C++ that changed (all of it would take an hour).
// `npm run format` (--fix) writes what clang-format and biome want. `npm test` lints too.

/** Holds the commands that clang-tidy parses with. */
const BUILD = 'out/dev';

const cppFiles = () =>
  ['addon', 'renderer', 'test'].flatMap((folder) =>
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

/**
 * The commit that what is here is compared with: the one that TELAR_LINT_BASE names (CI sets it to what main was before a push), else
 * where the branch left main, on main itself the commit before.
 * @returns {string | undefined} undefined without git or history
 */
function baseCommit() {
  const { TELAR_LINT_BASE } = process.env;
  if (TELAR_LINT_BASE) return git('rev-parse', '--verify', `${TELAR_LINT_BASE}^{commit}`);
  const head = firstOf(['rev-parse', 'HEAD']);
  const left = firstOf(['merge-base', 'HEAD', 'origin/main'], ['merge-base', 'HEAD', 'main']);
  return left && left !== head ? left : firstOf(['rev-parse', '--verify', '--quiet', 'HEAD~1']);
}

/** Sources of the product that differ from a commit, committed or not; a file that only moved is none. Less brdf/, whose aggregates in
 * parentheses clang 14 does not parse. */
function changedSources(base) {
  const files = `${git('diff', '--name-only', '-M100%', '--diff-filter=dr', base)}\n${git('ls-files', '--others', '--exclude-standard')}`;
  return files.split('\n').filter((file) => /^(addon|renderer)\/(?!brdf\/).*\.cpp$/.test(file));
}

/** A command that compiles several sources as one, as one command a source. */
function commandsOfSources(entry) {
  if (!/\/unity_\d+_cxx\.cxx$/.test(entry.file)) return [entry];
  const sources = [...readFileSync(entry.file, 'utf8').matchAll(/^#include "(.+)"$/gm)];
  return sources.map(([, file]) => ({ ...entry, file, command: entry.command.replaceAll(entry.file, file) }));
}

/** Writes the build's commands, each source by itself and less precompiled headers, so that a source that leaves out an #include is
 * found. @returns {string} Folder */
function commandsForTidy() {
  const commands = JSON.parse(readFileSync(path.join(ROOT, BUILD, 'compile_commands.json'), 'utf8'));
  const folder = path.join(ROOT, BUILD, 'tidy');
  mkdirSync(folder, { recursive: true });
  const plain = commands
    .flatMap(commandsOfSources)
    .map((entry) => ({ ...entry, command: entry.command.replace(/ -Winvalid-pch| -include \S*cmake_pch\.hxx/g, '') }));
  writeFileSync(path.join(folder, 'compile_commands.json'), JSON.stringify(plain));
  return folder;
}

/** @returns {Promise<[number, string]>} Exit status, and the closing words. */
async function tidy(run) {
  if (!existsSync(path.join(ROOT, BUILD, 'compile_commands.json'))) return [0, `left out, as nothing is built in ${BUILD}; npm run build:dev`];
  const base = baseCommit();
  if (!base) return [0, 'left out: no commit to compare with'];
  const files = changedSources(base);
  if (files.length === 0) return [0, `no source changed since ${base.slice(0, 9)}`];
  const status = await run('run-clang-tidy', ['-quiet', '-p', commandsForTidy(), ...files.map((file) => `/${file}$`)]);
  return [status, status === 0 ? `clean (${files.length} changed since ${base.slice(0, 9)})` : 'see above'];
}

/**
 * @param {(command: string, args: string[]) => Promise<number>} run - Resolves to the exit status.
 * @param {{fix?: boolean}} [options] fix: write what clang-format and biome want
 * @returns {Promise<{status: number, lines: string[]}>} `lines`: what came of each tool
 */
export async function lint(run, { fix = false } = {}) {
  const format = await run('clang-format', [...(fix ? ['-i'] : ['--dry-run', '-Werror']), ...cppFiles()]);
  const biome = await run(process.execPath, ['node_modules/@biomejs/biome/bin/biome', 'check', ...(fix ? ['--write'] : []), '--error-on-warnings']);
  const [tidied, tidyText] = await tidy(run);
  return {
    status: format || biome || tidied ? 1 : 0,
    lines: [
      `clang-format: ${format === 0 ? 'clean' : 'see above; npm run format'}`,
      `biome: ${biome === 0 ? 'clean' : 'see above; npm run format'}`,
      `clang-tidy: ${tidyText}`,
    ],
  };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  await main(async () => {
    await step('Debian packages', (begin) => ensureDebianPackages(['lint'], begin));
    await step('npm packages', ensureNpmPackages);
    const { status, lines } = await lint(runShown, { fix: process.argv.includes('--fix') });
    process.stdout.write(`${lines.join('\n')}\n`);
    return status;
  });
}
