import { execFileSync } from 'node:child_process';
import path from 'node:path';

// What clang-tidy reads: the C++ that changed since a commit.

/** Sources that are read for one header that changed: its own, then the nearest of those that include it. The first ones read what the others would of it. */
const MOST_OF_A_HEADER = 3;

/** Sources that are read for headers alone: ten seconds each. The first of every header come before the second of any. */
const MOST_FOR_HEADERS = 24;

/** brdf/ is left out: it makes aggregates by parentheses (P0960), which clang 14 does not parse. What includes its headers is read. */
const SOURCE = /^(addon|renderer)\/(?!brdf\/).*\.cpp$/;
const HEADER = /^(addon|renderer)\/.*\.(h|inl)$/;

/** @returns {(...args: string[]) => string | undefined} runs git in a folder: what it says; undefined where it fails or is not there */
export const gitIn = (cwd) => {
  const run = (...args) => {
    try {
      return execFileSync('git', args, { cwd, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim();
    } catch {
      return undefined;
    }
  };
  return run;
};

/**
 * The commit that what is here is compared with: the one that is named (CI names what main was before a push), else where the branch left main, on main itself
 * the one that was clean here last, else the commit before.
 * @param {(...args: string[]) => string | undefined} git
 * @param {{named?: string, clean?: string}} known clean: the commit that was clean here last
 * @returns {string | undefined} undefined where there is none
 */
export function baseCommit(git, { named, clean }) {
  if (named) return git('rev-parse', '--verify', '--quiet', `${named}^{commit}`);
  const head = git('rev-parse', 'HEAD');
  const left = git('merge-base', 'HEAD', 'origin/main') ?? git('merge-base', 'HEAD', 'main');
  if (left && left !== head) return left;
  return (clean && git('merge-base', clean, 'HEAD')) || git('rev-parse', '--verify', '--quiet', 'HEAD~1');
}

/** Files that differ from a commit, committed or not; one that only moved is none. @returns {string[]} */
export const changedSince = (git, base) =>
  `${git('diff', '--name-only', '-M100%', '--diff-filter=dr', base)}\n${git('ls-files', '--others', '--exclude-standard')}`.split('\n');

/** Where a quoted #include leads: beside the file, under renderer/include, renderer/ or addon/. */
const includedFile = (file, name, texts) =>
  [path.posix.join(path.posix.dirname(file), name), `renderer/include/${name}`, `renderer/${name}`, `addon/${name}`].find((candidate) => texts.has(candidate));

/** header: files that include it. @param {Map<string, string>} texts path to text */
function includersOf(texts) {
  const includers = new Map();
  for (const [file, text] of texts) {
    for (const [, name] of text.matchAll(/^\s*#\s*include\s*"([^"]+)"/gm)) {
      const header = includedFile(file, name, texts);
      if (header) includers.set(header, [...(includers.get(header) ?? []), file]);
    }
  }
  return includers;
}

/** Sources that include a header, by however many others, the nearest first; before all the one of its name. */
function sourcesWith(header, includers) {
  const found = new Set([header]);
  for (const file of found) for (const includer of (includers.get(file) ?? []).toSorted()) found.add(includer);
  const sources = [...found].filter((file) => SOURCE.test(file));
  const isOwn = (file) => path.posix.basename(file, '.cpp') === path.posix.basename(header).replace(/\.\w+$/, '');
  return [...sources.filter(isOwn), ...sources.filter((file) => !isOwn(file))];
}

/**
 * @param {string[]} changed files
 * @param {Map<string, string>} texts sources and headers of C++: path to text
 * @returns {{sources: string[], headers: number, more: number}} sources that are read; headers that changed, and sources beside them that include one
 */
export function sourcesToTidy(changed, texts) {
  const includers = includersOf(texts);
  const headers = changed.filter((file) => HEADER.test(file) && texts.has(file));
  const sources = new Set(changed.filter((file) => SOURCE.test(file)));
  const users = headers.map((header) => sourcesWith(header, includers));
  const most = sources.size + MOST_FOR_HEADERS;
  for (let rank = 0; rank < MOST_OF_A_HEADER; rank++) for (const list of users) if (list[rank] && sources.size < most) sources.add(list[rank]);
  const more = new Set(users.flat().filter((source) => !sources.has(source)));
  return { sources: [...sources], headers: headers.length, more: more.size };
}
