// node test/parity/compare.mjs CASE FILE.raw [--premultiplied]
// Compares a picture of a case (RGBA8, straight alpha, top row first) with the browser's that run.mjs kept.
// Exit code 1 when it is over the bar.
import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { CASES } from './cases.mjs';
import { compareCase } from './draw_both.mjs';
import { loadReference } from './files.mjs';
import { premultiply } from './metrics.mjs';
import { Report } from './report.mjs';

const { values, positionals } = parseArgs({ allowPositionals: true, options: { premultiplied: { type: 'boolean' } } });
const [name, file] = positionals;
const item = CASES.find((candidate) => candidate.name === name);
if (!item || !file) throw new Error('usage: node test/parity/compare.mjs CASE FILE.raw [--premultiplied]');

const reference = loadReference(item);
const bytes = new Uint8Array(readFileSync(file));
const actual = values.premultiplied ? bytes : premultiply(bytes);
const report = new Report();
console.log(report.add(item, reference, { actual, difference: compareCase(item, reference, actual) }));
console.log(await report.finish());
process.exitCode = report.failed ? 1 : 0;
