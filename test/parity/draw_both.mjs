import { saveReference } from './files.mjs';
import { loadInputs } from './inputs.mjs';
import { difference } from './metrics.mjs';

/**
 * Draws a case in the browser and on the server and compares; keeps the browser's picture (files.mjs).
 * @param {import('./cases.mjs').Case} item
 * @param {import('./browser/chromium.mjs').Browser} browser
 * @param {{draw: Function}} server - Of server.mjs.
 * @returns {Promise<{expected: object, actual: Uint8Array, difference: import('./metrics.mjs').Difference}>} Premultiplied.
 */
export async function drawBoth(item, browser, server) {
  const { inputs, expected } = await drawInBrowser(item, browser);
  const actual = await server.draw({ shot: item.shot, ...inputs });
  return { expected, actual, difference: compareCase(item, expected, actual) };
}

/** Draws a case in the browser alone and keeps its picture. */
export async function drawInBrowser(item, browser) {
  const inputs = await loadInputs(item);
  const expected = await browser.draw({ shot: item.shot, ...inputs });
  saveReference(item, inputs, expected);
  return { inputs, expected };
}

/** Difference of a case's pictures; beside the object only where the shot draws a background. */
export function compareCase(item, { image, mask, width, height }, actual) {
  return difference({ expected: image, actual, mask, width, height, background: item.shot.background !== 'transparent' });
}
