export { TelarError } from '../error/index.mjs';
export { openQueue } from './open.mjs';
export { startWorker } from './worker.mjs';
