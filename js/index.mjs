// telar: draws on a server what the browser client shows.
export { createRenderer } from './renderer.mjs';
export { inspect } from './inspect.mjs';
export { pictureKey } from './picture_key.mjs';
export { evaluateShading } from './lobes.mjs';
export { doctor } from './doctor.mjs';
export { versions } from './versions.mjs';
export { TelarError, toTelarError } from './error/index.mjs';
