import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { withLimitsTable } from '../../../js/build/docs/limits_table.mjs';
import { loadNative } from '../../../js/api/native.mjs';
import '../api/support/real.mjs';

const read = (file) => readFileSync(new URL(`../../../${file}`, import.meta.url), 'utf8');

const HEADER = `
  std::uint64_t fileBytes = 64ull << 20;   ///< L_FILE_BYTES: each file
  std::uint64_t files = 256;               ///< L_FILES
  std::uint64_t pixels = 8192ull * 4096;   ///< L_PIXELS: of a map
`;

test('the table of limits is written from limits.h', () => {
  const page = withLimitsTable('before\n\n| limit | x |\n|---|\n| old |\n\nafter\n', HEADER);
  assert.equal(
    page,
    [
      'before',
      '',
      '| limit | default | of what |',
      '| --- | --- | --- |',
      '| `L_FILE_BYTES` | 64 MiB | each file |',
      '| `L_FILES` | 256 |  |',
      '| `L_PIXELS` | 33,554,432 | of a map |',
      '',
      'after',
      '',
    ].join('\n'),
  );
  assert.throws(() => withLimitsTable('no table', HEADER), /SECURITY\.md has no table/);
});

test('SECURITY.md names each limit as the API takes it, with its default', () => {
  const rows = new Map(
    [...read('SECURITY.md').matchAll(/^\| `(L_\w+)` \| ([\d,]+)( MiB)? \|/gm)].map(([, name, number, unit]) => [
      name,
      Number(number.replaceAll(',', '')) * (unit ? 2 ** 20 : 1),
    ]),
  );
  assert.deepEqual(Object.fromEntries(rows), { ...loadNative().limits });
});
