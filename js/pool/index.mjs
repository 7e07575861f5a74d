// telar/pool: draws in processes of their own, so that no file ends the one that asks.
export { createPool } from './pool.mjs';
