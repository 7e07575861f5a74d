import path from 'node:path';
import { readImage } from '../compare/index.mjs';
import { TelarError, toTelarError } from '../error/index.mjs';
import { ANY_MODEL } from '../shot/facts.mjs';
import { faultyFile } from './faulty_file.mjs';
import { readTimeout } from './limits.mjs';
import { withPathsFrom } from './shot_options.mjs';

/** The shots that pictures hold (js/compare/embedded_shot.mjs): told, and drawn again. */

/** The keys of a shot that are not as they are by default, as `key=JSON`; what went to which file is left out. */
export async function shotText({ output, ...shot }) {
  const { resolveShot } = await import('../shot/index.mjs');
  const defaults = resolveShot({}, ANY_MODEL);
  const told = Object.entries(shot).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(defaults[key]));
  return told.map(([key, value]) => `${key}=${JSON.stringify(value)}`).join(' ') || 'every default';
}

/** Keys in which two shots differ. */
export function differingKeys({ output: _, ...first }, { output: __, ...second }) {
  const keys = new Set([...Object.keys(first), ...Object.keys(second)]);
  return [...keys].filter((key) => JSON.stringify(first[key]) !== JSON.stringify(second[key]));
}

/**
 * What draws a model with the shot that a picture holds.
 * @param {string} file of the picture; relative paths in its shot start there
 * @param {object | null} shot of the picture
 * @param {{model: string, environment?: string, backend: string, timeoutMs?: string}} options
 * @param {{limits: object, signal?: AbortSignal, api: object}} context
 * @returns {Promise<{draw: (shading?: object) => Promise<import('../compare/image.mjs').Image>, close: () => Promise<void>}>} With the
 *   shot's own shading, or another in its place.
 * @throws {TelarError} E_USAGE where the picture holds no shot
 */
export async function openShotOf(file, shot, { model, environment, backend, timeoutMs }, { limits, signal, api }) {
  if (!shot) throw new TelarError('E_USAGE', `${file} holds no shot: save the picture in telar view, or give the picture to compare with as ACTUAL`);
  const wanted = { ...withPathsFrom(path.dirname(file), shot), output: { format: 'png', ppi: shot.output?.ppi } };
  if (environment !== undefined) wanted.environment = { ...(typeof shot.environment === 'object' ? shot.environment : {}), map: environment };
  const renderer = await api.createRenderer({ backend, limits, timeoutMs: readTimeout(timeoutMs), signal });
  let loaded;
  return {
    async draw(shading) {
      const changed = shading === undefined ? wanted : { ...wanted, shading };
      loaded ??= await named(model, () => renderer.load(model, { signal }));
      const { data } = await named(model, () => renderer.render(loaded, changed, { signal }), changed);
      return readImage(data, { limits, signal });
    },
    close: () => renderer.close(),
  };
}

/** @throws {TelarError} with the name of the model in front, or of the environment */
async function named(model, work, shot = {}) {
  try {
    return await work();
  } catch (thrown) {
    const error = toTelarError(thrown);
    throw new TelarError(error.code, `${faultyFile(error, model, shot)}: ${error.message}`, error);
  }
}
