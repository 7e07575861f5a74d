/** Codes of what is wrong with the file of an environment. */
const OF_ENVIRONMENT = ['E_ENVIRONMENT_FORMAT', 'E_ENVIRONMENT_CORRUPT', 'L_ENVIRONMENT_PIXELS'];

/**
 * The file that an error is about, as the caller named it: the model, or the environment of the shot.
 * @param {{code: string} | undefined} error
 * @param {string} model
 * @param {object} shot not resolved
 * @returns {string}
 */
export function faultyFile(error, model, { environment } = {}) {
  const map = typeof environment === 'object' ? environment?.map : environment;
  return OF_ENVIRONMENT.includes(error?.code) && typeof map === 'string' ? map : model;
}
