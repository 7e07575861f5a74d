import { clothOf, difference, lookAt } from './differences.mjs';
import { mayShow } from './shown_slots.mjs';

/** Draws a target in every light with every shading, and compares. */

/** Pictures on their way at once: one is drawn while the next waits at the renderer's door. */
const IN_FLIGHT = 2;

/** A turn of the event loop between comparisons, so that a signal is heard. */
const breathe = () => new Promise((resolve) => setImmediate(resolve));

/** Shadings that are the same picture share one: keys by name, and the list of what to draw. */
function uniqueShadings(shadings) {
  const keys = new Map();
  const list = [];
  const keyOf = (shading) => JSON.stringify(typeof shading === 'string' ? shading : { ...shading, base: undefined, revision: undefined });
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
      images[i] = { width: shot.size.width, height: shot.size.height, data: new Uint8Array(data), warnings: info.warnings, features: info.features };
      step();
    }
  };
  await Promise.all(Array.from({ length: IN_FLIGHT }, work));
  return images;
}

/** The differences of one cell. */
async function compared(images, indexOf, cloth, terms, { signal, step }) {
  const looks = images.map((image) => lookAt(image, cloth));
  const between = async (first, second) => {
    await breathe();
    signal?.throwIfAborted();
    const result = difference(looks[indexOf[first]], looks[indexOf[second]], cloth);
    step();
    return result;
  };
  const { figures: all, map } = await between('from', 'to');
  const byTerm = {};
  for (const { slot } of terms) {
    const [alone, rest] = [await between('from', `alone:${slot}`), await between(`rest:${slot}`, 'to')];
    byTerm[slot] = { alone: alone.figures, rest: rest.figures };
  }
  return { all, map, terms: byTerm };
}

/** Steps that cellsOf counts off for all targets: one a picture and one a comparison. */
export function stepsOf({ targets, lights, swaps }) {
  const pictures = uniqueShadings(swaps.shadings).list.length;
  return targets.length * lights.length * (pictures + 1 + 2 * swaps.terms.length);
}

/**
 * @param {object} renderer of createRenderer
 * @param {object} model - The target, loaded.
 * @param {import('./targets.mjs').Target} target
 * @param {object} plan
 * @param {Array<{name: string, shot: object}>} plan.lights
 * @param {import('./swaps.mjs').Swaps} plan.swaps
 * @param {object} plan.shot - Keys that all pictures share: size, quality.
 * @param {{signal?: AbortSignal, step: (name: string) => void}} options
 * @returns {Promise<Array<import('./ranking.mjs').Cell & {map: Float32Array, images: Record<string,
 *   import('../compare/image.mjs').Image>, cloth: import('./differences.mjs').Cloth, warnings: object[]}>>} One a light. `map`: FLIP of
 *   `all` at each pixel; `images` by the names of swaps.shadings
 * @throws what drawing throws; the signal's reason
 */
export async function cellsOf(renderer, model, target, { lights, swaps, shot }, { signal, step }) {
  const { list, indexOf } = uniqueShadings(swaps.shadings);
  const cells = [];
  for (const light of lights) {
    const options = { signal, step: () => step(`${target.name}, ${light.name}`) };
    const base = { ...shot, ...light.shot, ...target.shot, modelLights: false, background: 'transparent', output: { format: 'raw' } };
    cells.push({ target: target.name, light: light.name, ...(await cellOf(renderer, model, base, { list, indexOf, swaps }, options)) });
  }
  return cells;
}

/** By slot, the pictures that a swap in it gives, and those that stand for them where it cannot show. */
const swapsOf = (slot) => [
  [`alone:${slot}`, 'from'],
  [`rest:${slot}`, 'to'],
];

/** Pictures by index; a slot that the model in this light does not have is not drawn again. */
async function imagesOf(renderer, model, base, { list, indexOf, swaps }, options) {
  const images = new Array(list.length);
  const draw = async (indices) => {
    const shots = indices.map((index) => ({ ...base, shading: list[index] }));
    for (const [i, image] of (await drawAll(renderer, model, shots, options)).entries()) images[indices[i]] = image;
  };
  const ends = [...new Set([indexOf.from, indexOf.to])];
  await draw(ends);
  const features = ends.flatMap((index) => images[index].features);
  const isHidden = new Map();
  for (const { slot } of swaps.terms) {
    if (mayShow(slot, features)) continue;
    for (const [swapped, end] of swapsOf(slot)) if (!images[indexOf[swapped]]) isHidden.set(indexOf[swapped], indexOf[end]);
  }
  await draw([...list.keys()].filter((index) => !images[index] && !isHidden.has(index)));
  for (const [index, end] of isHidden) {
    images[index] = images[end];
    options.step();
  }
  return images;
}

async function cellOf(renderer, model, base, plan, options) {
  const { indexOf, swaps } = plan;
  const images = await imagesOf(renderer, model, base, plan, options);
  const facing = await renderer.renderQuantity(model, { ...base, quality: 'draft', shading: 'three' }, 'NoV', { signal: options.signal });
  const cloth = clothOf(images[indexOf.from], facing.data);
  const figures = await compared(images, indexOf, cloth, swaps.terms, options);
  const byName = Object.fromEntries(Object.entries(indexOf).map(([name, index]) => [name, images[index]]));
  return { ...figures, cloth, images: byName, warnings: images[indexOf.from].warnings };
}
