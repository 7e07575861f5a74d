// node test/parity/probe.mjs CASE [X Y]... [--terms normal,roughness] [--dump FOLDER]
// Prints the values of three's own shader variables at pixels of a case (counted from the top left), in the order in
// which to look for a difference; where X Y are left out, at the picture's centre. --dump writes each term of the whole
// picture as FOLDER/TERM.f32: RGBA fp32, top row first.
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { parseArgs } from 'node:util';
import { Browser } from './browser/chromium.mjs';
import { CASES } from './cases.mjs';
import { loadInputs } from './inputs.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { terms: { type: 'string' }, dump: { type: 'string' } },
});
const [name, ...numbers] = positionals;
const item = CASES.find((candidate) => candidate.name === name);
if (!item) throw new Error(`usage: node test/parity/probe.mjs CASE [X Y]...; cases: ${CASES.map((c) => c.name).join(' ')}`);

const { width, height } = item.shot.size;
const pixels = [];
for (let i = 0; i + 1 < numbers.length; i += 2) pixels.push([Number(numbers[i]), Number(numbers[i + 1])]);
if (pixels.length === 0) pixels.push([width >> 1, height >> 1]);

const browser = await Browser.start();
try {
  const terms = values.terms?.split(',') ?? null;
  const result = await browser.terms({ shot: item.shot, ...(await loadInputs(item)), terms });
  for (const [x, y] of pixels) {
    console.log(`${name} at ${x} ${y}`);
    for (const [term, buffer] of Object.entries(result)) {
      const at = (y * width + x) * 4;
      console.log(`  ${term.padEnd(20)} ${Array.from(buffer.subarray(at, at + 3), (value) => value.toPrecision(7)).join('  ')}`);
    }
  }
  if (values.dump) dump(values.dump, result);
} finally {
  await browser.close();
}

function dump(folder, result) {
  mkdirSync(folder, { recursive: true });
  for (const [term, buffer] of Object.entries(result)) writeFileSync(path.join(folder, `${term}.f32`), buffer);
}
