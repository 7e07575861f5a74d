import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/**
 * The gates by name: figures that must not be passed. `max` and `p999` are in 1/255. A check of a region without pixels
 * fails, as nothing was judged, unless it is the edge, which opaque pictures have none of, or the pictures are equal.
 */
export const GATES = Object.freeze({
  /** The same pixels. */
  exact: [{ region: 'frame', figure: 'max', limit: 0 }],
  /** What one GL shows in the browser and on the server. */
  parity: [
    { region: 'interior', figure: 'max', limit: 2 },
    { region: 'interior', figure: 'p999', limit: 1 },
    { region: 'edge', figure: 'flip.mean', limit: 0.01 },
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

/** What may be limited: figures by their path in a region's. */
export const REGIONS = Object.freeze(['frame', 'object', 'interior', 'edge']);
export const FIGURES = Object.freeze(['max', 'p999', 'mean', 'rmse', 'rmseLinear', 'flip.mean', 'flip.max', 'deltaE.mean', 'deltaE.p95', 'deltaE.max']);

/** "object.flip.mean" as {region, figure}; undefined for what is none. */
export function limitNamed(name) {
  const [region, ...rest] = name.split('.');
  const figure = rest.join('.');
  return REGIONS.includes(region) && FIGURES.includes(figure) ? { region, figure } : undefined;
}

/** The checks of a gate with limits of the caller's: in place of its own, or beside them. */
function checksOf(gate, limits) {
  const own = Object.entries(limits).map(([name, limit]) => {
    const found = limitNamed(name);
    if (!found)
      throw new TelarError(
        'E_OPTION',
        `limits.${name}: expected a region (${REGIONS.join(', ')}) and a figure (${FIGURES.join(', ')}), as in object.flip.mean`,
      );
    if (!(limit >= 0 && Number.isFinite(limit))) throw new TelarError('E_OPTION', `limits.${name}: expected a number of at least 0, got ${shown(limit)}`);
    return { ...found, limit };
  });
  const same = (a) => (b) => a.region === b.region && a.figure === b.figure;
  return [...GATES[gate].map((check) => ({ ...check, ...own.find(same(check)) })), ...own.filter((check) => !GATES[gate].some(same(check)))];
}

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
 * @param {Record<string, number>} [limits] by "region.figure": in place of the gate's, or beside them
 * @returns {Verdict} pictures that are equal are within every gate
 * @throws {TelarError} E_OPTION
 */
export function judge(comparison, gate = DEFAULT_GATE, limits = {}) {
  if (!Object.hasOwn(GATES, gate)) {
    throw new TelarError('E_OPTION', `gate: expected one of ${Object.keys(GATES).join(', ')}, got ${shown(gate)}`);
  }
  const isEqual = comparison.frame?.max === 0;
  const checks = checksOf(gate, limits).map(({ region, figure, limit }) => {
    const figures = comparison[region];
    const value = figures ? figure.split('.').reduce((node, key) => node[key], figures) : null;
    return { region, figure, limit, value, pass: value === null ? region === 'edge' || isEqual : value <= limit };
  });
  return { gate, pass: checks.every(({ pass }) => pass), checks };
}
