import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import sharp from 'sharp';
import { OUT } from './places.mjs';
import { BAR } from './metrics.mjs';

/** Factor on differences in the difference picture: 1/255 becomes visible, 16/255 is full scale. */
const GAIN = 16;

/**
 * A case that was drawn on both sides.
 * @typedef {object} Result
 * @property {import('./cases.mjs').Case} item
 * @property {{model: Uint8Array | string, environment: Uint8Array | undefined, bundled: boolean}} inputs - Of inputs.mjs.
 * @property {{width: number, height: number, image: Uint8Array, mask: Uint8Array}} expected - The browser's, premultiplied.
 * @property {Uint8Array} actual - The server's, premultiplied.
 * @property {import('./metrics.mjs').Difference} difference
 *
 * The worst pixel of a case followed through both shaders: what `traceOf(result, {browser, server})` of trace.mjs resolves
 * to. run.mjs calls it, when trace.mjs is there, for each case over the bar, and with --trace for each that differs at all;
 * `browser` and `server` are those that drew the case, still open. report.mjs shows it beside the figures.
 * @typedef {object} Trace
 * @property {[number, number]} pixel - Counted from the top left.
 * @property {{term: string, browser: number[] | null, telar: number[] | null}[]} terms - In the order of computation; null
 *   where a side does not have the term.
 * @property {string} [cause] - First term that differs, or what else is known, as a sentence.
 */

/**
 * Table on the console and out/parity/index.html with both pictures and their difference of every case.
 */
export class Report {
  failed = 0;
  #rows = [];
  #pending = [];

  /**
   * @param {import('./cases.mjs').Case} item
   * @param {{width: number, height: number, image: Uint8Array} | null} expected - The browser's, premultiplied.
   * @param {{actual?: Uint8Array, difference?: import('./metrics.mjs').Difference, error?: Error}} result
   * @returns {string} Line for the console.
   */
  add(item, expected, { actual, difference, error }) {
    const pass = difference?.pass ?? false;
    if (!pass) this.failed++;
    this.#rows.push({ name: item.name, pass, difference, error, drawn: Boolean(actual) });
    if (expected) this.#pending.push(writePictures(item.name, expected, actual));
    const text = error ? error.message.replaceAll('\n', ' ').slice(0, 160) : figures(difference);
    return `${pass ? 'ok  ' : 'FAIL'} ${item.name.padEnd(32)} ${text}`;
  }

  /** Writes the page. @returns {Promise<string>} Closing line for the console. */
  async finish() {
    await Promise.all(this.#pending);
    const file = path.join(OUT, 'index.html');
    writeFileSync(file, page(this.#rows));
    const bar = `bar of the interior: max ${BAR.max}, 99.9 % at most ${BAR.p999}`;
    return `${this.#rows.length - this.failed} of ${this.#rows.length} cases within the bar (${bar}); report: ${path.relative('.', file)}`;
  }
}

function figures({ interior, edge }) {
  const part = ({ pixels, max, p999, atLeast1, atLeast2 }) =>
    `${String(pixels).padStart(6)} px  max ${String(max).padStart(3)}  p99.9 ${String(p999).padStart(3)}  >=1 ${String(atLeast1).padStart(6)}  >=2 ${String(atLeast2).padStart(6)}`;
  const at = interior.worst && interior.max > BAR.max ? `  at ${interior.worst.join(' ')}` : '';
  return `interior ${part(interior)}${at}  | edge max ${edge.max} >=2 ${edge.atLeast2}`;
}

async function writePictures(name, expected, actual) {
  const folder = path.join(OUT, 'pictures');
  mkdirSync(folder, { recursive: true });
  const { width, height, image } = expected;
  const save = (pixels, suffix) =>
    sharp(pixels, { raw: { width, height, channels: 4 } }).png().toFile(path.join(folder, `${name}.${suffix}.png`));
  await save(straight(image), 'browser');
  await save(straight(actual), 'telar');
  await save(amplified(image, actual), 'difference');
}

function straight(premultiplied) {
  const result = new Uint8Array(premultiplied);
  for (let i = 0; i < result.length; i += 4) {
    const alpha = result[i + 3];
    if (alpha > 0) for (let c = 0; c < 3; c++) result[i + c] = Math.min(255, Math.round((result[i + c] * 255) / alpha));
  }
  return result;
}

function amplified(a, b) {
  const result = new Uint8Array(a.length);
  for (let i = 0; i < a.length; i += 4) {
    for (let c = 0; c < 3; c++) result[i + c] = Math.min(255, Math.abs(a[i + c] - b[i + c]) * GAIN);
    result[i + 3] = 255;
  }
  return result;
}

const escaped = (text) => String(text).replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

function page(rows) {
  const style = `body{font:14px system-ui;margin:1.5rem;background:#777;color:#fff}img{max-width:30vw;image-rendering:pixelated;
background:repeating-conic-gradient(#888 0 25%,#999 0 50%) 0 0/16px 16px}section{margin-bottom:1.5rem}.bad h2{color:#fb8}h2{font-size:1rem;margin:.3rem 0}pre{margin:.3rem 0}`;
  const sorted = [...rows].sort((a, b) => a.pass - b.pass);
  const title = `telar against three.js: ${rows.filter((row) => row.pass).length} of ${rows.length} within the bar`;
  return `<!doctype html><meta charset="utf-8"><title>${title}</title><style>${style}</style><h1>${title}</h1>
<p>Left: three.js in Chromium. Middle: telar. Right: difference x ${GAIN}.</p>\n${sorted.map(section).join('\n')}\n`;
}

function section({ name, pass, difference, error, drawn }) {
  const kinds = drawn ? ['browser', 'telar', 'difference'] : [];
  const pictures = kinds.map((kind) => `<img alt="${kind}" src="pictures/${name}.${kind}.png">`).join(' ');
  const text = error ? escaped(error.stack ?? error) : figures(difference);
  return `<section class="${pass ? 'good' : 'bad'}"><h2>${pass ? 'within' : 'over'}: ${escaped(name)}</h2>${pictures}<pre>${text}</pre></section>`;
}
