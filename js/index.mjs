// telar: draws on a server what the browser client shows.
export { createRenderer } from './api/renderer.mjs';
export { inspect } from './api/inspect.mjs';
export { pictureKey } from './api/picture_key.mjs';
export { evaluateShading } from './api/lobes.mjs';
export { animateWebp } from './api/animated_webp.mjs';
export { bake } from './api/bake.mjs';
export { doctor } from './api/doctor.mjs';
export { versions } from './api/versions.mjs';
export { TelarError, toTelarError } from './error/index.mjs';
