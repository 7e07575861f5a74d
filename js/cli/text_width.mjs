import { createRequire } from 'node:module';
import { escaped } from '../compare/markup.mjs';

/** How wide text is in the bundled typeface, Inter (SIL OFL), and text cut to a width. */

const require = createRequire(import.meta.url);

/** File by weight. */
export const FONTS = {
  400: '@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf',
  500: '@expo-google-fonts/inter/500Medium/Inter_500Medium.ttf',
};

/** Inter has Latin, Greek and Cyrillic; other scripts come from the fonts of the machine, where it has them. */
export const needsSystemFonts = (text) => /[^\u0000-\u052f\u1e00-\u1fff\u2000-\u206f\u20a0-\u20bf\u2100-\u21ff\u2c60-\u2c7f\ua720-\ua7ff]/.test(text);

/** No letter of Inter is wider, in ems. */
const WIDEST_EM = 1.1;

function measured(text, size, weight) {
  const { Resvg } = require('@resvg/resvg-js');
  // Spaces at the ends have no outline: bars stand around the text, and their own width is taken off.
  const widthOf = (inner) =>
    new Resvg(
      `<svg xmlns="http://www.w3.org/2000/svg"><text font-family="Inter" font-weight="${weight}" font-size="${size}">|${escaped(inner)}|</text></svg>`,
      { font: { fontFiles: [require.resolve(FONTS[weight])], loadSystemFonts: needsSystemFonts(inner), defaultFontFamily: 'Inter' } },
    ).getBBox().width;
  return widthOf(text) - widthOf('');
}

/**
 * Text no wider than a width: where it is too long, its middle gives way, as names that belong together differ at their
 * ends.
 * @param {string} text
 * @param {number} size of the type, pixels
 * @param {400 | 500} weight
 * @param {number} width pixels
 */
export function ellipsized(text, size, weight, width) {
  const letters = [...text];
  const fits = (shown) => [...shown].length * WIDEST_EM * size <= width || measured(shown, size, weight) <= width;
  if (fits(text)) return text;
  const cut = (kept) =>
    `${letters
      .slice(0, Math.ceil(kept / 2))
      .join('')
      .trimEnd()}…${letters
      .slice(letters.length - Math.floor(kept / 2))
      .join('')
      .trimStart()}`;
  let [low, high] = [0, letters.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (fits(cut(middle))) low = middle;
    else high = middle - 1;
  }
  return cut(low);
}
