import { seeded } from '../random.mjs';
import { TILE } from './knit.mjs';

const wrap = (i, size) => ((i % size) + size) % size;

function boxBlur(values, size, radius) {
  const pass = (from, horizontal) => {
    const to = new Float64Array(from.length);
    for (let line = 0; line < size; line++) {
      const at = (i) => (horizontal ? line * size + wrap(i, size) : wrap(i, size) * size + line);
      let sum = 0;
      for (let i = -radius; i <= radius; i++) sum += from[at(i)];
      for (let i = 0; i < size; i++) {
        to[at(i)] = sum / (2 * radius + 1);
        sum += from[at(i + radius + 1)] - from[at(i - radius)];
      }
    }
    return to;
  };
  return pass(pass(values, true), false);
}

/** sRGB encoding of a linear value in 0..1. src: IEC 61966-2-1 */
export function encodeSrgb(linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
}

const toByte = (value) => Math.min(255, Math.max(0, Math.round(value * 255)));

// How deep a texel lies below its neighbourhood, 0 open .. 1 buried.
function cavityOf({ height, size }, texel) {
  const near = boxBlur(boxBlur(height, size, Math.round(1.2e-4 / texel)), size, Math.round(1.2e-4 / texel));
  const wide = boxBlur(boxBlur(height, size, Math.round(5e-4 / texel)), size, Math.round(5e-4 / texel));
  return height.map((h, i) => Math.min(1, Math.max(0, (near[i] - h) / 1.6e-4) * 0.6 + Math.max(0, (wide[i] - h) / 3.5e-4) * 0.5));
}

function shrink(values, size, channels, factor) {
  const small = size / factor;
  const out = new Float64Array(small * small * channels);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const to = (Math.floor(y / factor) * small + Math.floor(x / factor)) * channels;
      for (let c = 0; c < channels; c++) out[to + c] += values[(y * size + x) * channels + c] / factor ** 2;
    }
  }
  return out;
}

/**
 * glTF texture bytes of a textile tile.
 * @param {{height, tone, size}} tile - Height in metres.
 * @param {object} options - `factor`: texels of the tile per texel of the maps; `slope`: share of the true
 *   slope that the normal map keeps; `roughness`: of the fibres; `seed`.
 * @returns {{size, surfaceSize, base: Uint8Array, normal: Uint8Array, surface: Uint8Array}} RGB rows: base colour (sRGB, mean
 *   near 0.9 linear), tangent-space normal (+Y up), occlusion-roughness-metallic (linear).
 */
export function textileMaps(tile, { factor = 2, slope = 0.55, roughness = 0.92, seed = 3 } = {}) {
  const { height, tone, size } = tile;
  const texel = TILE / size;
  const random = seeded(seed);
  const cavity = cavityOf(tile, texel);
  const normals = new Float64Array(size * size * 3);
  const base = new Float64Array(size * size);
  const surface = new Float64Array(size * size * 3);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      const at = y * size + x;
      const dx = ((height[y * size + wrap(x + 1, size)] - height[y * size + wrap(x - 1, size)]) / (2 * texel)) * slope;
      const dy = ((height[wrap(y - 1, size) * size + x] - height[wrap(y + 1, size) * size + x]) / (2 * texel)) * slope;
      const [nx, ny] = [Math.max(-1.6, Math.min(1.6, -dx)), Math.max(-1.6, Math.min(1.6, -dy))];
      const length = Math.hypot(nx, ny, 1);
      normals.set([nx / length, ny / length, 1 / length], at * 3);
      base[at] = 0.93 * tone[at] * (1 - 0.38 * cavity[at]) * (1 + (random() - 0.5) * 0.05);
      surface.set([1 - 0.6 * cavity[at], Math.min(1, roughness + 0.07 * cavity[at]), 0], at * 3);
    }
  }
  const small = size / factor;
  const baseSmall = shrink(base, size, 1, factor);
  return {
    size: small,
    base: Uint8Array.from({ length: small * small * 3 }, (_, i) => toByte(encodeSrgb(Math.min(1, baseSmall[Math.floor(i / 3)])))),
    normal: normalBytes(shrink(normals, size, 3, factor)),
    surfaceSize: small / 2,
    surface: Uint8Array.from(shrink(surface, size, 3, factor * 2), toByte),
    baseMean: baseSmall.reduce((a, b) => a + b) / baseSmall.length,
  };
}

function normalBytes(vectors) {
  const out = new Uint8Array(vectors.length);
  for (let i = 0; i < vectors.length; i += 3) {
    const length = Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]);
    for (let c = 0; c < 3; c++) out[i + c] = toByte((vectors[i + c] / length) * 0.5 + 0.5);
  }
  return out;
}
