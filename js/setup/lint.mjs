import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { main, ROOT, runShown, step } from '../machine/step.mjs';
import { ensureDebianPackages } from './debian.mjs';
import { ensureNpmPackages } from './npm_packages.mjs';
import { baseCommit, changedSince, gitIn, sourcesToTidy } from './tidied.mjs';

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

/** Holds the commit that was clean last. */
const CLEAN = path.join(ROOT, BUILD, 'tidy/clean');

/** Leaves clang-tidy out, as TELAR_LINT_BASE: for a copy without history. */
const NO_BASE = 'none';

/** Sources and headers of C++ by path. */
const cppTexts = () =>
  new Map(
    ['addon', 'renderer'].flatMap((folder) =>
      readdirSync(path.join(ROOT, folder), { recursive: true })
        .filter((file) => /\.(h|cpp|inl)$/.test(file))
        .map((file) => [`${folder}/${file}`, readFileSync(path.join(ROOT, folder, file), 'utf8')]),
    ),
  );

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
    .map((entry) => ({ ...entry, command: entry.command.replace(/ -Winvalid-pch| --param=\S+| -include \S*cmake_pch\.hxx/g, '') }));
  writeFileSync(path.join(folder, 'compile_commands.json'), JSON.stringify(plain));
  return folder;
}

/**
 * What cannot be checked fails: a check that leaves itself out would pass for ever.
 * @param {(command: string, args: string[]) => Promise<number>} run
 * @param {{git?: ReturnType<typeof gitIn>, named?: string}} [how]
 * @returns {Promise<[number, string]>} Exit status, and the closing words.
 */
export async function tidy(run, { git = gitIn(ROOT), named = process.env.TELAR_LINT_BASE } = {}) {
  if (named === NO_BASE) return [0, `left out, as TELAR_LINT_BASE is ${NO_BASE}`];
  const base = baseCommit(git, { named, clean: existsSync(CLEAN) ? readFileSync(CLEAN, 'utf8') : undefined });
  if (!base)
    return [
      1,
      `${named ? `no commit ${named}` : 'no commit'} to compare with: fetch the history, or name a commit by TELAR_LINT_BASE (${NO_BASE} = leave this out)`,
    ];
  const since = `since ${base.slice(0, 9)}`;
  const { sources, headers, more } = sourcesToTidy(changedSince(git, base), cppTexts());
  if (sources.length === 0) return [0, `nothing changed ${since}`];
  if (!existsSync(path.join(ROOT, BUILD, 'compile_commands.json'))) return [1, `nothing is built in ${BUILD}: npm run build:dev`];
  const head = git('rev-parse', 'HEAD');
  const status = await run('run-clang-tidy', ['-quiet', '-p', commandsForTidy(), ...sources.map((file) => `/${file}$`)]);
  if (status !== 0) return [status, 'see above'];
  writeFileSync(CLEAN, head);
  const beside = headers > 0 ? `, for ${headers} headers too, which ${more} more include` : '';
  return [0, `clean (${sources.length} sources ${since}${beside})`];
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
