import { encodeSrgb } from './maps.mjs';

/** The woven neck label, metres. */
export const LABEL = { width: 0.046, height: 0.017 };

const [WIDTH, HEIGHT] = [512, 256];
const THREAD = 1.25e-4;

// Letters as strokes on a grid of one x-height: polylines of [x, y], y up from the baseline.
const arc = (cx, cy, r, from, to) =>
  Array.from({ length: 25 }, (_, i) => {
    const angle = ((from + ((to - from) * i) / 24) * Math.PI) / 180;
    return [cx + r * Math.cos(angle), cy + r * Math.sin(angle)];
  });

const LETTERS = [
  {
    advance: 0.75,
    strokes: [
      [[0.3, 1.5], [0.3, 0.3], ...arc(0.55, 0.25, 0.25, 180, 290)],
      [
        [0.02, 1],
        [0.68, 1],
      ],
    ],
  },
  { advance: 1.22, strokes: [[[0, 0.52], [1, 0.52], ...arc(0.5, 0.5, 0.5, 2, 318)]] },
  {
    advance: 0.42,
    strokes: [
      [
        [0.1, 1.62],
        [0.1, 0],
      ],
    ],
  },
  {
    advance: 1.22,
    strokes: [
      arc(0.5, 0.5, 0.5, 0, 360),
      [
        [1, 1],
        [1, 0],
      ],
    ],
  },
  {
    advance: 0.7,
    strokes: [
      [
        [0.1, 1],
        [0.1, 0],
      ],
      arc(0.55, 0.55, 0.45, 180, 70),
    ],
  },
];

const TRACKING = 0.26;

function wordStrokes(height) {
  const strokes = [];
  let x = 0;
  for (const letter of LETTERS) {
    for (const stroke of letter.strokes) strokes.push(stroke.map(([px, py]) => [(px + x) * height, py * height]));
    x += letter.advance + TRACKING;
  }
  return { strokes, width: (x - TRACKING) * height };
}

function distanceToStrokes(strokes, x, y) {
  let best = Infinity;
  for (const points of strokes) {
    for (let i = 1; i < points.length; i++) {
      const [a, b] = [points[i - 1], points[i]];
      const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
      const t = Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
      best = Math.min(best, Math.hypot(x - a[0] - t * dx, y - a[1] - t * dy));
    }
  }
  return best;
}

/**
 * Draw the label as woven damask: light weft floats over a dark ground, one thread at a time.
 * @returns {{width: number, height: number, pixels: Uint8Array}} sRGB rows.
 */
export function drawLabel() {
  const xHeight = 0.0046;
  const word = wordStrokes(xHeight);
  const left = (LABEL.width - word.width) / 2;
  const base = LABEL.height / 2 - xHeight * 0.62;
  const pixels = new Uint8Array(WIDTH * HEIGHT * 3);
  const [ground, ink] = [
    [0.022, 0.021, 0.022],
    [0.74, 0.69, 0.6],
  ];
  for (let row = 0; row < HEIGHT; row++) {
    const y = LABEL.height * (1 - (row + 0.5) / HEIGHT);
    const thread = 0.86 + 0.14 * Math.sin((2 * Math.PI * y) / THREAD) ** 2;
    for (let column = 0; column < WIDTH; column++) {
      const x = (LABEL.width * (column + 0.5)) / WIDTH;
      const distance = distanceToStrokes(word.strokes, x - left, y - base);
      const share = Math.min(1, Math.max(0, 0.5 + (0.00042 - distance) / 1.2e-4));
      for (let c = 0; c < 3; c++) {
        const value = (ground[c] + (ink[c] - ground[c]) * share) * thread;
        pixels[(row * WIDTH + column) * 3 + c] = Math.round(encodeSrgb(value) * 255);
      }
    }
  }
  return { width: WIDTH, height: HEIGHT, pixels };
}
