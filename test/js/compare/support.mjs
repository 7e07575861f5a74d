/** Pictures for the tests. */

/** @param {(x: number, y: number) => number[]} colour RGBA of a pixel */
export function draw(width, height, colour) {
  const data = new Uint8Array(width * height * 4);
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) data.set(colour(x, y), (y * width + x) * 4);
  return { width, height, data };
}

export const flat = (width, height, colour) => draw(width, height, () => colour);

/** Numbers in [0, 1), the same ones each time (Park and Miller's generator). */
function randoms(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

/** Opaque noise. */
export function noise(width, height, seed) {
  const random = randoms(seed);
  return draw(width, height, () => [0, 0, 0, 255].map((alpha) => alpha || Math.floor(random() * 256)));
}

/** A grey opaque square in a transparent frame: [4, size - 4) both ways. */
export const square = (size, grey = 100) =>
  draw(size, size, (x, y) => (Math.min(x, y) >= 4 && Math.max(x, y) < size - 4 ? [grey, grey, grey, 255] : [0, 0, 0, 0]));

/** The same picture with one pixel changed. */
export function withPixel(image, x, y, colour) {
  const data = Uint8Array.from(image.data);
  data.set(colour, (y * image.width + x) * 4);
  return { ...image, data };
}
