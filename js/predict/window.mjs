import { cross, dot, sub, unit } from './vectors.mjs';

/** A window of a picture: as many pixels as a path tracer can draw without noise in reasonable time, at the scale of the whole. */

/** Part of a window that the model is to cover: its outline counts, and does not drown the surface. */
const COVERAGE = 0.8;

const along = (origin, ...steps) => steps.reduce((point, [direction, length]) => point.map((x, i) => x + direction[i] * length), origin);

/**
 * Where the window lies: of all that overlap by half, the one whose part of model is nearest to COVERAGE; of equals the one nearest to the middle.
 * @param {Uint8Array} data RGBA of the picture, transparent beside the model
 * @param {{width: number, height: number}} size pixels of the picture
 * @param {number} side pixels of the window
 * @returns {{x: number, y: number, width: number, height: number, coverage: number}} pixels from the top left corner; coverage: mean alpha, 0..1
 */
export function windowOf(data, { width, height }, side) {
  const [w, h] = [Math.min(side, width), Math.min(side, height)];
  const sums = summedAlpha(data, width, height);
  const row = width + 1;
  const found = [];
  for (const y of starts(height, h)) {
    for (const x of starts(width, w)) {
      const sum = sums[(y + h) * row + x + w] - sums[y * row + x + w] - sums[(y + h) * row + x] + sums[y * row + x];
      const aside = Math.hypot(x + w / 2 - width / 2, y + h / 2 - height / 2) / Math.hypot(width, height);
      found.push({ x, y, width: w, height: h, coverage: sum / (w * h * 255), aside });
    }
  }
  const off = ({ coverage, aside }) => Math.abs(coverage - COVERAGE) + 0.1 * aside;
  const { aside: _, ...best } = found.reduce((a, b) => (off(b) < off(a) ? b : a));
  return best;
}

const starts = (whole, part) => {
  const step = Math.max(1, Math.floor(part / 2));
  return Array.from({ length: Math.floor((whole - part) / step) + 1 }, (_, i) => i * step);
};

function summedAlpha(data, width, height) {
  const row = width + 1;
  const sums = new Float64Array(row * (height + 1));
  for (let y = 0; y < height; y++) {
    for (let x = 0, line = 0; x < width; x++) {
      line += data[(y * width + x) * 4 + 3];
      sums[(y + 1) * row + x + 1] = sums[y * row + x + 1] + line;
    }
  }
  return sums;
}

/**
 * The camera that draws a window at the scale of the whole picture.
 * @param {object} camera of a resolved shot
 * @param {{width: number, height: number}} size of the whole, pixels
 * @param {{x: number, y: number, width: number, height: number}} window pixels
 * @returns {object}
 */
export function windowCamera(camera, size, window) {
  const { position, target, up } = camera;
  const distance = Math.hypot(...sub(target, position));
  const forward = unit(sub(target, position));
  const right = unit(cross(forward, up));
  const above = cross(right, forward);
  // Of half the picture's height, from its middle.
  const dx = (2 * (window.x + window.width / 2) - size.width) / size.height;
  const dy = (size.height - 2 * (window.y + window.height / 2)) / size.height;
  const part = window.height / size.height;
  if (camera.projection === 'orthographic') {
    const half = camera.height / 2;
    const moved = (point) => along(point, [right, dx * half], [above, dy * half]);
    return { ...camera, position: moved(position), target: moved(target), height: camera.height * part };
  }
  const half = Math.tan((camera.fovY * Math.PI) / 360);
  const ray = along(forward, [right, dx * half], [above, dy * half]);
  const stretch = Math.hypot(...ray);
  const direction = unit(ray);
  return {
    ...camera,
    target: along(position, [direction, distance]),
    fovY: (360 / Math.PI) * Math.atan((half * part) / stretch),
    // Depth is along another axis.
    near: camera.near * Math.max(0.1, dot(direction, forward) - Math.abs(half)),
    far: camera.far * 2,
  };
}
