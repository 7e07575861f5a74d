import { zodOf } from '../../../js/shot/schema.mjs';
import { resolvedRow } from '../../../js/shot/table/resolved.mjs';

/** What the table of the shot must say of each row. */

const CHILDREN = {
  object: ({ shape }) => Object.entries(shape),
  list: ({ of }) => [['[]', of]],
  union: ({ options }) => options.map((option, i) => [`<${i}>`, option, true]),
  variants: ({ of }) => Object.entries(of),
};

const NAMES = ['choice', 'literal'];

/** Whether a row's own value suits it; null stands for "none" where a row may be null. */
const isRefused = (row, value) => value !== undefined && !zodOf({ ...row, default: undefined, optional: false }).safeParse(value).success;

function ownFaults(row, isOption) {
  const faults = [];
  // An option of a union is told by the union.
  if (!isOption && !row.doc) faults.push('has no doc');
  if (row.kind === 'number' && !row.unit) faults.push('has no unit');
  if (row.kind === 'number' && !((row.above ?? row.min) < row.max)) faults.push('has an empty range');
  if (row.kind === 'number' && !(Math.abs(row.min ?? row.above) <= 1e30 && row.max <= 1e30)) faults.push("leaves the range of the GPU's floats");
  if (row.kind === 'number' && row.integer && !(row.min >= 0 && row.max < 2 ** 31)) faults.push('is no index that C++ reads');
  if (NAMES.includes(row.kind) && new Set(row.values).size !== row.values.length) faults.push('names a value twice');
  if (isRefused(row, row.default)) faults.push('has a default that it refuses');
  if (isRefused(row, row.otherwise)) faults.push('has a value otherwise that it refuses');
  if (row.default !== undefined && row.optional) faults.push('has a default and may be left out');
  return faults;
}

/**
 * @param {import('../../../js/shot/table/rows.mjs').Row} row
 * @param {string} [path]
 * @returns {string[]} what is wrong, each with its path
 */
export function tableFaults(row, path = 'shot', isOption = false) {
  const resolved = resolvedRow(row);
  const nested = [...new Set([row, resolved])].flatMap((form) => CHILDREN[form.kind]?.(form) ?? []);
  const shape = row.kind === 'object' ? Object.keys(row.shape) : [];
  const missing = Object.entries(row.shape ?? {})
    .filter(([, { when }]) => when !== undefined && !shape.includes(when))
    .map(([key, { when }]) => `${path}.${key} is there when ${when}, which is no key`);
  const inner = nested.flatMap(([key, child, option]) => tableFaults(child, `${path}.${key}`, option ?? row.kind === 'list'));
  return [...new Set([...ownFaults(row, isOption || row.kind === 'variants').map((fault) => `${path} ${fault}`), ...missing, ...inner])];
}
