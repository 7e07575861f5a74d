import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

// Writes js/dist/types: the declarations of what require() gives. TypeScript wants those under another name than import's.

const JS = fileURLToPath(new URL('..', import.meta.url));

/** Entries that require() reaches, and what they import. */
const DECLARED = [
  'index',
  'shot/index',
  'shot/shot',
  'compare/index',
  'sheet/index',
  'sheet/spec',
  'pool/index',
  'queue/index',
  'queue/options',
  'server/index',
  'server/options',
  'error/index',
  'error/codes',
];

/** The same text, with its imports led to .d.cts files. */
const forCommonJs = (text) => text.replaceAll(/((?:from |import\()'\.{1,2}\/[^']*)\.js'/g, "$1.cjs'");

export function buildDeclarations() {
  for (const name of DECLARED) {
    const out = path.join(JS, 'dist/types', `${name}.d.cts`);
    mkdirSync(path.dirname(out), { recursive: true });
    writeFileSync(out, forCommonJs(readFileSync(path.join(JS, `${name}.d.ts`), 'utf8')));
  }
}
