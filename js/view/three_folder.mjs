import { createHash } from 'node:crypto';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { REVISION_MIN } from '../shot/three_terms.mjs';

/** Of the package: all that a page can import. */
const PARTS = ['build', 'examples/jsm'];

/** Decoders that three.js fetches beside the page, by their folder there. */
const DECODERS = { draco: 'examples/jsm/libs/draco/gltf', basis: 'examples/jsm/libs/basis' };

const MODULE = 'build/three.module.js';
const HDR_LOADER = 'examples/jsm/loaders/HDRLoader.js';

const packageOf = (folder) => {
  try {
    return JSON.parse(readFileSync(path.join(folder, 'package.json'), 'utf8'));
  } catch {
    return {};
  }
};

/** Files beneath a folder, as paths from the package's folder with / between. */
function filesIn(folder, part) {
  const entries = readdirSync(path.join(folder, part), { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  return entries.map((entry) =>
    path
      .relative(folder, path.join(entry.parentPath ?? entry.path, entry.name))
      .split(path.sep)
      .join('/'),
  );
}

/**
 * A user's own three.js, for the page of `telar view`.
 * @typedef {object} OwnThree
 * @property {number} revision - N of 0.N.
 * @property {Map<string, string>} files - What the page may ask for beneath three/: its path in the package, and the file.
 * @property {Map<string, string>} decoders - The same beneath page/, in place of the page's own.
 * @property {string} importMap - A script element with the names that the page imports by.
 * @property {string} hash - Of its text, as a content security policy names it.
 *
 * @param {string} given - Folder of the package three, or of a project that has it in node_modules.
 * @returns {OwnThree}
 * @throws {TelarError} E_USAGE
 */
export function openThree(given) {
  const folder = [given, path.join(given, 'node_modules/three')].find(
    (candidate) => packageOf(candidate).name === 'three' && existsSync(path.join(candidate, MODULE)),
  );
  if (!folder)
    throw new TelarError('E_USAGE', `--three ${shown(given)}: expected the folder of the npm package three, or of a project that has it in node_modules`);
  const { version } = packageOf(folder);
  const revision = Number(/^0\.(\d+)\./.exec(version)?.[1]);
  if (!(revision >= REVISION_MIN))
    throw new TelarError('E_USAGE', `--three ${shown(given)}: expected three.js 0.${REVISION_MIN} or later, got ${shown(version)}`);
  const files = new Map(PARTS.flatMap((part) => filesIn(folder, part)).map((name) => [name, path.join(folder, name)]));
  const decoders = Object.entries(DECODERS).flatMap(([name, part]) =>
    [...files].filter(([file]) => path.posix.dirname(file) === part).map(([file, at]) => [`${name}/${path.posix.basename(file)}`, at]),
  );
  const imports = { three: `./three/${MODULE}`, 'three/addons/': './three/examples/jsm/' };
  if (!files.has(HDR_LOADER)) imports['three/addons/loaders/HDRLoader.js'] = './page/hdr_loader.js';
  const text = JSON.stringify({ imports });
  const hash = `sha256-${createHash('sha256').update(text).digest('base64')}`;
  return { revision, files, decoders: new Map(decoders), importMap: `<script type="importmap">${text}</script>`, hash };
}
