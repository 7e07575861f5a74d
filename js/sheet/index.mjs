// telar/sheet: a tech sheet of a garment, from a model and a spec.
export { createSheet } from './sheet.mjs';
export { firstSpec } from './first_spec.mjs';
export { changesBetween } from './changes.mjs';
export { readSpec } from './read.mjs';
export { TelarError } from '../error/index.mjs';
