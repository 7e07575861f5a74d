import sharp from 'sharp';
import { seeded } from '../random.mjs';

/** Surfaces of four fabrics as tileable height fields, and their normal maps. Coordinates run over 0..1 and wrap. */

const SIZE = 192;
const wrap = (x) => x - Math.floor(x);
const smooth = (t) => t * t * (3 - 2 * t);

/** Smooth noise of `cells` cells a side, about 0. */
function noise(cells, seed) {
  const random = seeded(seed);
  const values = Float64Array.from({ length: cells * cells }, () => random() * 2 - 1);
  const at = (i, j) => values[(((j % cells) + cells) % cells) * cells + (((i % cells) + cells) % cells)];
  return (u, v) => {
    const [x, y] = [wrap(u) * cells, wrap(v) * cells];
    const [i, j] = [Math.floor(x), Math.floor(y)];
    const [a, b] = [smooth(x - i), smooth(y - j)];
    return (at(i, j) * (1 - a) + at(i + 1, j) * a) * (1 - b) + (at(i, j + 1) * (1 - a) + at(i + 1, j + 1) * a) * b;
  };
}

/** Distances to the nearest and second nearest of points, one in each of `cells` x `cells` cells, in cells. */
function cellular(cells, seed) {
  const random = seeded(seed);
  const points = Array.from({ length: cells * cells }, () => [0.15 + 0.7 * random(), 0.15 + 0.7 * random()]);
  return (u, v) => {
    const [x, y] = [wrap(u) * cells, wrap(v) * cells];
    const [i, j] = [Math.floor(x), Math.floor(y)];
    let [first, second] = [9, 9];
    for (let dj = -1; dj <= 1; dj++) {
      for (let di = -1; di <= 1; di++) {
        const [px, py] = points[((j + dj + cells) % cells) * cells + ((i + di + cells) % cells)];
        const distance = Math.hypot(i + di + px - x, j + dj + py - y);
        if (distance < first) [first, second] = [distance, first];
        else second = Math.min(second, distance);
      }
    }
    return [first, second];
  };
}

/** Grain: pebbles between creases. */
function leather() {
  const [cell, bend] = [cellular(26, 21), noise(13, 22)];
  return (u, v) => {
    const [first, second] = cell(u + 0.012 * bend(u, v), v + 0.012 * bend(v, u));
    return 0.9 * smooth(Math.min(1, (second - first) / 0.35)) + 0.12 * bend(2 * u, 2 * v);
  };
}

/** Ribs of a 2/2 twill, roughened by fibres. */
function wool() {
  const [fibre, bend] = [noise(64, 31), noise(16, 32)];
  return (u, v) => {
    const rib = 0.5 + 0.5 * Math.cos(2 * Math.PI * (20 * (u + v) + 0.35 * bend(u, v)));
    const yarn = 0.5 + 0.5 * Math.cos(2 * Math.PI * (40 * u + 0.3 * bend(v, u)));
    return 0.55 * rib + 0.2 * yarn + 0.3 * fibre(u, v);
  };
}

/** Loops of terry: round bumps, each a little off its place. */
function towel() {
  const [cell, fibre] = [cellular(44, 41), noise(88, 42)];
  return (u, v) => Math.exp(-((cell(u, v)[0] / 0.45) ** 2)) + 0.2 * fibre(u, v);
}

/** Pile that leans here and there. */
function velvet() {
  const [clump, fibre] = [noise(7, 51), noise(48, 52)];
  return (u, v) => 1.6 * clump(u, v) + 0.2 * fibre(u, v);
}

/** Height in units of 1 / steepness; `tile`: metres that one repeat covers. */
const RELIEFS = {
  leather: { height: leather, tile: 0.16, steepness: 0.011 },
  wool: { height: wool, tile: 0.12, steepness: 0.013 },
  towel: { height: towel, tile: 0.17, steepness: 0.0065 },
  velvet: { height: velvet, tile: 0.2, steepness: 0.006 },
};

/**
 * @param {keyof typeof RELIEFS} name
 * @returns {Promise<{image: Buffer, tile: number}>} JPEG of tangent-space normals (+Y up), metres that a repeat covers
 */
export async function reliefOf(name) {
  const { height: make, tile, steepness } = RELIEFS[name];
  const height = make();
  const pixels = Buffer.alloc(SIZE * SIZE * 3);
  for (let y = 0; y < SIZE; y++) {
    for (let x = 0; x < SIZE; x++) {
      const at = (dx, dy) => height((x + 0.5 + dx) / SIZE, (y + 0.5 + dy) / SIZE);
      const slope = [at(1, 0) - at(-1, 0), -(at(0, 1) - at(0, -1))].map((difference) => (difference / 2) * SIZE * steepness);
      const length = Math.hypot(...slope, 1);
      const normal = [-slope[0] / length, -slope[1] / length, 1 / length];
      normal.forEach((value, c) => {
        pixels[(y * SIZE + x) * 3 + c] = Math.round((value * 0.5 + 0.5) * 255);
      });
    }
  }
  const image = await sharp(pixels, { raw: { width: SIZE, height: SIZE, channels: 3 } })
    .jpeg({ quality: 74, chromaSubsampling: '4:4:4' })
    .toBuffer();
  return { image, tile };
}
