import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

// The shared hostile files, and how each must end, whichever way it comes in.

const FOLDER = join(dirname(fileURLToPath(import.meta.url)), '../../../shared/hostile');
const MANIFEST = join(FOLDER, 'manifest.json');

/** Why tests of them are skipped. */
export const WITHOUT_SHARED = !existsSync(MANIFEST) && 'no ../shared/hostile';

/** @typedef {{file: string, mode: 'bytes' | 'path', accept: ('render' | 'reject' | 'limit')[], code: string, path: string}} SharedCase */

/** @returns {SharedCase[]} path: of the file */
export const sharedCases = () => JSON.parse(readFileSync(MANIFEST, 'utf8')).cases.map((entry) => ({ ...entry, path: join(FOLDER, 'cases', entry.file) }));

/** Codes of the manifest under the names that telar's table has for them. */
const ALIASES = { L_IMAGE_DIM: 'L_IMAGE_DIMENSION', W_GLB_UNKNOWN_CHUNK: 'W_GLB_CHUNK', L_TIME: 'L_IMAGE_SCANS', W_EXT: 'W_EXT_IGNORED' };

/** Where telar ends in another way than the manifest's first choice, and why. All stay within its `accept`. */
const OTHERWISE = [
  [/^j-nul-bytes/, 'E_NOT_GLTF'], // by its bytes no other than c-all-zero-4k
  [/^j-padding-nul/, ''], // the JSON in this file needs no padding: it has no NUL
  [/^u-buffer-symlink-escape/, 'E_URI_MISSING'], // the link is absent from this copy of the folder
  [/^h-gpu-instancing/, 'E_INSTANCING'],
  [/^g-matrix-zero/, ''], // three.js takes a matrix without volume for no scale
  [/^e-animation-bad/, 'E_REF'], // a pose may ask for it
  [/^p-(png-ffffffff|png-65536|png-bomb-\d|jpeg-65500|webp-16383)/, 'L_IMAGE_DIMENSION'], // a side is checked before the area
  [/^p-png-bomb-idat-longer/, ''], // all pixels are there: drawing and refusing are both right
  [/^p-png-bomb-idat-longer/, 'E_IMAGE_CORRUPT'],
  [/^p-png-no-iend/, 'E_IMAGE_CORRUPT'], // cut files are refused, whatever was lost
  [/^p-png-palette-index/, ''], // drawn as browsers do
  [/^o-meshopt-optional-broken/, 'E_MESHOPT'], // three.js does not fall back either
  [/^e-(texture-transform|light)-1e400/, 'E_SCHEMA'], // a number that is no double is refused wherever it stands
  [/^d-empty/, 'E_BUFFERVIEW'], // a view of no bytes is wrong in itself
  [/^d-accessor-type-scalar/, 'E_ACCESSOR'], // as is a POSITION of scalars
];

const isExpected = ({ file, code }, codes) =>
  !code ||
  code === 'E_*' ||
  codes.includes(code) ||
  codes.includes(ALIASES[code]) ||
  OTHERWISE.some(([name, other]) => name.test(file) && codes.includes(other));

/**
 * What is wrong with the end of a case; undefined where nothing is.
 * @param {SharedCase} entry
 * @param {{code?: string, warnings?: {code: string}[]}} end code: of the error; warnings: of a picture
 */
export function faultOf(entry, { code, warnings = [] }) {
  const outcome = code === undefined ? 'render' : code.startsWith('L_') ? 'limit' : 'reject';
  const found = warnings.map((warning) => warning.code);
  const codes = code === undefined ? (found.length > 0 ? found : ['']) : [code];
  if (!entry.accept.includes(outcome)) return `${entry.file}: ${outcome} ${codes}, accepted ${entry.accept}`;
  return isExpected(entry, codes) ? undefined : `${entry.file}: ${codes}, expected ${entry.code}`;
}
