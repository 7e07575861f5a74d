/**
 * What a caller asked for, checked and with the caller's bytes copied.
 * @typedef {object} Request
 * @property {string} method of child_jobs.mjs
 * @property {{path: string} | {bytes: Buffer}} [input] of a model that is not loaded
 * @property {import('./recipe.mjs').Recipe} [recipe] of a loaded one, or of one to load
 * @property {{shot: object, environment?: {bytes: Buffer}, map?: Uint8Array}[]} [shots]
 * @property {import('../api/options.mjs').Loading} [loading]
 * @property {number | null} [timeoutMs] undefined where nobody said it
 * @property {boolean} [settled]
 * @property {string} [quantity]
 * @property {unknown[]} [args] of a model's method
 * @property {[string, {path: string} | {bytes: Uint8Array}][]} [others] files beside the input, by name
 * @property {(part: number) => void} [onProgress]
 * @property {(preview: object) => void} [onPreview]
 * @property {boolean} [reached]
 * @property {(value: object, parts: Buffer[]) => unknown} unpack an answer to what the caller gets
 */

/** Methods that draw several pictures, each of which has its own time. */
export const DRAW_MANY = Object.freeze(['renderAll', 'sheet']);

const plainLoading = ({ failOn, timeoutMs, ambientVisibility, resolve }) => ({ failOn, timeoutMs, rays: ambientVisibility, resolve: Boolean(resolve) });

/** Relative paths of a shot start there. */
function currentFolder() {
  try {
    return process.cwd();
  } catch {
    return undefined; // it was deleted
  }
}

/**
 * A request as a worker takes it.
 * @param {number} id
 * @param {Request} request
 * @param {import('./held_models.mjs').HeldModels} held by this worker
 * @returns {{job: object, parts: Uint8Array[]}}
 */
export function messageOf(id, { method, input, recipe, shots, loading, settled, quantity, args, others, onProgress, onPreview, reached }, held) {
  const parts = [];
  const attach = (bytes) => parts.push(bytes) - 1;
  const inputOf = ({ path, bytes }) => (bytes ? { part: attach(bytes) } : { path });
  const refOf = (model) => {
    if (held.has(model.id)) return { id: model.id };
    const { from, step, sha256 } = model;
    if (from) return { id: model.id, from: refOf(from), step, sha256 };
    return { id: model.id, input: inputOf(model.input), loading: plainLoading(model.loading), sha256 };
  };
  const shotOf = ({ shot, environment }) => ({ shot, ...(environment && { environment: attach(environment.bytes) }) });
  const job = {
    id,
    method,
    ...(recipe ? { model: refOf(recipe) } : { input: inputOf(input) }),
    ...(shots && { shots: shots.map(shotOf) }),
    ...(loading && { loading: plainLoading(loading) }),
    // Each finished picture of many says that the worker is not stuck.
    progress: onProgress !== undefined || DRAW_MANY.includes(method),
    preview: onPreview !== undefined,
    reached,
    settled,
    quantity,
    args,
    others: others?.map(([name, given]) => [name, inputOf(given)]),
    folder: currentFolder(),
  };
  return { job, parts };
}
