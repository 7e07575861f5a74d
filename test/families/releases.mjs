import { execFile } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync } from 'node:fs';
import path from 'node:path';
import { promisify } from 'node:util';
import { PATCHES } from '../../js/shot/three_terms.mjs';
import { RELEASES_FOLDER } from './places.mjs';

const run = promisify(execFile);

/** First release that is looked at: minor number of 0.MINOR.PATCH, which three.js calls its revision. */
export const FIRST_REVISION = 150;

/** Of the package: what a page loads, and the sources that are read to tell releases apart. */
const PARTS = ['package/package.json', 'package/build', 'package/src', 'package/examples/jsm'];

/** @param {string} version - 0.MINOR.PATCH */
export const revisionOf = (version) => Number(version.split('.')[1]);

/** The version that a release's number means: patches draw alike but where js/shot/three_terms.mjs says otherwise. */
export const versionOf = (revision) => PATCHES[revision] ?? `0.${revision}.0`;

/** Order of releases, oldest first. */
export function compareReleases(a, b) {
  const [left, right] = [a, b].map((version) => version.split('.').map(Number));
  return left[0] - right[0] || left[1] - right[1] || left[2] - right[2];
}

/** Folder of a release that was fetched. */
export const folderOf = (version) => path.join(RELEASES_FOLDER, version);

/**
 * Every release that npm has, oldest first.
 * @returns {Promise<string[]>} Without previews such as 0.150.0-rc.1.
 */
export async function listReleases() {
  const { stdout } = await run('npm', ['view', 'three', 'versions', '--json']);
  return JSON.parse(stdout)
    .filter((version) => /^0\.\d+\.\d+$/.test(version) && revisionOf(version) >= FIRST_REVISION)
    .sort(compareReleases);
}

/** Releases on their way, by version. */
const fetching = new Map();

/**
 * Fetches a release by `npm pack`, which checks its integrity. A release that is there is left as it is.
 * @param {string} version
 * @returns {Promise<string>} Its folder.
 */
export async function fetchRelease(version) {
  if (existsSync(folderOf(version))) return folderOf(version);
  if (!fetching.has(version)) fetching.set(version, fetched(version));
  return fetching.get(version);
}

async function fetched(version) {
  const folder = folderOf(version);
  mkdirSync(RELEASES_FOLDER, { recursive: true });
  const unfinished = mkdtempSync(path.join(RELEASES_FOLDER, 'fetching-'));
  try {
    await run('npm', ['pack', `three@${version}`, '--silent', '--pack-destination', unfinished]);
    await run('tar', ['-xzf', path.join(unfinished, `three-${version}.tgz`), '-C', unfinished, ...PARTS]);
    const { version: found } = JSON.parse(readFileSync(path.join(unfinished, 'package/package.json')));
    if (found !== version) throw new Error(`npm pack three@${version} gave ${found}`);
    // Another process may have fetched it meanwhile.
    if (!existsSync(folder)) renameSync(path.join(unfinished, 'package'), folder);
  } finally {
    rmSync(unfinished, { recursive: true });
  }
  return folder;
}
