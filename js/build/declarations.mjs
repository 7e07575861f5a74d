import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

// Writes js/dist/types: the declarations of what require() gives. TypeScript wants those under another name than import's.

const JS = fileURLToPath(new URL('..', import.meta.url));
const TYPES = './js/dist/types/';

/** Entries that require() reaches, as package.json names them: "pool/index". */
const entries = () =>
  Object.values(JSON.parse(readFileSync(path.join(JS, '../package.json'), 'utf8')).exports)
    .map((entry) => entry.require?.types)
    .filter(Boolean)
    .map((file) => file.slice(TYPES.length, -'.d.cts'.length));

const textOf = (name) => readFileSync(path.join(JS, `${name}.d.ts`), 'utf8');
const IMPORT = /((?:from |import\()'(\.{1,2}\/[^']*))\.js'/g;

/** Names of declarations and of all that they import, without ending: "shot/shot". @param {string[]} names */
function withImports(names) {
  const found = new Set(names);
  for (const name of found) for (const [, , to] of textOf(name).matchAll(IMPORT)) found.add(path.posix.join(path.posix.dirname(name), to));
  return [...found];
}

/** The declarations of the package, for tests too: path under js without ending to text. @returns {Map<string, string>} */
export const declarations = (names = entries()) => new Map(withImports(names).map((name) => [name, textOf(name)]));

export function buildDeclarations() {
  for (const [name, text] of declarations()) {
    const out = path.join(JS, 'dist/types', `${name}.d.cts`);
    mkdirSync(path.dirname(out), { recursive: true });
    writeFileSync(out, text.replaceAll(IMPORT, "$1.cjs'"));
  }
}
