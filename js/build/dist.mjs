import { chmod, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { buildDeclarations } from './declarations.mjs';
import { buildPage } from './page.mjs';
import { buildShading } from './shading/index.mjs';
import { buildZod, zodBeside } from './zod.mjs';

// Writes js/dist: node js/build/dist.mjs. It holds zod.mjs, a *.cjs with its declarations for each entry that package.json gives
// to require(), the command (telar.cjs, which starts thumbnail.cjs or commands.cjs), the text of shaders/ for three.js, and the
// page of `telar view`. npm packages stay outside of the *.cjs. Errors of either kind of module recognise each other (js/error).

const JS = fileURLToPath(new URL('..', import.meta.url));

const ENTRIES = {
  index: 'index.mjs',
  shot: 'shot/index.mjs',
  compare: 'compare/index.mjs',
  pool: 'pool/index.mjs',
  queue: 'queue/index.mjs',
  server: 'server/index.mjs',
  commands: 'cli/telar.mjs',
  thumbnail: 'cli/telar_thumbnail.mjs',
};

// A command as one file starts sooner than from a hundred sources. Node reads the whole of a file, so thumbnails have their own, of half the
// size.
const COMMAND = "#!/usr/bin/env node\nrequire(process.argv[2] === 'thumbnail' ? './thumbnail.cjs' : './commands.cjs');\n";

// What a source finds beside itself, it finds from a bundle as well: import.meta.url stays that of the source.
const BANNER = "const urlOf = (file) => require('node:url').pathToFileURL(require('node:path').join(__dirname, '..', file)).href;";

/** @type {import('esbuild').Plugin} */
const urlsOfSources = {
  name: 'urls of sources',
  setup({ onLoad }) {
    onLoad({ filter: /\.mjs$/ }, async ({ path: file }) => ({
      contents: (await readFile(file, 'utf8')).replaceAll('import.meta.url', `urlOf(${JSON.stringify(path.relative(JS, file))})`),
    }));
  },
};

// First: the sources import it.
await buildZod();

await build({
  entryPoints: Object.entries(ENTRIES).map(([out, file]) => ({ in: path.join(JS, file), out })),
  outdir: path.join(JS, 'dist'),
  outExtension: { '.js': '.cjs' },
  bundle: true,
  packages: 'external',
  plugins: [zodBeside, urlsOfSources],
  platform: 'node',
  target: 'node20',
  format: 'cjs',
  banner: { js: BANNER },
  logLevel: 'warning',
});
await writeFile(path.join(JS, 'dist/telar.cjs'), COMMAND);
await chmod(path.join(JS, 'dist/telar.cjs'), 0o755);

buildDeclarations();
buildShading();
await buildPage();
