import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { ROOT, runLogged } from '../machine/step.mjs';

/**
 * Whether node_modules holds what the lock file names: npm writes a lock file of what it installed beside the packages,
 * and a package is right when its version and integrity are the same in both and its folder is there.
 * Optional packages (other platforms' binaries) may be absent.
 */
export function npmPackagesPresent(root = ROOT) {
  const installedFile = path.join(root, 'node_modules', '.package-lock.json');
  if (!existsSync(installedFile)) return false;
  const wanted = JSON.parse(readFileSync(path.join(root, 'package-lock.json'), 'utf8')).packages;
  const installed = JSON.parse(readFileSync(installedFile, 'utf8')).packages;
  return Object.entries(wanted).every(([folder, entry]) => {
    if (folder === '' || (entry.optional && !installed[folder])) return true;
    const found = installed[folder];
    return found?.version === entry.version && found.integrity === entry.integrity && existsSync(path.join(root, folder, 'package.json'));
  });
}

/**
 * Installs exactly what package-lock.json names, unless it is there.
 * Install scripts stay off: the build is the next step, and no package we use needs one.
 * @returns {Promise<string>} What was done, in a few words.
 */
export async function ensureNpmPackages(begin) {
  if (npmPackagesPresent()) return 'present';
  begin('npm ci');
  return installPackages([], 'npm-ci.log');
}

/**
 * npm ci, without scripts.
 * @param {string[]} options - Further ones
 * @param {string} log - File name in out/setup
 * @returns {Promise<string>}
 * @throws {SetupError}
 */
export async function installPackages(options, log) {
  const npm = process.env.npm_execpath ? [process.execPath, process.env.npm_execpath] : ['npm'];
  const args = ['ci', '--include=dev', '--ignore-scripts', '--no-audit', '--no-fund', '--no-progress', ...options];
  await runLogged(npm[0], [...npm.slice(1), ...args], { log, cure: 'see that this machine reaches an npm registry (npm ping), then the same command again' });
  return 'done';
}
