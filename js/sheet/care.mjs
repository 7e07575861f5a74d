/**
 * The care symbols of ISO 3758 as vectors of our own: strokes in a square of 100 x 100. The order of the keys is the order in which
 * the standard wants them: washing, bleaching, drying, ironing, professional care.
 */

const STROKE = 4.5;

/** Strokes of characters on a grid of 4 x 6, y down. */
const CHARACTERS = {
  0: 'M1 0H3Q4 0 4 1V5Q4 6 3 6H1Q0 6 0 5V1Q0 0 1 0Z',
  3: 'M0 .5Q.6 0 1.8 0Q4 0 4 1.5Q4 2.9 1.6 2.9Q4 2.9 4 4.4Q4 6 1.8 6Q.6 6 0 5.4',
  4: 'M3 6V0L0 4.2H4',
  5: 'M3.7 0H.5L.2 2.7Q1 2.2 2 2.2Q4 2.2 4 4Q4 6 1.8 6Q.7 6 0 5.5',
  6: 'M3.6 .3Q2.9 0 2.3 0Q0 0 0 3.4Q0 6 2 6Q4 6 4 4.1Q4 2.4 2.1 2.4Q.5 2.4 0 3.8',
  7: 'M0 0H4L1.4 6',
  9: 'M.4 5.7Q1.1 6 1.7 6Q4 6 4 2.6Q4 0 2 0Q0 0 0 1.9Q0 3.6 1.9 3.6Q3.5 3.6 4 2.2',
  P: 'M0 6V0H2.4Q4 0 4 1.6Q4 3.3 2.4 3.3H0',
  F: 'M0 6V0H3.8M0 2.9H3',
  W: 'M-.4 0L.8 6L2 1.4L3.2 6L4.4 0',
};

const path = (d, extra = '') => `<path d="${d}"${extra}/>`;
const dot = (x, y) => `<circle cx="${x}" cy="${y}" r="5" fill="#000" stroke="none"/>`;

/** Characters in a row about a point, `height` units high. */
function written(text, x, y, height) {
  const scale = height / 6;
  const step = 5.6 * scale;
  const left = x - ((text.length - 1) * step + 4 * scale) / 2;
  const width = (STROKE * 0.9) / scale;
  return [...text]
    .map(
      (letter, i) =>
        `<g transform="translate(${left + i * step} ${y - height / 2}) scale(${scale})" stroke-width="${width.toFixed(3)}">${path(CHARACTERS[letter])}</g>`,
    )
    .join('');
}

const TUB = path('M6 26L18 80H82L94 26') + path('M9 38Q16 46 23 38T37 38T51 38T65 38T79 38T91 38');
const TRIANGLE = path('M50 12L92 84H8Z');
const SQUARE = path('M14 14H86V86H14Z');
const DRUM = '<circle cx="50" cy="50" r="31"/>';
const IRON = path('M8 78Q10 44 46 44H80L88 78ZM26 26H70Q77 26 78 36L80 44');
const CIRCLE = '<circle cx="50" cy="48" r="37"/>';
const HAND = path('M42 12V44L34 36Q29 32 26 36Q24 39 28 44L43 62Q47 69 55 69Q66 69 66 58V12M50 56V66M58 56V66');
const CROSS = path('M12 12L88 88M88 12L12 88');
const SHADE = path('M14 38L38 14');

/** Lines beneath a symbol: one = mild, two = very mild. */
const bars = (count, y = 89) => (count === 0 ? '' : path(`M20 ${y}H80`)) + (count > 1 ? path(`M20 ${y + 9}H80`) : '');

const tub = (degrees, mild = 0) => TUB + written(String(degrees), 50, 61, 22) + bars(mild);
const solvent = (letter, mild = 0) => CIRCLE + written(letter, 50, 48, 30) + bars(mild, 92);
const iron = (dots) => IRON + Array.from({ length: dots }, (_, i) => dot(50 + (i - (dots - 1) / 2) * 15, 62)).join('');
const tumble = (dots) => SQUARE + DRUM + Array.from({ length: dots }, (_, i) => dot(50 + (i - (dots - 1) / 2) * 18, 50)).join('');
const lineDry = (lines, extra = '') => SQUARE + lines + extra;

const UPRIGHT = path('M50 26V74');
const TWO_UPRIGHT = path('M41 26V74M59 26V74');
const FLAT = path('M26 50H74');
const TWO_FLAT = path('M26 42H74M26 58H74');

/** What each symbol draws, by its key. */
export const CARE_SYMBOLS = Object.freeze({
  'wash-95': tub(95),
  'wash-70': tub(70),
  'wash-60': tub(60),
  'wash-60-mild': tub(60, 1),
  'wash-50': tub(50),
  'wash-50-mild': tub(50, 1),
  'wash-40': tub(40),
  'wash-40-mild': tub(40, 1),
  'wash-40-very-mild': tub(40, 2),
  'wash-30': tub(30),
  'wash-30-mild': tub(30, 1),
  'wash-30-very-mild': tub(30, 2),
  'wash-hand': TUB + HAND,
  'wash-no': TUB + CROSS,
  bleach: TRIANGLE,
  'bleach-oxygen': TRIANGLE + path('M39 31L70 84M27 51L46 84'),
  'bleach-no': TRIANGLE + CROSS,
  'tumble-dry': tumble(2),
  'tumble-dry-low': tumble(1),
  'tumble-dry-no': SQUARE + DRUM + CROSS,
  'dry-line': lineDry(UPRIGHT),
  'dry-line-shade': lineDry(UPRIGHT, SHADE),
  'dry-drip': lineDry(TWO_UPRIGHT),
  'dry-drip-shade': lineDry(TWO_UPRIGHT, SHADE),
  'dry-flat': lineDry(FLAT),
  'dry-flat-shade': lineDry(FLAT, SHADE),
  'dry-drip-flat': lineDry(TWO_FLAT),
  'dry-drip-flat-shade': lineDry(TWO_FLAT, SHADE),
  'iron-200': iron(3),
  'iron-150': iron(2),
  'iron-110': iron(1),
  'iron-no': IRON + CROSS,
  'dry-clean-p': solvent('P'),
  'dry-clean-p-mild': solvent('P', 1),
  'dry-clean-f': solvent('F'),
  'dry-clean-f-mild': solvent('F', 1),
  'dry-clean-no': CIRCLE + CROSS,
  'wet-clean': solvent('W'),
  'wet-clean-mild': solvent('W', 1),
  'wet-clean-very-mild': solvent('W', 2),
  'wet-clean-no': CIRCLE + written('W', 50, 48, 30) + CROSS,
});

/** A symbol as an SVG file. @param {string} key of CARE_SYMBOLS */
export const careSvg = (key) =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="100" height="104" viewBox="0 0 100 104"><g fill="none" stroke="#000" stroke-width="${STROKE}" stroke-linecap="round" stroke-linejoin="round">${CARE_SYMBOLS[key]}</g></svg>`;
