import { stat } from 'node:fs/promises';
import path from 'node:path';
import { readImage, shrinkImage, sizeFactor } from '../compare/index.mjs';
import { FIGURES, limitNamed, REGIONS } from '../compare/gates.mjs';
import { TelarError } from '../error/index.mjs';
import { nearest, shown } from '../shot/complain.mjs';
import { named } from './compare_pair.mjs';

/** Thresholds and masks of `telar compare`. */

const usage = (message) => new TelarError('E_USAGE', message);

/**
 * "object.flip.mean=0.02" as limits of the gate.
 * @param {string[]} [assignments]
 * @returns {Record<string, number>}
 * @throws {TelarError} E_USAGE
 */
export function readThresholds(assignments = []) {
  return Object.fromEntries(
    assignments.map((assignment) => {
      const match = /^([\w.]+)=(\d+(?:\.\d+)?)$/.exec(assignment);
      if (!match) throw usage(`--threshold: expected REGION.FIGURE=N, as in object.flip.mean=0.02, got ${shown(assignment)}`);
      const [, name, limit] = match;
      if (!limitNamed(name)) {
        const near = nearest(
          name,
          REGIONS.flatMap((region) => FIGURES.map((figure) => `${region}.${figure}`)),
        );
        throw usage(
          `--threshold ${shown(name)}: ${near ? `did you mean ${near}?` : `expected one of ${REGIONS.join(', ')}, a point, and one of ${FIGURES.join(', ')}`}`,
        );
      }
      return [name, Number(limit)];
    }),
  );
}

const AREA = /^(\d+),(\d+),(\d+),(\d+)$/;

/**
 * Every file that --mask and --ignore may mean.
 * @param {{mask?: string, ignore?: string[]}} options
 * @param {string[]} [names] of pictures, where two folders are compared
 * @returns {import('./overwritten.mjs').Named[]}
 */
export function maskFiles({ mask, ignore = [] }, names = []) {
  const given = [{ file: mask, what: 'the mask' }, ...ignore.filter((text) => !AREA.test(text)).map((file) => ({ file, what: 'what --ignore names,' }))];
  return given.filter(({ file }) => file !== undefined).flatMap((one) => [one, ...names.map((name) => ({ ...one, file: path.join(one.file, name) }))]);
}

/** Where a mask of a picture lies: itself a file for all, or a folder with one of the same name. */
async function maskFile(option, given, name) {
  const found = await stat(given).catch((cause) => {
    throw new TelarError('E_FILE', `${option} ${shown(given)} cannot be read (${cause.code})`, { cause });
  });
  if (!found.isDirectory()) return given;
  if (name === undefined) throw usage(`${option} ${shown(given)} is a folder: it goes with two folders of images`);
  const file = path.join(given, name);
  return (await stat(file).catch(() => undefined)) ? file : undefined;
}

/** Where a picture of a mask is neither black nor transparent. */
function whereLight({ data }) {
  const light = new Uint8Array(data.length / 4);
  for (let p = 0; p < light.length; p++) {
    const i = p * 4;
    light[p] = data[i + 3] > 0 && data[i] + data[i + 1] + data[i + 2] > 0 ? 1 : 0;
  }
  return light;
}

async function readMask(option, file, size, context) {
  let image;
  try {
    image = await readImage(file, context);
  } catch (thrown) {
    throw named(file, thrown);
  }
  const isLarger = sizeFactor(size, image)?.larger === 'actual';
  const fitting = isLarger ? shrinkImage(image, size) : image;
  if (fitting.width === size.width && fitting.height === size.height) return whereLight(fitting);
  throw new TelarError(
    'E_IMAGE_SIZE',
    `${option} ${shown(path.basename(file))} has ${image.width}x${image.height} pixels, the images ${size.width}x${size.height}: draw it at their size`,
  );
}

/** Sets what lies in a rectangle; what leaves the picture is cut. */
function setArea(map, { width, height }, [left, top, across, down]) {
  for (let y = top; y < Math.min(height, top + down); y++) map.fill(1, y * width + Math.min(width, left), y * width + Math.min(width, left + across));
}

/**
 * The masks of --mask and --ignore.
 * @param {{mask?: string, ignore?: string[]}} options
 * @param {{limits: object, signal?: AbortSignal}} context
 * @returns {(name?: string) => (size: {width: number, height: number}) => Promise<{mask?: Uint8Array, ignore?: Uint8Array}>} by the name
 *   of a picture in its folder, then by its size
 */
export function maskReader({ mask, ignore = [] }, context) {
  const readers = { mask: (file, size) => readMask('--mask', file, size, context), ignore: (file, size) => readMask('--ignore', file, size, context) };
  return (name) => async (size) => {
    const found = {};
    const file = mask === undefined ? undefined : await maskFile('--mask', mask, name);
    if (file) found.mask = await readers.mask(file, size);
    for (const each of ignore) {
      found.ignore ??= new Uint8Array(size.width * size.height);
      const area = AREA.exec(each);
      if (area) {
        setArea(found.ignore, size, area.slice(1).map(Number));
        continue;
      }
      const ignored = await maskFile('--ignore', each, name);
      if (!ignored) continue;
      (await readers.ignore(ignored, size)).forEach((value, p) => {
        found.ignore[p] |= value;
      });
    }
    if (found.ignore && !found.ignore.includes(0)) throw usage('--ignore leaves no pixel to compare');
    return found;
  };
}
