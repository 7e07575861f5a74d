import { readFileSync } from 'node:fs';

const RIGHT = 'const entries = files.map((file) => ({ ...file, ref: newRef() }));\n  await putAll(store, entries, ms);';
const WRONG = 'const entries = files.map((file) => ({ ...file, ref: newRef() }));\n  setTimeout(() => putAll(store, entries, ms).catch(() => {}), 1000);';

/** Hooks of module loading for plant_early_word.mjs. */
export function load(url, context, next) {
  if (!url.endsWith('/js/queue/stored.mjs')) return next(url, context);
  const source = readFileSync(new URL(url), 'utf8');
  if (!source.includes(RIGHT)) throw new Error('js/queue/stored.mjs has changed: plant the fault anew');
  return { format: 'module', source: source.replace(RIGHT, WRONG), shortCircuit: true };
}
