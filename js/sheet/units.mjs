import { UNITS } from './table/index.mjs';

/** Lengths as a sheet prints them. */

const INCH_PARTS = 16;
const MINUS = '\u2212';

const ASCII_MINUS = /^-/;

/** Least parts of an inch: 20/16 = 1 1/4. */
function inches(value) {
  const parts = Math.round(Math.abs(value) * INCH_PARTS);
  const whole = Math.floor(parts / INCH_PARTS);
  let [up, down] = [parts % INCH_PARTS, INCH_PARTS];
  while (up > 0 && up % 2 === 0) [up, down] = [up / 2, down / 2];
  const fraction = up === 0 ? '' : `${up}/${down}`;
  const text = [whole > 0 || fraction === '' ? String(whole) : '', fraction].filter(Boolean).join('\u00a0');
  return parts > 0 && value < 0 ? `${MINUS}${text}` : text;
}

/**
 * A length in its unit: a tenth of a centimetre, a millimetre, a sixteenth of an inch.
 * @param {number} millimetres
 * @param {'cm' | 'mm' | 'inch'} unit
 */
export function lengthText(millimetres, unit) {
  const value = millimetres / UNITS[unit];
  if (unit === 'inch') return inches(value);
  const text = value.toFixed(unit === 'cm' ? 1 : 0);
  return Number(text) === 0 ? text.replace(ASCII_MINUS, '') : text.replace(ASCII_MINUS, MINUS);
}

/** The same with a sign. */
export const differenceText = (millimetres, unit) => {
  const text = lengthText(millimetres, unit);
  return millimetres > 0 && /[1-9]/.test(text) ? `+${text}` : text;
};

/** Millimetres of a length of a spec. @param {number} value @param {'cm' | 'mm' | 'inch'} unit */
export const millimetresOf = (value, unit) => value * UNITS[unit];
