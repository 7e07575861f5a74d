import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { TABLE } from '../../js/error/table.mjs';
import { makeCases } from '../robust/make_cases.mjs';
import { timesOf } from './ramp.mjs';

// Hostile and damaged files, a few at once, to whatever draws them: how each ends, and after how long. ../bench/hostile.mjs is the command.

const SHARED = fileURLToPath(new URL('../../../shared/hostile', import.meta.url));
/** Kinds of errors that blame the file: no worker was lost, and no time was up. */
const OF_FILES = ['input', 'denied', 'unsupported', 'limit'];

/** How an answer counts in the shared list. @param {string} code '' of a picture */
const outcomeOf = (code) => (code === '' ? 'render' : code.startsWith('L_') ? 'limit' : 'reject');

/**
 * Files by their bytes: the own cases with their codes, and those of ../shared/hostile with the outcomes that they accept.
 * @returns {{name: string, bytes: Uint8Array, code?: string, accept?: string[]}[]}
 */
export function hostileFiles() {
  const own = makeCases()
    .filter(({ byPath }) => !byPath)
    .map(({ name, bytes, code }) => ({ name, bytes, code }));
  if (!existsSync(SHARED)) return own;
  const { cases } = JSON.parse(readFileSync(path.join(SHARED, 'manifest.json'), 'utf8'));
  const shared = cases.filter(({ mode }) => mode === 'bytes');
  return [...own, ...shared.map(({ file, accept }) => ({ name: file, bytes: readFileSync(path.join(SHARED, 'cases', file)), accept }))];
}

/**
 * @param {ReturnType<typeof hostileFiles>} files
 * @param {(bytes: Uint8Array) => Promise<string>} ask gives the code of the error, '' of a picture
 * @param {{atOnce: number, rounds: number}} how
 * @returns {Promise<{file: object, code: string, ms: number}[]>} each file once a round
 */
export async function askAll(files, ask, { atOnce, rounds }) {
  const waiting = Array.from({ length: rounds }, () => files).flat();
  const answers = [];
  const client = async () => {
    for (let file = waiting.shift(); file; file = waiting.shift()) {
      const start = performance.now();
      answers.push({ file, code: await ask(file.bytes), ms: performance.now() - start });
    }
  };
  await Promise.all(Array.from({ length: atOnce }, client));
  return answers;
}

/**
 * @param {{asked: number, answers: Awaited<ReturnType<typeof askAll>>, mostMs: number, lost: number}} result mostMs: the deadline and 2 s; lost: workers
 * @returns {string[]} what is wrong
 */
export function judgeHostile({ asked, answers, mostMs, lost }) {
  const faults = answers.flatMap(({ file: { name, code: expected, accept }, code, ms }) => [
    ...(expected !== undefined && code !== expected ? [`${name}: ${code || 'a picture'}, expected ${expected || 'a picture'}`] : []),
    ...(accept && !accept.includes(outcomeOf(code)) ? [`${name}: ${code || 'a picture'}, accepted ${accept.join(', ')}`] : []),
    ...(code && !OF_FILES.includes(TABLE[code]?.kind) ? [`${name}: ${code} blames something else`] : []),
    ...(ms > mostMs ? [`${name}: ${ms.toFixed(0)} ms`] : []),
  ]);
  if (answers.length !== asked) faults.push(`${asked - answers.length} of ${asked} have no answer`);
  if (lost > 0) faults.push(`${lost} workers were lost`);
  return faults;
}

/** Times of what was refused, and of what was drawn. */
export const timesOfHostile = (answers) => ({
  refused: timesOf(answers.filter(({ code }) => code !== '')),
  drawn: timesOf(answers.filter(({ code }) => code === '')),
});
