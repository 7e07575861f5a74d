// telar/shot: pure, for the browser and the server alike.
export { resolveShot } from './resolve.mjs';
export { resolvePose } from './pose.mjs';
export { resolvePart } from './part.mjs';
export { resolveLeftOut } from './left_out.mjs';
export { parseColour, srgbToLinear } from './colour.mjs';
export { turntable } from './turntable.mjs';
export { VIEWS } from './frame.mjs';
export { TelarError } from '../error/index.mjs';
