import { readFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { writeFileAtomically } from './atomic_file.mjs';
import { versions } from './versions.mjs';

/** How fast this machine draws, measured once and kept in telar's cache folder. */

const NAME = 'calibration.json';

/** What another measurement belongs to. */
const ofMachine = (gl) => [versions.telar, os.cpus()[0]?.model ?? os.arch(), os.availableParallelism(), gl].join(', ');

const isMachine = (value) => ['raster', 'tracer'].every((key) => typeof value?.[key] === 'number' && value[key] >= 0) && value.raster > 0;

/** All that are kept: {machine: {raster, tracer}}. What cannot be read is measured again. */
async function readAll(folder) {
  try {
    const all = JSON.parse(await readFile(path.join(folder, NAME), 'utf8'));
    return Object.fromEntries(Object.entries(all).filter(([, value]) => isMachine(value)));
  } catch {
    return {};
  }
}

/**
 * What is kept of this version on this machine: {GL: {raster, tracer}}, CPU milliseconds.
 * @param {string | null} folder
 */
export async function keptCalibrations(folder) {
  if (!folder) return {};
  const prefix = ofMachine('');
  const own = Object.entries(await readAll(folder)).filter(([name]) => name.startsWith(prefix));
  return Object.fromEntries(own.map(([name, value]) => [name.slice(prefix.length), value]));
}

/**
 * @param {string} folder of the cache; empty = none
 * @param {string} gl renderer string
 * @param {{tracer: boolean}} has whether the tracer is there
 * @param {() => Promise<{raster: number, tracer: number}>} measure
 * @returns {Promise<{raster: number, tracer: number}>} tracer 0 where it was not there
 */
export async function calibrationOf(folder, gl, has, measure) {
  const name = ofMachine(gl);
  const kept = folder === '' ? {} : await readAll(folder);
  // One that was measured without the tracer says nothing of it: by 0 ms its settings would cost nothing.
  if (kept[name] && (kept[name].tracer > 0 || !has.tracer)) return kept[name];
  const machine = await measure();
  // A folder that cannot be written to costs the next process a second.
  if (folder !== '') {
    const all = { ...(await readAll(folder)), [name]: machine };
    await writeFileAtomically(path.join(folder, NAME), Buffer.from(`${JSON.stringify(all, null, 1)}\n`)).catch(() => {});
  }
  return machine;
}
