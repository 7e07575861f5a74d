import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

const LIST = new URL('./debian_packages.txt', import.meta.url);

/**
 * @param {string[]} groups - Of `build`, `run`, `test`.
 * @returns {string[]} Package names, in the list's order.
 */
export function listedPackages(groups, text = readFileSync(LIST, 'utf8')) {
  return text
    .split('\n')
    .filter((line) => line.trim() && !line.startsWith('#'))
    .map((line) => line.split(/\s+/, 2))
    .filter(([, group]) => groups.includes(group))
    .map(([name]) => name);
}

/**
 * @param {string[]} names
 * @returns {string[] | null} Those that are not installed; null where there is no dpkg to ask.
 */
export function missingPackages(names) {
  const query = spawnSync('dpkg-query', ['-W', '-f=${Package} ${db:Status-Status}\n', ...names], { encoding: 'utf8' });
  if (query.error) return null;
  const installed = new Set(
    query.stdout
      .split('\n')
      .filter((line) => line.endsWith(' installed'))
      .map((line) => line.split(' ')[0]),
  );
  return names.filter((name) => !installed.has(name));
}

/** The line that a user pastes into a shell. */
export function aptLine(names) {
  return `sudo apt-get update && sudo apt-get install -y --no-install-recommends ${names.join(' ')}`;
}

/** What to tell when a program of the build is not there: the apt line of what is missing. */
export function buildCure() {
  const names = listedPackages(['build', 'run']);
  const missing = missingPackages(names);
  if (missing === null) return `install what Debian 12 calls: ${names.join(' ')}`;
  return missing.length ? aptLine(missing) : '';
}
