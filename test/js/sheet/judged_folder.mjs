import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after } from 'node:test';

/**
 * A folder for the tests of one file, and what runs poppler and qpdf on the files in it (js/machine/debian_packages.txt).
 * @param {string} name of the tests
 * @returns {{folder: string, run: (command: string, ...args: string[]) => string}} run: gives stdout
 */
export function judgedFolder(name) {
  const folder = mkdtempSync(path.join(tmpdir(), `telar-${name}-`));
  after(() => rmSync(folder, { recursive: true }));
  const run = (command, ...args) => execFileSync(command, args, { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  return { folder, run };
}
