import { heading, row } from './tables.mjs';

/** The table of limits in SECURITY.md, from limits.h, which has their defaults. */

const FIELD = /std::uint64_t \w+ = ([^;]+);\s*\/\/\/< (L_\w+)(?:: (.*))?/g;

/** Value of a C++ constant such as `64ull << 20` or `500'000`. */
function constantOf(text) {
  const [left, operator, right] = text
    .replaceAll("'", '')
    .replaceAll('ull', '')
    .split(' ')
    .map((word) => (/^\d+$/.test(word) ? Number(word) : word));
  if (operator === '<<') return left * 2 ** right;
  return operator === '*' ? left * right : left;
}

const inItsUnit = (name, value) => (name.endsWith('_BYTES') ? `${value / 2 ** 20} MiB` : value.toLocaleString('en'));

/** @param {string} header text of limits.h @returns {string[]} lines of Markdown */
export const limitsTable = (header) => [
  ...heading(['limit', 'default', 'of what']),
  ...[...header.matchAll(FIELD)].map(([, value, name, note = '']) => row([`\`${name}\``, inItsUnit(name, constantOf(value)), note])),
];

const IN_PAGE = /^\| limit \|.*\n(?:\|.*\n)*/m;

/** SECURITY.md with the table as the header has it. @param {string} page @param {string} header */
export function withLimitsTable(page, header) {
  if (!IN_PAGE.test(page)) throw new Error('SECURITY.md has no table that begins with "| limit |"');
  return page.replace(IN_PAGE, () => `${limitsTable(header).join('\n')}\n`);
}
