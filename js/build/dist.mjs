import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { buildDeclarations } from './declarations.mjs';
import { buildPage } from './page.mjs';
import { buildShading } from './shading/index.mjs';
import { buildZod, zodBeside } from './zod.mjs';

// Writes js/dist: node js/build/dist.mjs. It holds zod.mjs, a *.cjs with its declarations for each entry that package.json gives
// to require(), the text of shaders/ for three.js, and the page of `telar view`. npm packages stay outside of the *.cjs. Errors of
// either kind of module recognise each other (js/error).

const JS = fileURLToPath(new URL('..', import.meta.url));

const ENTRIES = {
  index: 'index.mjs',
  shot: 'shot/index.mjs',
  compare: 'compare/index.mjs',
  pool: 'pool/index.mjs',
  queue: 'queue/index.mjs',
  server: 'server/index.mjs',
};

// import.meta.url of the bundled sources: those that read it all lie in js/api.
const BANNER = "const importMetaUrl = require('node:url').pathToFileURL(require('node:path').join(__dirname, '..', 'api', 'bundle.cjs')).href;";

// First: the sources import it.
await buildZod();

await build({
  entryPoints: Object.entries(ENTRIES).map(([out, file]) => ({ in: path.join(JS, file), out })),
  outdir: path.join(JS, 'dist'),
  outExtension: { '.js': '.cjs' },
  bundle: true,
  packages: 'external',
  plugins: [zodBeside],
  platform: 'node',
  target: 'node20',
  format: 'cjs',
  banner: { js: BANNER },
  define: { 'import.meta.url': 'importMetaUrl' },
  logLevel: 'warning',
});

buildDeclarations();
buildShading();
await buildPage();
