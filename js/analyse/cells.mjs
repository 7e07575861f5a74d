import { toTelarError, TelarError } from '../error/index.mjs';
import { clothOf, difference, lookAt } from './differences.mjs';

/** Draws every target in every light with every shading, and compares. */

/** Pictures on their way at once: one is drawn while the next waits at the renderer's door. */
const IN_FLIGHT = 2;

/** A turn of the event loop between comparisons, so that a signal is heard. */
const breathe = () => new Promise((resolve) => setImmediate(resolve));

const named = (target, thrown) => {
  const error = toTelarError(thrown);
  return new TelarError(error.code, `${target.name}: ${error.message}`, error);
};

/** Shadings that are the same picture share one: keys by name, and the list of what to draw. */
function uniqueShadings(shadings) {
  const keys = new Map();
  const list = [];
  const keyOf = (shading) => JSON.stringify(typeof shading === 'string' ? shading : { ...shading, base: undefined });
  const names = Object.entries(shadings).map(([name, shading]) => {
    const key = keyOf(shading);
    if (!keys.has(key)) keys.set(key, list.push(shading) - 1);
    return [name, keys.get(key)];
  });
  return { list, indexOf: Object.fromEntries(names) };
}

async function drawAll(renderer, model, shots, { signal, step }) {
  const images = new Array(shots.length);
  const next = shots.entries();
  const work = async () => {
    for (const [i, shot] of next) {
      const { data, info } = await renderer.render(model, shot, { signal });
      images[i] = { width: shot.size.width, height: shot.size.height, data: new Uint8Array(data), warnings: info.warnings };
      step();
    }
  };
  await Promise.all(Array.from({ length: IN_FLIGHT }, work));
  return images;
}

/** The differences of one cell. */
async function compared(images, indexOf, cloth, terms, { signal, step }) {
  const looks = images.map(lookAt);
  const between = async (first, second) => {
    await breathe();
    signal?.throwIfAborted();
    const result = difference(looks[indexOf[first]], looks[indexOf[second]], cloth);
    step();
    return result;
  };
  const all = await between('from', 'to');
  const byTerm = {};
  for (const { slot } of terms) {
    byTerm[slot] = { alone: await between('from', `alone:${slot}`), rest: await between(`rest:${slot}`, 'to') };
  }
  return { all, terms: byTerm };
}

/** Steps that cellsOf counts off: one a picture and one a comparison. */
export function stepsOf({ targets, lights, swaps }) {
  const pictures = uniqueShadings(swaps.shadings).list.length;
  return targets.length * lights.length * (pictures + 1 + 2 * swaps.terms.length);
}

/**
 * @param {object} renderer of createRenderer
 * @param {object} plan
 * @param {import('./targets.mjs').Target[]} plan.targets
 * @param {Array<{name: string, shot: object}>} plan.lights
 * @param {import('./swaps.mjs').Swaps} plan.swaps
 * @param {object} plan.shot - Keys that all pictures share: size, quality.
 * @param {{signal?: AbortSignal, step?: (name: string) => void}} [options]
 * @returns {Promise<Array<import('./ranking.mjs').Cell & {images: Record<string, import('../compare/image.mjs').Image>, cloth:
 *   import('./differences.mjs').Cloth, warnings: object[]}>>} `images` by the names of swaps.shadings
 * @throws {TelarError} with the target's name in front; the signal's reason
 */
export async function cellsOf(renderer, { targets, lights, swaps, shot }, { signal, step = () => {} } = {}) {
  const { list, indexOf } = uniqueShadings(swaps.shadings);
  const cells = [];
  for (const target of targets) {
    try {
      const model = await renderer.load(target.source, { signal });
      for (const light of lights) {
        const options = { signal, step: () => step(`${target.name}, ${light.name}`) };
        const base = { ...shot, ...light.shot, ...target.shot, modelLights: false, background: 'transparent', output: { format: 'raw' } };
        cells.push({ target: target.name, light: light.name, ...(await cellOf(renderer, model, base, { list, indexOf, swaps }, options)) });
      }
      await renderer.release(model);
    } catch (thrown) {
      signal?.throwIfAborted();
      throw named(target, thrown);
    }
  }
  return cells;
}

async function cellOf(renderer, model, base, { list, indexOf, swaps }, options) {
  const images = await drawAll(renderer, model, list.map((shading) => ({ ...base, shading })), options);
  const facing = await renderer.renderQuantity(model, { ...base, quality: 'draft', shading: 'three' }, 'NoV', { signal: options.signal });
  const cloth = clothOf(images[0], facing.data);
  const figures = await compared(images, indexOf, cloth, swaps.terms, options);
  const byName = Object.fromEntries(Object.entries(indexOf).map(([name, index]) => [name, images[index]]));
  return { ...figures, cloth, images: byName, warnings: images[0].warnings };
}
