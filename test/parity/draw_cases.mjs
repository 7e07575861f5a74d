import { loadInputs } from './inputs.mjs';

/** Cases on their way at once: one in the browser, one on the server, one compared, and one that waits. */
const AHEAD = 4;

/**
 * What draws and what compares.
 * @typedef {object} Sides
 * @property {import('./browser/chromium.mjs').Browser} browser
 * @property {{draw: Function}} [server] - Of server.mjs; without it only the browser draws.
 * @property {import('./browser/chromium.mjs').Browser} [other] - The browser on another rasteriser.
 * @property {import('./comparer.mjs').Comparer} [comparer]
 *
 * A case that was drawn.
 * @typedef {object} Result
 * @property {import('./cases.mjs').Case} item
 * @property {Error} [error] - Why it could not be drawn; then nothing below is there.
 * @property {{model: Uint8Array | string, environment: Uint8Array | undefined, bundled: boolean}} inputs - Of inputs.mjs.
 * @property {{width: number, height: number, image: Uint8Array, mask: Uint8Array, facts: object}} expected - The browser's,
 *   premultiplied.
 * @property {Uint8Array} [actual] - The server's, premultiplied.
 * @property {import('./metrics.mjs').Difference} [difference]
 * @property {import('./rasterizers.mjs').Distances} [rasterizers]
 * @property {Record<string, number>} milliseconds - By what they were spent on; they overlap.
 */

/**
 * Draws cases on all sides and compares, several on their way at once.
 * @param {import('./cases.mjs').Case[]} cases
 * @param {Sides} sides
 * @returns {AsyncGenerator<Result>} In the order of the cases. One that cannot be drawn has `error`.
 */
export async function* drawCases(cases, sides) {
  const ahead = [];
  for (const item of cases) {
    ahead.push(drawCase(item, sides));
    if (ahead.length >= AHEAD) yield await ahead.shift();
  }
  for (const result of ahead) yield await result;
}

/** @returns {Promise<Result>} Never rejects. */
async function drawCase(item, { browser, server, other, comparer }) {
  const milliseconds = {};
  const timed = async (name, job) => {
    const begin = performance.now();
    const value = await job;
    milliseconds[name] = performance.now() - begin;
    return value;
  };
  try {
    const inputs = await timed('inputs', loadInputs(item));
    const input = { shot: item.shot, textures: item.textures, ...inputs };
    const [expected, actual, second] = await Promise.all([browser.draw(input), timed('server', server?.draw(input)), other?.draw(input)]);
    Object.assign(milliseconds, { load: expected.facts.loadMs, browser: expected.facts.drawMs });
    const found = actual && (await timed('compare', comparer.compare(item, expected, actual, second?.image)));
    return { item, inputs, expected, actual, ...found, milliseconds };
  } catch (error) {
    return { item, error, milliseconds };
  }
}
