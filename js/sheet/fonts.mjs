import { TelarError } from '../error/index.mjs';
import { pathText, pointerText } from '../shot/complain.mjs';
import { CHARACTERS } from '../shot/table/rows.mjs';
import { ABOUT } from './read.mjs';

/** Which characters TrueType and OpenType fonts have (OpenType 1.9, "cmap"), and what their families are called ("name"). */

const wrongFont = (i) =>
  new TelarError('E_OPTION', `options.fonts[${i}]: expected the bytes of a TrueType or OpenType font with a Unicode character map and a name of its family`);

const tagAt = (view, offset) => String.fromCharCode(...[0, 1, 2, 3].map((k) => view.getUint8(offset + k)));

/** Offset of a table of a font; of a collection, of its first font. */
function tableAt(view, tag) {
  const start = tagAt(view, 0) === 'ttcf' ? view.getUint32(12) : 0;
  const count = view.getUint16(start + 4);
  for (let i = 0; i < count; ++i) if (tagAt(view, start + 12 + 16 * i) === tag) return view.getUint32(start + 12 + 16 * i + 8);
  return undefined;
}

/** Ranges of characters of a map of format 12: every group. */
function* ranges12(view, at) {
  const count = view.getUint32(at + 12);
  for (let i = 0; i < count; ++i) {
    const group = at + 16 + 12 * i;
    yield [view.getUint32(group), view.getUint32(group + 4)];
  }
}

/** Of format 4: every segment, without the characters whose glyph is none. */
function* ranges4(view, at) {
  const count = view.getUint16(at + 6) / 2;
  let next = 0;
  for (let i = 0; i < count; ++i) {
    const [end, start] = [view.getUint16(at + 14 + 2 * i), view.getUint16(at + 16 + 2 * count + 2 * i)];
    const delta = view.getUint16(at + 16 + 4 * count + 2 * i);
    const rangeAt = at + 16 + 6 * count + 2 * i;
    const range = view.getUint16(rangeAt);
    for (let c = Math.max(start, next); c <= end && c < 0xffff; ++c) {
      const glyph = range === 0 ? (c + delta) & 0xffff : view.getUint16(rangeAt + range + 2 * (c - start));
      if (glyph !== 0) yield [c, c];
    }
    next = Math.max(next, end + 1);
  }
}

/** Ranges in ascending order, each character once: both formats are so, and what a file has otherwise is left out. */
function ascending(ranges) {
  const found = [];
  for (const [from, to] of ranges) {
    const last = found.at(-1);
    const next = last ? last[1] + 1 : 0;
    if (from === next && last) last[1] = Math.max(to, last[1]);
    else if (to >= Math.max(from, next)) found.push([Math.max(from, next), to]);
  }
  return found;
}

/** @param {Uint8Array} font @returns {[number, number][]} code points from, to; ascending */
export function charactersOf(font) {
  const view = new DataView(font.buffer, font.byteOffset, font.byteLength);
  const cmap = tableAt(view, 'cmap');
  const tables = Array.from({ length: view.getUint16(cmap + 2) }, (_, i) => {
    const at = cmap + view.getUint32(cmap + 4 + 8 * i + 4);
    return { at, format: view.getUint16(at) };
  });
  const full = tables.find(({ format }) => format === 12);
  return ascending(full ? ranges12(view, full.at) : ranges4(view, tables.find(({ format }) => format === 4).at));
}

const utf16 = new TextDecoder('utf-16be', { fatal: true });
const macRoman = new TextDecoder('macintosh');

/** Platforms of names in the order in which they are looked at: Windows, Unicode and Macintosh, with the encodings that are known of each. */
const PLATFORMS = [
  { platform: 3, encodings: [0, 1, 10], decoder: utf16 },
  { platform: 0, encodings: [0, 1, 2, 3, 4, 5, 6], decoder: utf16 },
  { platform: 1, encodings: [0], decoder: macRoman },
];

/** The typographic family, and the family of four styles that older programs know. */
const FAMILIES = [16, 1];

