import { copyFileSync, cpSync, existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { ROOT, SetupError } from '../../machine/step.mjs';

// The licences of what the compiled part holds of others, each with its whole text: Debian's files name common ones by their place on a Debian.

const COMMON = '/usr/share/common-licenses';

/** Headers of npm that the addon is compiled with. */
const HEADER_PACKAGES = { 'node-addon-api': 'LICENSE.md', 'node-api-headers': 'LICENSE' };

/** Licences that are terms added to another one. */
const ADDED_TO = { 'LGPL-3': 'GPL-3', LGPL: 'GPL' };

/** Names of the common licences that a text leaves to the system, and of those that these add to. */
function commonIn(text) {
  const names = [...text.matchAll(/\/usr\/share\/common-licenses\/([A-Za-z]+(?:-\d+(?:\.\d+)?)?)/g)].map(([, name]) => name);
  return [...names, ...names.map((name) => ADDED_TO[name]).filter(Boolean)];
}

/**
 * Names of common licences that the texts of a folder speak of and that the folder lacks.
 * @param {string} folder
 * @returns {string[]}
 */
export function missingTexts(folder) {
  const texts = readdirSync(folder).filter((name) => name.endsWith('.txt'));
  const names = new Set(texts.flatMap((name) => commonIn(readFileSync(path.join(folder, name), 'utf8'))));
  return [...names].filter((name) => !existsSync(path.join(folder, 'common', name))).sort();
}

/**
 * @param {{name: string, copyright: string}[]} packages - Of Debian; `copyright`: file
 * @param {string} folder - Is made
 * @throws {SetupError} Where a text is not on this machine
 */
export function copyLicences(packages, folder) {
  mkdirSync(path.join(folder, 'common'), { recursive: true });
  for (const { name, copyright } of packages) copyFileSync(copyright, path.join(folder, `${name}.txt`));
  const require = createRequire(import.meta.url);
  for (const [name, file] of Object.entries(HEADER_PACKAGES)) {
    copyFileSync(path.join(path.dirname(require.resolve(`${name}/package.json`)), file), path.join(folder, `${name}.txt`));
  }
  cpSync(path.join(ROOT, 'NOTICE'), path.join(folder, 'NOTICE'));
  for (const name of missingTexts(folder)) {
    const file = path.join(COMMON, name);
    if (!existsSync(file)) throw new SetupError(`the text of the licence ${name} is not in ${COMMON}`, { cure: 'run this on Debian 12' });
    copyFileSync(file, path.join(folder, 'common', name));
  }
}
