import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { TelarError } from '../error/index.mjs';

/** The layout engine: Typst, with the fonts and files that it is given and no others. */

const PACKAGE = '@myriaddreamin/typst-ts-node-compiler';
const require = createRequire(import.meta.url);

/** The bundled typeface, Inter (SIL OFL): Latin, Greek, Cyrillic. */
const FONTS = ['400Regular/Inter_400Regular', '500Medium/Inter_500Medium', '600SemiBold/Inter_600SemiBold'].map(
  (name) => `@expo-google-fonts/inter/${name}.ttf`,
);

/** Folder of telar's own template. */
export const TEMPLATE = fileURLToPath(new URL('template', import.meta.url));

/** @returns {Promise<Buffer[]>} the bundled fonts */
export const bundledFonts = () => Promise.all(FONTS.map((name) => readFile(require.resolve(name))));

/** Paths of the bundled fonts. */
export const bundledFontFiles = () => FONTS.map((name) => require.resolve(name));

async function loadCompiler() {
  try {
    return (await import('@myriaddreamin/typst-ts-node-compiler')).NodeCompiler;
  } catch (cause) {
    throw new TelarError('X_LIBRARY_MISSING', `a sheet is laid out by Typst, which is not installed or does not load: npm install ${PACKAGE}`, { cause });
  }
}

/** What Typst says is wrong, on one line. */
function complaintOf(thrown) {
  const text = String(thrown?.code ?? thrown?.message ?? thrown);
  return [...text.matchAll(/message: "((?:[^"\\]|\\.)*)"/g)].map(([, message]) => message.replaceAll('\\"', '"')).join('; ') || text;
}

/** One compiler with the template's folder as all that it can read. */
export class Engine {
  #compiler;
  #folder;

  /** @param {object} options @param {Buffer[]} options.fonts @param {string} [options.folder] of the template */
  static async create({ fonts, folder = TEMPLATE }) {
    const NodeCompiler = await loadCompiler();
    return new Engine(NodeCompiler.create({ workspace: folder, fontArgs: [{ fontBlobs: fonts }] }), folder);
  }

  constructor(compiler, folder) {
    this.#compiler = compiler;
    this.#folder = folder;
  }

  /** Adds a file beside the template, under `data/`. @param {string} name @param {Uint8Array} bytes */
  add(name, bytes) {
    this.#compiler.mapShadow(path.join(this.#folder, 'data', name), Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength));
  }

  /**
   * What the template measures of texts: `measure.typ` gives one number each.
   * @param {object} inputs JSON
   * @returns {number[]} millimetres
   */
  measure(inputs) {
    return this.#run(() => this.#compiler.query(this.#call('measure.typ', inputs), { selector: '<measured>', field: 'value' }))[0];
  }

  /** @param {object} inputs JSON @returns {Buffer} PDF/UA-1 */
  pdf(inputs) {
    return this.#run(() => this.#compiler.pdf(this.#call('sheet.typ', inputs), { pdfStandard: 'ua-1', creationTimestamp: 0 }));
  }

  /** @param {object} inputs JSON @returns {string} all pages, one below the other */
  svg(inputs) {
    return this.#run(() => this.#compiler.plainSvg(this.#call('sheet.typ', inputs)));
  }

  /** Values that the template left under a label. @param {object} inputs @param {string} label */
  query(inputs, label) {
    return this.#run(() => this.#compiler.query(this.#call('sheet.typ', inputs), { selector: `<${label}>`, field: 'value' }));
  }

  /** Forgets what it has cached. */
  close() {
    this.#compiler.resetShadow();
    this.#compiler.evictCache(0);
  }

  /** A spec's text is data: it is read from JSON, and never a part of the source. */
  #call(file, inputs) {
    return { mainFilePath: path.join(this.#folder, file), inputs: { sheet: JSON.stringify(inputs) } };
  }

  #run(work) {
    try {
      return work();
    } catch (thrown) {
      throw new TelarError('X_SHEET', `the template does not lay out the sheet: ${complaintOf(thrown)}`, { cause: thrown });
    }
  }
}
