import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { parseShot } from '../../../js/shot/resolve.mjs';
import { LAYER_FORMATS, LAYERS } from '../../../js/shot/table/layers.mjs';

const page = readFileSync(new URL('../../../js/docs/layers.md', import.meta.url), 'utf8');

/** Cells of the rows that begin with a name in backticks. */
const rows = (text) => [...text.matchAll(/^\| `(\w+)` \| (.*) \|$/gm)].map(([, name, rest]) => [name, ...rest.split(' | ')]);

test('layers.md has a row for every layer, with its channels, and one for every format, with its bits', () => {
  const told = rows(page);
  const layers = Object.entries(LAYERS).map(([name, { channels }]) => [name, channels.join(' ')]);
  assert.deepEqual(
    told.slice(0, layers.length).map(([name, , , channels]) => [name, channels]),
    layers,
  );
  const formats = Object.entries(LAYER_FORMATS).map(([name, bits]) => [name, bits.join(', ')]);
  assert.deepEqual(
    told.slice(layers.length).map(([name, bits]) => [name, bits]),
    formats,
  );
});

test('the shot of its example is one', () => {
  const [, shot] = /render\('shirt\.glb', (\{[\s\S]*?\n\})\);/.exec(page);
  const { layers, output } = parseShot(new Function(`return ${shot}`)());
  assert.deepEqual(layers, ['depth', 'normal', 'partId', 'ao']);
  assert.equal(output.layers.bitDepth, 16);
});
