import { rmSync } from 'node:fs';
import { mkdir, open, readdir, realpath, rename, rm, stat } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { isAlive } from './is_alive.mjs';

/** Output files are written whole or not at all: a temporary file in the same folder, fsync, rename. */

const TEMPORARY = /^\..+\.telar-(\d+)-[0-9a-f]{12}\.tmp$/;
const STALE_MS = 3_600_000;

const NO_FOLDER = 'a file stands where its folder is to be: name another folder, or move that file away';
const DENIED = 'you may not write there: name another folder, or change its permissions';

/** What to do about a failure, by its code. */
const CURES = {
  EEXIST: NO_FOLDER,
  ENOTDIR: NO_FOLDER,
  ENOENT: 'its folder does not exist and cannot be made: name another one',
  EACCES: DENIED,
  EPERM: DENIED,
  EROFS: 'that disk is read-only: name a folder on another one',
  EISDIR: 'it is a folder: name a file in it',
  ENOSPC: 'the disk is full: free some space',
  EDQUOT: 'your share of the disk is full: free some space',
  ENAMETOOLONG: 'the name is too long: shorten it',
};

/** Temporary files of this process that are not renamed yet. */
const unfinished = new Set();

/** Removes the temporary files of this process: for a signal that leaves no time to wait. */
export function removeUnfinished() {
  for (const file of unfinished) rmSync(file, { force: true });
}

/**
 * @param {string} file replaced when it exists; a device or a pipe is written to instead
 * @param {Uint8Array} data
 * @param {AbortSignal} [signal] nothing is left behind when it aborts before the rename
 * @throws {TelarError} X_OUTPUT; the signal's reason
 */
export async function writeFileAtomically(file, data, signal) {
  try {
    await makeFolder(path.dirname(path.resolve(file)));
    const target = await realpath(file).catch(() => file);
    const found = await stat(target).catch(() => undefined);
    if (found && !found.isFile() && !found.isDirectory()) await writeInPlace(target, data);
    else await replace(target, data, signal);
  } catch (cause) {
    if (signal?.aborted && cause === signal.reason) throw cause;
    throw unwritable(file, cause);
  }
}

/** What to tell of a file that cannot be written. @returns {TelarError} X_OUTPUT */
export function unwritable(file, cause) {
  const cure = Object.hasOwn(CURES, cause.code) ? `; ${CURES[cause.code]}` : '';
  return new TelarError('X_OUTPUT', `${shown(file)} cannot be written (${cause.code ?? cause.message})${cure}`, { cause });
}

/** Makes a folder for what is to be written, and those above it. @throws {TelarError} X_OUTPUT */
export async function makeOutputFolder(folder) {
  try {
    await makeFolder(path.resolve(folder));
  } catch (cause) {
    throw unwritable(folder, cause);
  }
}

/**
 * Makes a folder and those above it. Not mkdir's own `recursive`: Node 20 never ends where a parent exists but takes no
 * folder (/proc).
 */
async function makeFolder(folder) {
  try {
    await mkdir(folder);
  } catch (error) {
    if (error.code === 'EEXIST' && (await stat(folder)).isDirectory()) return;
    if (error.code !== 'ENOENT') throw error;
    const parent = path.dirname(folder);
    if (!(await isThere(parent))) await makeFolder(parent);
    // Where the parent was there all along, or another picture has made it meanwhile, this tells.
    await mkdir(folder).catch(async (again) => {
      if (again.code !== 'EEXIST' || !(await stat(folder)).isDirectory()) throw again;
    });
  }
}

const isThere = (file) =>
  stat(file).then(
    () => true,
    () => false,
  );

async function writeInPlace(target, data) {
  const handle = await open(target, 'w');
  try {
    await handle.writeFile(data);
  } finally {
    await handle.close();
  }
}

/** Twelve hexadecimal digits. Names need not be secret: a file is made where none of its name is. */
const token = () =>
  Math.floor(Math.random() * 2 ** 48)
    .toString(16)
    .padStart(12, '0');

async function replace(target, data, signal) {
  const folder = path.dirname(target);
  const temporary = path.join(folder, `.${path.basename(target)}.telar-${process.pid}-${token()}.tmp`);
  unfinished.add(temporary);
  try {
    await writeSynced(temporary, data);
    signal?.throwIfAborted();
    await rename(temporary, target);
  } catch (error) {
    await rm(temporary, { force: true });
    throw error;
  } finally {
    unfinished.delete(temporary);
  }
  await syncFolder(folder);
}

async function writeSynced(file, data) {
  const handle = await open(file, 'wx');
  try {
    await handle.writeFile(data);
    await handle.sync();
  } finally {
    await handle.close();
  }
}

/** Makes the rename itself last through a power cut. */
async function syncFolder(folder) {
  const handle = await open(folder, 'r');
  try {
    await handle.sync();
  } finally {
    await handle.close();
  }
}

/**
 * Removes what earlier runs left in a folder when they were killed. Age counts beside the process number, which another
 * container may use too.
 * @param {string} folder
 */
export async function sweepStale(folder) {
  const names = await readdir(folder).catch(() => []);
  for (const name of names) {
    const match = TEMPORARY.exec(name);
    if (!match) continue;
    // In a container that was started again, this process has the number of the one that left it.
    const pid = Number(match[1]);
    if (pid !== process.pid && isAlive(pid)) continue;
    const file = path.join(folder, name);
    const { mtimeMs = Infinity } = await stat(file).catch(() => ({}));
    // In a folder such as /tmp it may be another user's.
    if (Date.now() - mtimeMs > STALE_MS) await rm(file, { force: true }).catch(() => {});
  }
}
