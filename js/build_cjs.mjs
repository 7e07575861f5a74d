import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { buildPage } from './build_page.mjs';
import { buildShading } from './build_shading/index.mjs';
import { buildZod, zodBeside } from './build_zod.mjs';

// Writes js/dist: zod.mjs, *.cjs from the ESM sources, for require('telar'), the text of shaders/ for three.js and the page
// of `telar view`: node js/build_cjs.mjs. One bundle for each entry of
// package.json's `exports`; npm packages stay outside. Errors of either kind of module recognise each other (js/error).

const JS = path.dirname(fileURLToPath(import.meta.url));

const ENTRIES = { index: 'index.mjs', shot: 'shot/index.mjs', compare: 'compare/index.mjs' };

// The bundles lie one folder deeper than the sources that say import.meta.url.
const BANNER = "const importMetaUrl = require('node:url').pathToFileURL(require('node:path').join(__dirname, '..', 'bundle.cjs')).href;";

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

buildShading();
await buildPage();
