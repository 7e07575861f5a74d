import { channelDifference } from './channels.mjs';
import { checkPair, isOpaque, premultiply } from './image.mjs';

/** What explains a difference that is none of the drawing: how alpha was written, what stands behind. */

/** A cause explains a difference where undoing it leaves at most this part of it. */
const REST = 0.1;

/**
 * Mean over pixels of the largest channel difference of premultiplied RGBA, in 1/255.
 * @param {Uint8Array} first - RGBA8, straight alpha.
 * @param {Uint8Array} second - Of the same size.
 */
export function meanDifference(first, second) {
  const [a, b] = [premultiply(first), premultiply(second)];
  let sum = 0;
  for (let i = 0; i < a.length; i += 4) sum += channelDifference(a, b, i);
  return sum / (a.length / 4);
}

/** The colour that an opaque picture has most often where the other one is fully transparent; undefined where it is nowhere. */
function backgroundBehind(opaque, transparent) {
  const counts = new Map();
  for (let i = 0; i < opaque.length; i += 4) {
    if (transparent[i + 3] !== 0) continue;
    const colour = (opaque[i] << 16) | (opaque[i + 1] << 8) | opaque[i + 2];
    counts.set(colour, (counts.get(colour) ?? 0) + 1);
  }
  const [most] = [...counts].sort(([, a], [, b]) => b - a);
  return most?.[0];
}

/** A picture on a colour, in encoded values as web pages lay it. */
function onColour(pixels, colour) {
  const behind = [colour >> 16, (colour >> 8) & 255, colour & 255];
  return pixels.map((value, i) => {
    const alpha = pixels[i - (i % 4) + 3] / 255;
    return i % 4 === 3 ? 255 : Math.round(value * alpha + behind[i % 4] * (1 - alpha));
  });
}

const hex = (colour) => `#${colour.toString(16).padStart(6, '0')}`;

function backgroundHint({ expected, actual }, before) {
  const sides = { expected, actual };
  const opaque = Object.keys(sides).filter((side) => isOpaque(sides[side]));
  if (opaque.length !== 1) return undefined;
  const [side] = opaque;
  const other = side === 'expected' ? 'actual' : 'expected';
  const colour = backgroundBehind(sides[side], sides[other]);
  if (colour === undefined || meanDifference(onColour(sides[other], colour), sides[side]) > REST * before) return undefined;
  return { cause: 'background', message: `the ${other} picture is transparent where the ${side} one shows ${hex(colour)}: draw both on one background` };
}

function premultipliedHint({ expected, actual }, before) {
  for (const [side, pixels, other] of [
    ['actual', actual, expected],
    ['expected', expected, actual],
  ]) {
    if (meanDifference(premultiply(other), pixels) > REST * before) continue;
    return { cause: 'premultiplied', message: `the colours of the ${side} picture are multiplied by its alpha: save it with straight alpha, as PNG has it` };
  }
  return undefined;
}

function alphaHint({ expected, actual }, before) {
  const withAlpha = actual.map((value, i) => (i % 4 === 3 ? expected[i] : value));
  if (meanDifference(expected, withAlpha) > REST * before) return undefined;
  return { cause: 'alpha', message: 'the pictures differ in alpha, and hardly in colour' };
}

/**
 * What explains most of the difference of two pictures of one size, where it is alpha or the background.
 * @param {import('./image.mjs').Image} expected
 * @param {import('./image.mjs').Image} actual
 * @returns {Array<{cause: 'background' | 'premultiplied' | 'alpha', message: string}>} none for pictures that are equal, and
 *   where the drawing differs
 * @throws {import('../error/index.mjs').TelarError} E_OPTION, E_IMAGE_SIZE
 */
export function explainDifference(expected, actual) {
  checkPair(expected, actual);
  const pair = { expected: Uint8Array.from(expected.data), actual: Uint8Array.from(actual.data) };
  const before = meanDifference(pair.expected, pair.actual);
  if (before === 0) return [];
  const found = backgroundHint(pair, before) ?? premultipliedHint(pair, before) ?? alphaHint(pair, before);
  return found ? [found] : [];
}

/**
 * By how much one picture is larger than the other in both directions, as screenshots of dense screens are.
 * @param {{width: number, height: number}} expected
 * @param {{width: number, height: number}} actual
 * @returns {{larger: 'expected' | 'actual', factor: number} | null} null where the shapes differ, or nothing does
 */
export function sizeFactor(expected, actual) {
  if (expected.width === actual.width && expected.height === actual.height) return null;
  const larger = actual.width > expected.width ? 'actual' : 'expected';
  const [big, small] = larger === 'actual' ? [actual, expected] : [expected, actual];
  const factor = big.width / small.width;
  // Screens of 1.25 and 1.5 pixels a pixel round each side by itself.
  return factor > 1 && Math.abs(big.height / factor - small.height) < 1 ? { larger, factor } : null;
}
