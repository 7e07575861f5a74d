import { TelarError } from '../error/index.mjs';
import { pathText, pointerText } from '../shot/complain.mjs';
import { ABOUT } from './read.mjs';
import { basisOf, extentOf } from './scale.mjs';

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
 * @param {{signal?: AbortSignal}} [options]
 * @returns {Promise<{model: object, extent: import('./scale.mjs').Extent}[]>} by index
 * @throws {TelarError} E_SPEC where the model lacks a ghost that a view leaves out, or where nothing is left
 */
export async function shownBy(views, model, { signal } = {}) {
  const exploded = new Map();
  const shown = [];
  for (const [i, view] of views.entries()) {
    const { explode, ghost, variant } = view;
    if (explode > 0 && !exploded.has(explode)) exploded.set(explode, await model.explode(explode, { signal }));
    const seen = exploded.get(explode) ?? model;
    const basis = basisOf(view);
    const ranges = await seen.rangesAlong([basis.right, basis.up, basis.back], { variant, ghost, signal }).catch((thrown) => {
      throw ofView(thrown, i);
    });
    if (!ranges) throw new TelarError(ABOUT.code, ...nothingSeen(i, ghost));
    shown.push({ model: seen, extent: extentOf(ranges, basis) });
  }
  return shown;
}

/** @param {number} view index @param {object[]} ghost */
function nothingSeen(view, ghost) {
  if (ghost.length === 0) return [`spec.views[${view}]: the model draws nothing to be seen`, { pointer: pointerText(['views', view]) }];
  return [`spec.views[${view}].ghost: expected one that leaves a part of the model to be seen`, { pointer: pointerText(['views', view, 'ghost']) }];
}
