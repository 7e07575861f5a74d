import { UNITS } from './table/index.mjs';

/** Lengths as a sheet prints them: what is measured is rounded, what is specified is printed as it was given. */

/** Parts of an inch: of what is measured or converted, and the finest that a fraction has. */
const PARTS = { usual: 16, finest: 64 };
const MINUS = '\u2212';

const ASCII_MINUS = /^-/;

/** Decimals of a length: that it has at least; that one of inches is rounded to; that a specified one may have. */
const DIGITS = { cm: { usual: 1, converted: 2, most: 3 }, mm: { usual: 0, converted: 1, most: 3 }, inch: { usual: 0, most: 3 } };

/** Inches that four decimals of a sixty-fourth may be off. */
const FOUR_DECIMALS = 5e-5;

/** Without what sums and products of doubles leave. */
const tidy = (value) => Number(value.toFixed(9));

/** Least parts of an inch: 20/16 = 1 1/4. */
function fraction(value, of) {
  const parts = Math.round(Math.abs(value) * of);
  const whole = Math.floor(parts / of);
  let [up, down] = [parts % of, of];
  while (up > 0 && up % 2 === 0) [up, down] = [up / 2, down / 2];
  const text = [whole > 0 || up === 0 ? String(whole) : '', up === 0 ? '' : `${up}/${down}`].filter(Boolean).join('\u00a0');
  return parts > 0 && value < 0 ? `${MINUS}${text}` : text;
}

function decimal(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? text.replace(ASCII_MINUS, '') : text.replace(ASCII_MINUS, MINUS);
}

/**
 * A measured length in its unit: a tenth of a centimetre, a millimetre, a sixteenth of an inch.
 * @param {number} millimetres
 * @param {'cm' | 'mm' | 'inch'} unit
 */
export function lengthText(millimetres, unit) {
  const value = millimetres / UNITS[unit];
  return unit === 'inch' ? fraction(value, PARTS.usual) : decimal(value, DIGITS[unit].usual);
}

/** The same with a sign. */
export const differenceText = (millimetres, unit) => {
  const text = lengthText(millimetres, unit);
  return millimetres > 0 && /[1-9]/.test(text) ? `+${text}` : text;
};

/** Millimetres of a length of a spec. @param {number} value @param {'cm' | 'mm' | 'inch'} unit */
export const millimetresOf = (value, unit) => value * UNITS[unit];

/**
 * A specified length as it is printed.
 * @typedef {object} Printed
 * @property {number} value - In the printed unit.
 * @property {number} digits - Decimals that it needs, at least the usual ones of its unit; 0 of a fraction.
 * @property {number} [parts] - Of an inch, where it is a fraction.
 * @property {boolean} isKept - Whether it is what was specified, up to the rounding of another unit.
 */

/** A multiple of 1/of that is near; of a tolerance one that is not larger. */
const near = (value, of, isMost) => (isMost ? Math.floor(value * of + 1e-6) : Math.round(value * of)) / of;

/** @returns {Printed} */
function decimals(wanted, { most, usual, isRounded, isMost }) {
  const value = near(wanted, 10 ** most, isMost);
  let digits = usual;
  while (digits < most && Number(value.toFixed(digits)) !== value) ++digits;
  return { value, digits, isKept: isRounded ? value > 0 || wanted === 0 : Math.abs(value - wanted) < 1e-9 };
}

/** Inches of another unit: sixteenths, and finer ones where nothing, or little of a tolerance, were left of it. @returns {Printed} */
function converted(wanted, isMost) {
  const largest = 0.5 / PARTS.usual + 1e-9;
  for (let parts = PARTS.usual; parts <= PARTS.finest; parts *= 2) {
    const value = near(wanted, parts, isMost);
    const isKept = wanted === 0 || (value > 0 && Math.abs(value - wanted) <= largest);
    if (isKept || parts === PARTS.finest) return { value, digits: 0, parts, isKept };
  }
}

/**
 * How a length of the spec is printed: as it was given, where its unit is printed. Centimetres and millimetres are of one kind.
 * @param {number} length
 * @param {{units: string, printedUnits: string}} spec
 * @param {boolean} [isMost] a tolerance, which is never printed larger than was given; 0.0156 inch means a sixty-fourth
 * @returns {Printed}
 */
export function printedOf(length, { units, printedUnits }, isMost = false) {
  const wanted = tidy((length * UNITS[units]) / UNITS[printedUnits]);
  const { usual, most, converted: digits } = DIGITS[printedUnits];
  if (printedUnits !== 'inch') return decimals(wanted, { usual, most: units === 'inch' ? digits : most, isRounded: units === 'inch', isMost });
  if (units !== 'inch') return converted(wanted, isMost);
  const parts = PARTS.finest;
  const value = Math.round(wanted * parts) / parts;
  return Math.abs(value - wanted) <= FOUR_DECIMALS ? { value, digits: 0, parts, isKept: true } : decimals(wanted, { usual, most, isMost });
}

/** @param {Printed} printed @param {number} [least] decimals of the column that it stands in */
export const printedText = ({ value, digits, parts }, least = 0) => (parts ? fraction(value, parts) : decimal(value, Math.max(digits, least)));