/** A name that is whole; undefined where it is empty, or no text. */
function nameOf(bytes, decoder) {
  try {
    const name = decoder.decode(bytes);
    return name !== '' && CHARACTERS.test(name) ? name : undefined;
  } catch {
    return undefined;
  }
}

/** Name of a font's family: the typographic one where it has one. @throws where it has none */
function familyOf(font) {
  const view = new DataView(font.buffer, font.byteOffset, font.byteLength);
  const at = tableAt(view, 'name');
  if (at === undefined) throw new RangeError('no table of names');
  const strings = at + view.getUint16(at + 4);
  const records = Array.from({ length: view.getUint16(at + 2) }, (_, i) => {
    const [platform, encoding, , id, length, offset] = Array.from({ length: 6 }, (_, k) => view.getUint16(at + 6 + 12 * i + 2 * k));
    return { platform, encoding, id, bytes: font.subarray(strings + offset, strings + offset + length) };
  });
  for (const wanted of FAMILIES)
    for (const { platform, encodings, decoder } of PLATFORMS)
      for (const record of records) {
        if (record.id !== wanted || record.platform !== platform || !encodings.includes(record.encoding)) continue;
        const name = nameOf(record.bytes, decoder);
        if (name !== undefined) return name;
      }
  throw new RangeError('no name of a family');
}

/**
 * @param {Uint8Array[]} fonts
 * @param {number} bundled - How many of them are telar's own, which come first.
 * @returns {{families: string[], has: (character: number) => boolean}}
 * @throws {TelarError} E_OPTION
 */
export function readFonts(fonts, bundled = 0) {
  const characters = [];
  const families = fonts.map((font, i) => {
    try {
      characters.push(charactersOf(font));
      return familyOf(font);
    } catch {
      throw wrongFont(i - bundled);
    }
  });
  return { families: [...new Set(families)], has: (character) => characters.some((ranges) => isAmong(ranges, character)) };
}

/** @param {[number, number][]} ranges - Ascending. */
function isAmong(ranges, character) {
  let [low, high] = [0, ranges.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ranges[middle][1] < character) low = middle + 1;
    else high = middle;
  }
  return low < ranges.length && ranges[low][0] <= character;
}

/** What needs no glyph of its own: line feeds and marks that only shape or direct text. */
const isInvisible = (c) =>
  c === 10 ||
  c === 0x200b ||
  c === 0x200c ||
  c === 0x200d ||
  (c >= 0x200e && c <= 0x200f) ||
  (c >= 0x202a && c <= 0x202e) ||
  (c >= 0x2066 && c <= 0x2069) ||
  c === 0xfeff ||
  c === 0x00ad;

/**
 * Refuses a text that the fonts cannot show: nothing is printed as empty boxes.
 * @param {string} text
 * @param {{has: (character: number) => boolean}} fonts
 * @param {{place: string, pointer: string}} where place: as the message names it
 * @throws {TelarError} E_SPEC
 */
export function checkText(text, fonts, { place, pointer }) {
  const missing = [...text].find((character) => !isInvisible(character.codePointAt(0)) && !fonts.has(character.codePointAt(0)));
  if (missing === undefined) return;
  const code = missing.codePointAt(0).toString(16).toUpperCase().padStart(4, '0');
  throw new TelarError(ABOUT.code, `${place}: no font has U+${code} "${missing}"; give one that does with the option fonts, --font FILE`, { pointer });
}

/** The same of all texts of a spec. @throws {TelarError} E_SPEC with the pointer of the text */
export function checkCharacters(value, fonts, path = []) {
  if (typeof value === 'string') {
    checkText(value, fonts, { place: pathText(path, ABOUT), pointer: pointerText(path) });
    return;
  }
  if (typeof value !== 'object' || value === null) return;
  for (const [key, inner] of Object.entries(value)) checkCharacters(inner, fonts, [...path, Array.isArray(value) ? Number(key) : key]);
}
