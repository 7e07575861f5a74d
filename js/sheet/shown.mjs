import { TelarError } from '../error/index.mjs';
import { pathText, pointerText } from '../shot/complain.mjs';
import { ABOUT } from './read.mjs';

/** What each view of a spec shows: the model, or its parts moved apart, without what the view leaves out. */

/**
 * An error of a view's `ghost`, at its place in the spec; others as they are.
 * @param {unknown} thrown
 * @param {number} view index in the spec
 */
export function ofView(thrown, view) {
  const [, ghost] = (thrown.code === 'E_FRAME' && /^\/ghost\/(\d+)$/.exec(thrown.pointer)) || [];
  if (ghost === undefined) return thrown;
  const path = ['views', view, 'ghost', Number(ghost)];
  const what = thrown.message.slice(thrown.message.indexOf('the model draws'));
  return new TelarError(ABOUT.code, `${pathText(path, ABOUT)}: ${what}`, { pointer: pointerText(path), cause: thrown });
}

/**
 * @param {object[]} views of a spec
 * @param {object} model loaded
 * @param {{renderer: object, facts: object, signal?: AbortSignal}} context facts: of the model
 * @returns {Promise<{model: object, facts: object}[]>} by index
 * @throws {TelarError} E_SPEC where the model lacks a ghost that a view leaves out
 */
export async function shownBy(views, model, { renderer, facts, signal }) {
  const exploded = new Map();
  const shown = [];
  for (const [i, { explode, ghost, variant }] of views.entries()) {
    if (explode > 0 && !exploded.has(explode)) exploded.set(explode, await model.explode(explode, { signal }));
    const seen = exploded.get(explode) ?? model;
    if (seen === model && ghost.length === 0) {
      shown.push({ model, facts });
      continue;
    }
    try {
      shown.push({ model: seen, facts: await renderer.factsOf(seen, { ghost, variant }, { signal }) });
    } catch (thrown) {
      throw ofView(thrown, i);
    }
    if (!shown[i].facts.bounds) {
      const path = ['views', i, 'ghost'];
      throw new TelarError(ABOUT.code, `${pathText(path, ABOUT)}: expected one that leaves a part of the model to be seen`, { pointer: pointerText(path) });
    }
  }
  return shown;
}
