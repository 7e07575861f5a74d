import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/**
 * The gates by name: figures that must not be passed. `max` and `p999` are in 1/255. A check of a region without pixels
 * fails, as nothing was judged, unless the region is optional: opaque pictures have no edge.
 */
export const GATES = Object.freeze({
  /** The same pixels. */
  exact: [{ region: 'frame', figure: 'max', limit: 0 }],
  /** What one GL shows in the browser and on the server. */
  parity: [
    { region: 'interior', figure: 'max', limit: 2 },
    { region: 'interior', figure: 'p999', limit: 1 },
    { region: 'edge', figure: 'flip.mean', limit: 0.01, optional: true },
  ],
  /** No difference that a person sees. */
  standard: [
    { region: 'object', figure: 'flip.mean', limit: 0.01 },
    { region: 'object', figure: 'deltaE.mean', limit: 0.5 },
    { region: 'object', figure: 'deltaE.p95', limit: 2 },
  ],
  /** The same picture by another GL, such as SwiftShader in place of Mesa: as far as three.js is from itself there. */
  'other-gl': [
    { region: 'object', figure: 'flip.mean', limit: 0.06 },
    { region: 'object', figure: 'deltaE.mean', limit: 1 },
    { region: 'object', figure: 'deltaE.p95', limit: 3 },
  ],
  /** The same picture, drawn fast. */
  draft: [{ region: 'object', figure: 'flip.mean', limit: 0.04 }],
});

export const DEFAULT_GATE = 'standard';

/**
 * @typedef {object} Verdict
 * @property {string} gate
 * @property {boolean} pass
 * @property {Array<{region: string, figure: string, limit: number, value: number | null, pass: boolean}>} checks value is
 *   null where the region has no pixels
 */

/**
 * @param {import('./compare.mjs').Comparison} comparison
 * @param {keyof typeof GATES} [gate]
 * @returns {Verdict}
 * @throws {TelarError} E_OPTION
 */
export function judge(comparison, gate = DEFAULT_GATE) {
  if (!Object.hasOwn(GATES, gate)) {
    throw new TelarError('E_OPTION', `gate: expected one of ${Object.keys(GATES).join(', ')}, got ${shown(gate)}`);
  }
  const checks = GATES[gate].map(({ region, figure, limit, optional = false }) => {
    const figures = comparison[region];
    const value = figures ? figure.split('.').reduce((node, key) => node[key], figures) : null;
    return { region, figure, limit, value, pass: value === null ? optional : value <= limit };
  });
  return { gate, pass: checks.every(({ pass }) => pass), checks };
}
