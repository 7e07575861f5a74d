import { clamp, fract, mod, noiseAt, octaves, step, TAU } from './noise.mjs';

/** Knits: x runs over wales, y over courses, down. */

/** Two legs of a loop lean against each other; 0..1 above the ground. `jitter`: how far loops differ. */
function loops(x, y, threads, jitter, seed) {
  const [i, j] = [mod(Math.floor(x), threads), mod(Math.floor(y), threads)];
  const own = jitter * (noiseAt(i, j, seed) - 0.5);
  const leg = (side) => {
    const size = 0.27 * (1 + jitter * (noiseAt(i, j, seed + side + 2) - 0.5));
    const across = fract(x) - 0.5 + 0.3 * own - side * (0.24 + 0.07 * Math.cos(TAU * y));
    const d = (across + side * 0.22 * (fract(y) - 0.5)) / size;
    return Math.abs(d) < 1 ? Math.sqrt(1 - d * d) * (0.8 + 0.2 * Math.cos(TAU * (y - 0.25))) : 0;
  };
  return Math.max(leg(-1), leg(1)) * (1 + 0.5 * own);
}

const point = (height, shade) => ({ height, warp: 1, slope: 0, turn: 0, shade: clamp(shade) });

export const singleJersey = (threads) => (x, y) => {
  const up = loops(x, y, threads, 0.3, 81);
  const course = 0.05 * (noiseAt(0, mod(Math.floor(y), threads), 86) - 0.5);
  return point(0.5 * up, 0.62 + 0.25 * up + course);
};

/** Two wales stand up, two lie back. */
export const rib = (threads) => (x, y) => {
  const wave = Math.cos((TAU * (x - 1)) / 4);
  const ridge = step(-0.75, 0.55, wave);
  const up = loops(x, y, threads, 0.35, 91);
  return point(1.5 * ridge + 0.4 * up * (0.35 + 0.65 * ridge), 0.22 + 0.5 * ridge + 0.22 * up * (0.3 + 0.7 * ridge));
};

/** Ropes of two strands on purl, `apart` wales from each other; a strand crosses the other every `cross` courses. */
export const cable =
  (threads, apart = 12, cross = 8) =>
  (x, y) => {
    const u = fract(x / apart) * apart - apart / 2;
    const turn = (TAU * y) / (2 * cross);
    const purl = 0.3 * Math.abs(Math.cos(TAU * 0.5 * (x + 0.5 * mod(Math.floor(y), 2)))) * Math.abs(Math.sin((TAU * y) / 2));
    let [height, shade] = [purl, 0.34 + 0.5 * purl];
    const raise = (d, base, rise) => {
      if (Math.abs(d) >= 1) return;
      const body = Math.sqrt(1 - d * d);
      const leg = 2 * Math.abs(fract(1.5 * (d + 1)) - 0.5);
      const stitch = 0.5 + 0.5 * Math.cos(TAU * (y - 0.5 * leg));
      const gap = 0.5 + 0.5 * Math.cos(TAU * 1.5 * d);
      const top = base + rise * body + 0.28 * stitch * body + 0.1 * gap;
      if (top > height) [height, shade] = [top, 0.3 + 0.38 * body + 0.2 * stitch * body + 0.04 * base];
    };
    for (const sign of [-1, 1]) raise((u - sign * 1.5 * Math.sin(turn)) / 1.65, 0.8 + 0.6 * sign * Math.cos(turn), 1.3);
    for (const sign of [-1, 1]) raise((u - sign * 4.6) / 0.6, 0.4, 0.6);
    return point(height, shade + 0.06 * octaves(x / threads, y / threads, [threads, threads], 2, 95));
  };

/** Athletic mesh: round holes in offset rows between which the knit is drawn together. */
export const athletic = (threads) => (x, y) => {
  const row = Math.floor(2 * y);
  let nearest = 9;
  for (let r = row - 1; r <= row + 2; r++) {
    const first = Math.floor(x) - 1 + 0.5 * mod(r, 2);
    for (let c = first; c < first + 4; c++) nearest = Math.min(nearest, Math.hypot(x - c, (y - r / 2) * 1.15));
  }
  const fine = loops(4 * x, 4 * y, 4 * threads, 0.2, 101);
  const lip = step(0.2, 0.42, nearest);
  return { ...point(0.22 * lip + 0.05 * fine, 0.55 + 0.2 * lip + 0.2 * fine), cover: nearest > 0.19 ? 1 : 0 };
};
