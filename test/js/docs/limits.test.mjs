import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const read = (file) => readFileSync(new URL(`../../../${file}`, import.meta.url), 'utf8');

/** Value of a C++ constant such as `64ull << 20` or `500'000`. */
function evaluate(text) {
  const [left, operator, right] = text.replaceAll("'", '').replaceAll('ull', '').split(' ').map((word) => (/^\d+$/.test(word) ? Number(word) : word));
  if (operator === '<<') return left * 2 ** right;
  return operator === '*' ? left * right : left;
}

const inMebibytes = (name, value) => (name.endsWith('_BYTES') ? `${value / 2 ** 20} MiB` : value.toLocaleString('en'));

test('SECURITY.md lists the limits as limits.h has them', () => {
  const limits = [...read('renderer/include/telar/limits.h').matchAll(/std::uint64_t (\w+) = ([^;]+);\s*\/\/\/< (L_\w+)(?:: (.*))?/g)];
  assert.ok(limits.length > 20);
  const rows = limits.map(([, option, value, code, note]) => `| \`${code}\` | \`${option}\` | ${inMebibytes(code, evaluate(value))} | ${note ?? ''} |`);
  const table = ['| code | option | default | of what |', '|---|---|---|---|', ...rows].join('\n').replaceAll(' |  |', ' | |');
  assert.ok(read('SECURITY.md').includes(table), `SECURITY.md must have this table:\n${table}\n`);
});
