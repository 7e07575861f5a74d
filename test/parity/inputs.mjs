import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { ENVIRONMENTS, MODELS } from '../fixtures/index.mjs';
import { SHARED_MODELS } from './cases_shared.mjs';

const STUDIO = fileURLToPath(new URL('../../js/assets/studio.hdr', import.meta.url));
const SHARED = 'shared:';

/**
 * Bytes (or the path) of a case's model and environment.
 * @param {import('./cases.mjs').Case} item
 * @returns {Promise<{model: Uint8Array | string, environment: Uint8Array | undefined, bundled: boolean}>} `bundled`: the
 *   environment is the one that telar knows as "studio".
 */
export async function loadInputs({ name, model, environment }) {
  return {
    model: await loadModel(name, model),
    environment: environment && loadEnvironment(name, environment),
    bundled: environment === 'studio',
  };
}

async function loadModel(name, model) {
  if (model.startsWith(SHARED)) return path.join(SHARED_MODELS, model.slice(SHARED.length));
  if (!MODELS[model]) throw new Error(`case ${name}: test/fixtures has no model ${model}`);
  return MODELS[model]();
}

function loadEnvironment(name, environment) {
  if (environment === 'studio') return readFileSync(STUDIO);
  if (environment.startsWith(SHARED)) return readFileSync(path.join(SHARED_MODELS, environment.slice(SHARED.length)));
  if (!ENVIRONMENTS[environment]) throw new Error(`case ${name}: test/fixtures has no environment ${environment}`);
  return ENVIRONMENTS[environment]();
}
