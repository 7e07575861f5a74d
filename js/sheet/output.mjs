import { bundledFontFiles } from './engine.mjs';
import { INCH } from './scale.mjs';

/** Pages as SVG and PNG. */

/** Points of an inch. */
const POINTS = 72;

/** A page of Typst's SVG: it indents what belongs to the document by four spaces. */
const PAGE = /^ {4}<g(?: transform="[^"]*")?>\n([\s\S]*?)^ {4}<\/g>$/gm;
const DEFINITIONS = /^ {4}<(defs|style)\b[^>]*>[\s\S]*?^ {4}<\/\1>$/gm;
const DEFINED = /^ {8}<(\w+) id="([^"]+)"(?:[^>]*\/>|[\s\S]*?^ {8}<\/\1>|[^\n]*<\/\1>)$/gm;

/** Definitions that a page refers to. */
function neededBy(page, definitions) {
  const used = new Set([...page.matchAll(/(?:href="|url\()#([^")]+)/g)].map(([, id]) => id));
  return definitions.map((text) => text.replaceAll(DEFINED, (whole, _, id) => (used.has(id) ? whole : ''))).join('\n');
}

/**
 * The pages of Typst's SVG, which has them one below the other, as files of their own, in millimetres.
 * @param {string} svg
 * @param {{width: number, height: number}} page millimetres
 * @returns {string[]}
 */
export function pagesOf(svg, { width, height }) {
  const [wide, high] = [width, height].map((side) => (side / INCH) * POINTS);
  const definitions = [...svg.matchAll(DEFINITIONS)].map(([text]) => text);
  const namespaces = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"';
  return [...svg.matchAll(PAGE)].map(
    ([, page]) =>
      `<svg ${namespaces} width="${width}mm" height="${height}mm" viewBox="0 0 ${wide} ${high}">\n<rect width="${wide}" height="${high}" fill="#fff"/>\n${page}${neededBy(page, definitions)}\n</svg>\n`,
  );
}

/** A page as PNG. @param {string} svg @param {{width: number}} page millimetres @param {number} ppi */
export async function pngOf(svg, { width }, ppi) {
  const { Resvg } = await import('@resvg/resvg-js');
  const font = { fontFiles: bundledFontFiles(), loadSystemFonts: false, defaultFontFamily: 'Inter' };
  return new Resvg(svg, { font, fitTo: { mode: 'width', value: Math.round((width / INCH) * ppi) } }).render().asPng();
}
