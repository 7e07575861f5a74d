import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { junitReport } from '../../js/compare/junit_report.mjs';
import { OUT } from './places.mjs';
import { figuresText, reportPage } from './report_page.mjs';

/**
 * One case in the report.
 * @typedef {object} Row
 * @property {string} name
 * @property {boolean} pass
 * @property {import('./metrics.mjs').Difference} [difference]
 * @property {import('./rasterizers.mjs').Distances} [rasterizers]
 * @property {import('./trace.mjs').Trace} [trace] - The worst pixel followed through both shaders.
 * @property {string} [explanation] - Which term of a release explains the difference.
 * @property {string} [error] - Why it could not be drawn.
 */

/** Lines for the console, out/parity/index.html with the pictures of every case, and out/parity/junit.xml. */
export class Report {
  failed = 0;
  #rows = [];
  #known = [];

  /**
   * @param {import('./draw_cases.mjs').Result} result
   * @param {import('./trace.mjs').Trace} [trace]
   * @param {string} [explanation]
   * @returns {string} Line for the console.
   */
  add({ item, error, difference, rasterizers }, trace = undefined, explanation = undefined) {
    const pass = Boolean(difference?.pass) && (rasterizers?.pass ?? true);
    if (!pass) this.failed++;
    const row = { name: item.name, pass, difference, rasterizers, trace, explanation, error: error && (error.stack ?? String(error)) };
    this.#rows.push(row);
    const text = error ? error.message.replaceAll('\n', ' ').slice(0, 160) : figuresText(row);
    return `${pass ? 'ok  ' : 'FAIL'} ${item.name.padEnd(34)} ${text}${explanation ? ` | ${explanation}` : ''}`;
  }

  /**
   * A picture in which three.js is known to be wrong: shown, and not judged.
   * @param {import('./draw_cases.mjs').Result} result
   * @returns {string} Line for the console.
   */
  addKnown({ item, error, difference }) {
    if (error) this.failed++;
    this.#known.push({ name: item.name, pass: !error, difference, error: error && (error.stack ?? String(error)) });
    return `${error ? 'FAIL' : 'known'} ${item.name} ${error ? error.message : `differs by up to ${difference.interior?.max ?? 0}/255`}`;
  }

  /**
   * Writes the files.
   * @param {{summary: string, knownDifferences?: import('./known_differences.mjs').KnownDifference[]}} facts - `summary`:
   *   what was drawn, and how long it took.
   * @returns {string} Closing line for the console.
   */
  finish({ summary, knownDifferences = [] }) {
    writeFileSync(path.join(OUT, 'index.html'), reportPage(this.#rows, { summary, knownDifferences, knownRows: this.#known }));
    const judged = this.#rows.map(({ name, difference }) => ({ name, verdict: difference?.verdict ?? notDrawn() }));
    writeFileSync(path.join(OUT, 'junit.xml'), junitReport(judged));
    return `${this.#rows.length - this.failed} of ${this.#rows.length} cases within the bar; report: ${path.relative('.', path.join(OUT, 'index.html'))}`;
  }
}

/** Verdict of a case without a picture. */
const notDrawn = () => ({ gate: 'parity', pass: false, checks: [{ region: 'interior', figure: 'max', limit: 2, value: null, pass: false }] });
