// node test/parity/compare.mjs CASE FILE.raw [--premultiplied]
// Compares a picture of a case (RGBA8, straight alpha, top row first) with the browser's that `run.mjs --keep` left.
// Exit code 1 when it is over the bar.
import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { CASES } from './cases.mjs';
import { Comparer } from './comparer.mjs';
import { loadReference } from './files.mjs';
import { premultiply } from './metrics.mjs';
import { Report } from './report.mjs';

const { values, positionals } = parseArgs({ allowPositionals: true, options: { premultiplied: { type: 'boolean' } } });
const [name, file] = positionals;
const item = CASES.find((candidate) => candidate.name === name);
if (!item || !file) throw new Error('usage: node test/parity/compare.mjs CASE FILE.raw [--premultiplied]');

const bytes = new Uint8Array(readFileSync(file));
const comparer = new Comparer();
const { difference } = await comparer.compare(item, loadReference(item), values.premultiplied ? bytes : premultiply(bytes));
await comparer.close();
const report = new Report();
console.log(report.add({ item, difference }));
console.log(report.finish({ summary: `${name} against ${file}` }));
process.exitCode = report.failed ? 1 : 0;
