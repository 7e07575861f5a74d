import { resolveCamera } from './camera.mjs';
import { shown, wrongValue } from './complain.mjs';
import { TINY } from './table/rows.mjs';

/** Pictures in true scale: an orthographic camera whose millimetres per pixel are exact. Pure. */

/** Millimetres of an inch. */
export const INCH = 25.4;

/** Sides of a picture, pixels, as the shot takes them. */
export const PIXELS_MAX = 8192;

/** "1:5" = 5, "2:1" = 0.5: millimetres of the model on one of paper. @param {string} text */
export function ratioOf(text) {
  const [paper, model] = text.split(':').map(Number);
  return model / paper;
}

/**
 * @param {number} ratio millimetres of the model on one of paper
 * @param {number} ppi pixels per inch of paper
 * @returns {number} metres of the model on one pixel
 */
export const metresPerPixelOf = (ratio, ppi) => (INCH / ppi / 1000) * ratio;

/** An aspect so far from 1 that the other side of the frame does not count. */
const WIDE = 1e9;

/**
 * Size and camera of a shot with a scale; as they are without one.
 * @param {{scale: string, size: {width: number, height: number}, camera: object, output: {ppi: number}}} parsed
 * @param {{hasSize: boolean, facts: object, standing: object}} known hasSize: whether the caller gave a size; standing: of resolveCamera
 * @returns {{size: {width: number, height: number}, camera: object}} camera: explicit
 */
export function resolveScale({ scale, size: given, camera, output }, { hasSize, facts, standing }) {
  const cameraFor = (wanted, aspect, trueHeight) => resolveCamera(wanted, aspect, facts, { ...standing, trueHeight });
  if (scale === 'none') return { size: given, camera: cameraFor(camera, given.width / given.height) };
  const ratio = ratioOf(scale);
  if (!(ratio >= 1e-3 && ratio <= 1e4)) throw wrongValue(['scale'], '"none", or a scale from "1000:1" to "1:10000"', scale);
  if (!(output.ppi > 0)) throw wrongValue(['output', 'ppi'], `pixels per inch above 0 with scale ${shown(scale)}`, output.ppi);
  if (camera.gltf !== undefined) throw wrongValue(['camera'], `a view or an explicit camera with scale ${shown(scale)}`, camera);
  const metresPerPixel = metresPerPixelOf(ratio, output.ppi);
  if (camera.position !== undefined) return { size: given, camera: cameraFor(placedAt(camera, given.height * metresPerPixel), given.width / given.height) };
  const framed = { ...camera, projection: 'orthographic' };
  const size = hasSize ? given : sizeOf(framed, cameraFor, metresPerPixel, scale);
  const height = Math.max(size.height * metresPerPixel, TINY);
  return { size, camera: { ...cameraFor(framed, size.width / size.height, height), height } };
}

/** An explicit camera that sees so many metres. */
function placedAt(camera, height) {
  const { projection = 'orthographic', height: wanted = height } = camera;
  if (projection !== 'orthographic') throw wrongValue(['camera', 'projection'], '"orthographic" with a scale', projection);
  if (!(Math.abs(wanted / height - 1) <= 1e-9)) throw wrongValue(['camera', 'height'], `${height} metres, as size, scale and output.ppi say, or none`, wanted);
  return { ...camera, projection, height };
}

/** Pixels that a view needs with `fit`. */
function sizeOf(framed, cameraFor, metresPerPixel, scale) {
  const metres = { width: cameraFor(framed, 1 / WIDE).height / WIDE, height: cameraFor(framed, WIDE).height };
  const pixels = (length) => Math.max(1, Math.ceil((length / metresPerPixel) * (1 - 1e-9)));
  const size = { width: pixels(metres.width), height: pixels(metres.height) };
  if (Math.max(size.width, size.height) > PIXELS_MAX) {
    throw wrongValue(['scale'], `a scale at which the picture has at most ${PIXELS_MAX} pixels a side; this one has ${size.width} x ${size.height}`, scale);
  }
  return size;
}
