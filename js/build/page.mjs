import { cp, mkdir, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

// Writes js/dist/view, the page of `telar view`. three.js is bundled, so that servers that only draw need not install its
// 24 MB, and the page loads in few files.
// What only some models and shots need is a file of its own; three's decoders lie beside it, as its loaders want them.

const JS = fileURLToPath(new URL('..', import.meta.url));
const PAGE = path.join(JS, 'view/page');
const OUT = path.join(JS, 'dist/view');

/** From folder of three.js to folder of the page; the licences come along. */
const COPIED = {
  'examples/jsm/libs/draco/gltf': 'draco',
  'examples/jsm/libs/draco/README.md': 'draco/README.md',
  'examples/jsm/libs/basis': 'basis',
  LICENSE: 'three.LICENSE.txt',
};

const bundle = (files, options) =>
  build({
    entryPoints: Object.entries(files).map(([out, file]) => ({ in: path.join(PAGE, file), out })),
    outdir: OUT,
    bundle: true,
    splitting: true,
    minify: true,
    platform: 'browser',
    target: ['chrome111', 'firefox113', 'safari16.4'],
    format: 'esm',
    legalComments: 'eof',
    external: ['*.webp'],
    logLevel: 'warning',
    ...options,
  });

export async function buildPage() {
  await rm(OUT, { recursive: true, force: true });
  await bundle({ page: 'page.mjs', compare_worker: 'compare_worker.mjs', style: 'style.css' }, { chunkNames: 'part-[hash]' });
  // For `--three`: the same page, which imports three.js by its name.
  await bundle({ own: 'page.mjs', hdr_loader: 'hdr_loader.mjs' }, { chunkNames: 'own-[hash]', external: ['three', 'three/addons/*'] });
  for (const file of ['index.html', 'icon.svg', 'cloths.webp', 'Apache-2.0.LICENSE.txt']) await cp(path.join(PAGE, file), path.join(OUT, file));
  const three = path.dirname(path.dirname(createRequire(import.meta.url).resolve('three')));
  await mkdir(path.join(OUT, 'draco'), { recursive: true });
  for (const [from, to] of Object.entries(COPIED)) await cp(path.join(three, from), path.join(OUT, to), { recursive: true });
}
