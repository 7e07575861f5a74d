// Files with faults: failOn "none" draws what three.js draws without the textures and extensions that it lacks.
import { BROKEN_MODELS } from '../fixtures/index.mjs';
import { makeCase as make } from './make_case.mjs';
import { LIGHTS } from './shot.mjs';

const lights = [LIGHTS.ambient, LIGHTS.directional];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = Object.keys(BROKEN_MODELS).map((name) => ({ ...make(name, name, null, { lights }, true), failOn: 'none' }));
