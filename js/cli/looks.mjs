import { LOOKS } from '../shot/table/looks.mjs';

/**
 * telar looks
 * What each look is; with --json the shots that they stand for.
 * @param {object} _options
 * @param {{console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} 0
 */
export async function looks(_options, { console }) {
  const width = Math.max(...Object.keys(LOOKS).map((name) => name.length));
  await console.result(
    Object.fromEntries(Object.entries(LOOKS).map(([name, { shot }]) => [name, shot])),
    Object.entries(LOOKS).map(([name, { doc }]) => `${name.padEnd(width)}  ${doc}`),
  );
  return 0;
}
