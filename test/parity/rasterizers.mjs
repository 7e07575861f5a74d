import { interiorDistances } from './metrics.mjs';

/** telar may be this much farther from the client on another rasteriser than the client is from itself there. */
export const ALLOWANCE = 0.1;

/**
 * How far the pictures of one GL are from the client's on another one.
 * @typedef {object} Distances
 * @property {import('./metrics.mjs').Region} client - The client from itself.
 * @property {import('./metrics.mjs').Region} telar - telar from the client.
 * @property {boolean} pass - telar's mean and 99.9th percentile are at most ALLOWANCE above the client's.
 */

/**
 * @param {import('./metrics.mjs').Pictures} pictures - `expected` of the client and `actual` of telar, on one GL.
 * @param {Uint8Array} second - The client's on the other GL.
 * @returns {Distances} Of the interior.
 */
export function rasterizerDistances(pictures, second) {
  const [client, telar] = interiorDistances(pictures, second, [pictures.expected, pictures.actual]);
  const within = (figure) => telar[figure] <= client[figure] * (1 + ALLOWANCE);
  return { client, telar, pass: Boolean(client) && within('mean') && within('p999') };
}
