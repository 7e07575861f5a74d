import { copyFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

// Writes js/dist/zod.mjs and zod.cjs: what telar uses of zod, in one file. zod's own entry imports every locale, some fifty
// files that Node opens at once, which fails where a process may hold few of them; and browsers need no import map for it.

const JS = fileURLToPath(new URL('..', import.meta.url));

const NAMES = [
  '_default',
  'array',
  'boolean',
  'config',
  'custom',
  'discriminatedUnion',
  'enum',
  'globalRegistry',
  'gt',
  'gte',
  'int',
  'lazy',
  'length',
  'literal',
  'lte',
  'maxLength',
  'nullable',
  'number',
  'optional',
  'pipe',
  'prefault',
  'record',
  'refine',
  'regex',
  'strictObject',
  'string',
  'toJSONSchema',
  'transform',
  'tuple',
  'union',
];

// zod's entry sets the English messages, which a bundler leaves out with the locales.
const ENTRY = `
import { config } from 'zod/mini';
import en from 'zod/v4/locales/en.js';
config(en());
export { ${NAMES.join(', ')} } from 'zod/mini';
`;

const FORMATS = { esm: 'zod.mjs', cjs: 'zod.cjs' };

export async function buildZod() {
  await Promise.all(
    Object.entries(FORMATS).map(([format, file]) =>
      build({
        stdin: { contents: ENTRY, resolveDir: JS, sourcefile: 'zod_entry.mjs' },
        outfile: path.join(JS, 'dist', file),
        bundle: true,
        format,
        target: ['node20', 'chrome111', 'firefox113', 'safari16.4'],
        logLevel: 'warning',
      }),
    ),
  );
  await copyFile(path.join(path.dirname(createRequire(import.meta.url).resolve('zod')), 'LICENSE'), path.join(JS, 'dist/zod.LICENSE.txt'));
}

/** For bundles of CommonJS: zod.cjs stays a file of its own, which is read when the first shot is. @type {import('esbuild').Plugin} */
export const zodBeside = {
  name: 'zod beside',
  setup({ onResolve }) {
    onResolve({ filter: /dist\/zod\.mjs$/ }, () => ({ path: './zod.cjs', external: true }));
  },
};
