import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { runLogged, SetupError } from './step.mjs';

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

/**
 * Installs the missing packages of these groups. Asks no question; needs root or sudo.
 * @returns {Promise<string>} What was done, in a few words.
 */
export async function ensureDebianPackages(groups, begin) {
  const names = listedPackages(groups);
  const missing = missingPackages(names);
  if (missing === null) return `this is not Debian; on your own: the equivalents of ${names.join(' ')}`;
  if (missing.length === 0) return `all ${names.length} present`;

  const root = process.getuid() === 0;
  // Without a terminal nobody can type a password: -n makes sudo fail instead of waiting for one.
  const sudo = process.stdin.isTTY ? ['sudo'] : ['sudo', '-n'];
  const cure = `run this, then the same command again:\n    ${aptLine(missing)}`;
  if (!root && !process.stdin.isTTY && spawnSync('sudo', ['-n', 'true']).status !== 0) {
    throw new SetupError(`${missing.length} Debian packages are missing, and there is neither root nor sudo to install them`, { cure });
  }
  begin(`installing ${missing.length} of ${names.length} (${missing.join(' ')})`);
  const options = ['-y', '-q', '-o', 'DPkg::Lock::Timeout=300', '-o', 'Acquire::Retries=3'];
  const apt = (log, ...args) => {
    const line = [...(root ? [] : sudo), 'env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', ...options, ...args];
    return runLogged(line[0], line.slice(1), { log, cure });
  };
  await apt('apt-update.log', 'update');
  await apt('apt-install.log', 'install', '--no-install-recommends', ...missing);
  const still = missingPackages(names);
  if (still.length) throw new SetupError(`apt-get installed without an error, yet these are missing: ${still.join(' ')}`, { cure });
  return 'done';
}
