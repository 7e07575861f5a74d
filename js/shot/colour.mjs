import cssNames from 'color-name';

/**
 * sRGB transfer function, encoded [0, 1] to linear [0, 1], with the constants of three.js 0.187 so that a colour has the
 * same bits on both sides (IEC 61966-2-1 has 1/12.92 and 1/1.055, 0.055/1.055).
 */
export const srgbToLinear = (c) => (c < 0.04045 ? c * 0.0773993808 : (c * 0.9478672986 + 0.0521327014) ** 2.4);

const NUMBER = '[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[+-]?\\d+)?';
const SEPARATOR = '(?:\\s*,\\s*|\\s+)';
const triple = (a, b, c) => new RegExp(`^(?:rgb|hsl)a?\\(\\s*${a}${SEPARATOR}${b}${SEPARATOR}${c}` + `(?:\\s*[,/]\\s*(${NUMBER}%?))?\\s*\\)$`);
const RGB_BYTES = triple(`(${NUMBER})`, `(${NUMBER})`, `(${NUMBER})`);
const RGB_PERCENT = triple(`(${NUMBER})%`, `(${NUMBER})%`, `(${NUMBER})%`);
const HSL = triple(`(${NUMBER})(?:deg)?`, `(${NUMBER})%`, `(${NUMBER})%`);
const HEX = /^#(?:[\da-f]{3}|[\da-f]{4}|[\da-f]{6}|[\da-f]{8})$/;

const unit = (x) => Math.min(1, Math.max(0, x));

/**
 * Reads an opaque CSS colour: a name, #rgb, #rrggbb, rgb() or hsl(), with commas or spaces.
 * @param {string} text
 * @returns {[number, number, number] | undefined} linear Rec.709, as `new THREE.Color(text)` holds it in three.js 0.187;
 *   undefined when the text is not such a colour or is not opaque
 */
export function parseColour(text) {
  const encoded = parseEncoded(text.trim().toLowerCase());
  return encoded?.map((c) => srgbToLinear(c));
}

function parseEncoded(text) {
  if (Object.hasOwn(cssNames, text)) return cssNames[text].map((byte) => byte / 255);
  if (HEX.test(text)) return parseHex(text.slice(1));
  const isRgb = text.startsWith('rgb');
  const match = isRgb ? (RGB_BYTES.exec(text) ?? RGB_PERCENT.exec(text)) : HSL.exec(text);
  if (!match || !isOpaque(match[4])) return undefined;
  const [a, b, c] = match.slice(1, 4).map(Number);
  if (!isRgb) return hslToRgb(a / 360, unit(b / 100), unit(c / 100));
  const full = match[0].includes('%') && !RGB_BYTES.test(text) ? 100 : 255;
  return [unit(a / full), unit(b / full), unit(c / full)];
}

function parseHex(digits) {
  const wide = digits.length <= 4 ? [...digits].map((digit) => digit + digit).join('') : digits;
  const [r, g, b, a = 255] = wide.match(/../g).map((byte) => Number.parseInt(byte, 16));
  return a === 255 ? [r / 255, g / 255, b / 255] : undefined;
}

const isOpaque = (alpha) => alpha === undefined || Number.parseFloat(alpha) >= (alpha.endsWith('%') ? 100 : 1);

/** Hue in turns, saturation and lightness [0, 1]; the order of operations is three.js's, for equal bits. */
function hslToRgb(hue, saturation, lightness) {
  const turn = ((hue % 1) + 1) % 1;
  if (saturation === 0) return [lightness, lightness, lightness];
  const p = lightness <= 0.5 ? lightness * (1 + saturation) : lightness + saturation - lightness * saturation;
  const q = 2 * lightness - p;
  return [turn + 1 / 3, turn, turn - 1 / 3].map((t) => hueToChannel(q, p, t));
}

function hueToChannel(low, high, hue) {
  const t = hue < 0 ? hue + 1 : hue > 1 ? hue - 1 : hue;
  if (t < 1 / 6) return low + (high - low) * 6 * t;
  if (t < 1 / 2) return high;
  if (t < 2 / 3) return low + (high - low) * 6 * (2 / 3 - t);
  return low;
}
