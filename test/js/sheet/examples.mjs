// The examples of sheets: js/docs/sheet/*.json with their models.
// node test/js/sheet/examples.mjs      writes their pages to out/sheets, as PDF and PNG
// node test/js/sheet/examples.mjs --golden      writes test/js/sheet/golden anew: look at the pages first
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import '../api/support/real.mjs';
import { encodePng, readImage, shrinkImage } from '../../../js/compare/index.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { jacket, skirt } from '../../fixtures/garments/index.mjs';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));
const FOLDER = path.join(ROOT, 'js/docs/sheet');
export const GOLDEN = fileURLToPath(new URL('golden', import.meta.url));

const MODELS = { tshirt: () => readFile(path.join(ROOT, 'js/assets/tshirt.glb')), skirt, jacket };

/** Models of the examples by name, each made once. */
export const EXAMPLES = Object.fromEntries(
  Object.entries(MODELS).map(([name, make]) => {
    let made;
    return [name, () => (made ??= make())];
  }),
);

/** A third of the pages' width at 96 ppi: layout, lines and colours are seen, letters as grey. */
const PPI = 96;
const SHRUNK = 1 / 3;

export const specOf = (name) => JSON.parse(readFileSync(path.join(FOLDER, `${name}.json`), 'utf8'));

/** @param {'pdf' | 'png'} format */
export async function sheetOf(renderer, name, format, changes = {}) {
  const spec = { ...specOf(name), ...(format === 'png' && { ppi: PPI }), ...changes };
  return createSheet(await EXAMPLES[name](), spec, { renderer, format, resolve: (file) => readFile(path.join(FOLDER, file)).catch(() => null) });
}

/**
 * The pages of an example as the golden ones are.
 * @returns {Promise<{pages: {width: number, height: number, data: Uint8Array}[], info: object}>}
 */
export async function smallPages(renderer, name, changes) {
  const { files, info } = await sheetOf(renderer, name, 'png', changes);
  const pages = await Promise.all(
    files.map(async (file) => {
      const page = await readImage(file);
      return shrinkImage(page, { width: Math.round(page.width * SHRUNK), height: Math.round(page.height * SHRUNK) });
    }),
  );
  return { pages, info };
}

export const goldenFile = (name, page) => path.join(GOLDEN, `${name}-${String(page + 1).padStart(2, '0')}.png`);

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const out = path.join(ROOT, 'out/sheets');
  mkdirSync(out, { recursive: true });
  mkdirSync(GOLDEN, { recursive: true });
  const renderer = await createRenderer();
  try {
    for (const name of Object.keys(EXAMPLES)) {
      const { files, info } = await sheetOf(renderer, name, 'pdf');
      writeFileSync(path.join(out, `${name}.pdf`), files[0]);
      for (const { message } of info.warnings) console.log(`${name}: ${message}`);
      const { pages } = await smallPages(renderer, name);
      for (const [i, page] of pages.entries()) {
        const file = process.argv.includes('--golden') ? goldenFile(name, i) : path.join(out, path.basename(goldenFile(name, i)));
        writeFileSync(file, await encodePng(page));
      }
      console.log(`${name}: ${pages.length} pages`);
    }
  } finally {
    await renderer.close();
  }
}
