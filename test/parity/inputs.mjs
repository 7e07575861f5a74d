import { readFileSync } from 'node:fs';
import path from 'node:path';
import { BROKEN_MODELS, ENVIRONMENTS, FABRIC_MODELS, MODELS as STOCK_MODELS } from '../fixtures/index.mjs';
import { randomScene } from '../fixtures/random_scene.mjs';
import { ASSETS, SHARED_MODELS } from './places.mjs';

const MODELS = { ...STOCK_MODELS, ...FABRIC_MODELS, ...BROKEN_MODELS };

/** Folder by prefix of a case's `model` or `environment`. */
const FOLDERS = { 'shared:': SHARED_MODELS, 'bundled:': ASSETS };

/** Environments by name, all of them: the browser knows one that it has by its array. */
const environments = new Map();

/** Random scenes by name: each older release draws them again. */
const scenes = new Map();

/** The last model: cases of one model follow each other. */
let last = { name: '', bytes: undefined };

/**
 * Bytes (or the path) of a case's model and environment.
 * @param {import('./cases.mjs').Case} item
 * @returns {Promise<{model: Uint8Array | string, environment: Uint8Array | undefined, bundled: boolean, failOn?: 'none'}>} `bundled`: the
 *   environment is the one that telar knows as "studio". `failOn`: of the case.
 */
export async function loadInputs({ name, model, environment, failOn }) {
  return {
    model: await loadModel(name, model),
    environment: environment && loadEnvironment(name, environment),
    bundled: environment === 'studio',
    failOn,
  };
}

async function loadModel(name, model) {
  const file = fileOf(model);
  if (file) return file;
  const random = /^random(-cloth)?:(\d+)$/.exec(model);
  if (random && !scenes.has(model)) scenes.set(model, randomScene(Number(random[2]), random[1] !== undefined));
  if (random) return scenes.get(model);
  if (!MODELS[model]) throw new Error(`case ${name}: test/fixtures has no model ${model}`);
  if (last.name !== model) last = { name: model, bytes: MODELS[model]() };
  return last.bytes;
}

function loadEnvironment(name, environment) {
  if (!environments.has(environment)) environments.set(environment, readEnvironment(name, environment));
  return environments.get(environment);
}

function readEnvironment(name, environment) {
  const file = fileOf(environment === 'studio' ? 'bundled:studio.hdr' : environment);
  if (file) return readFileSync(file);
  if (!ENVIRONMENTS[environment]) throw new Error(`case ${name}: test/fixtures has no environment ${environment}`);
  return ENVIRONMENTS[environment]();
}

function fileOf(name) {
  const prefix = Object.keys(FOLDERS).find((candidate) => name.startsWith(candidate));
  return prefix && path.join(FOLDERS[prefix], name.slice(prefix.length));
}
