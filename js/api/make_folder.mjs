import { mkdirSync, statSync } from 'node:fs';
import path from 'node:path';

/**
 * Makes a folder and those above it, where they are not there. `recursive` of Node never ends where the file system says of a new folder that there is no such
 * place, as /proc does: a caller who names one there would hang (Node 20).
 * @param {string} folder
 * @param {number} [mode] - Of those that are made.
 * @throws {NodeJS.ErrnoException}
 */
export function makeFolder(folder, mode) {
  try {
    makeOne(folder, mode);
  } catch (error) {
    const above = path.dirname(folder);
    if (error.code !== 'ENOENT' || above === folder) throw error;
    makeFolder(above, mode);
    makeOne(folder, mode);
  }
}

function makeOne(folder, mode) {
  try {
    mkdirSync(folder, { mode });
  } catch (error) {
    // Another process may have made it since.
    if (!statSync(folder, { throwIfNoEntry: false })?.isDirectory()) throw error;
  }
}
