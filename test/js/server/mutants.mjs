import { register } from 'node:module';
import { setTimeout as sleep } from 'node:timers/promises';

// Code with a planted fault, beside the right one in the same process: js/server/index.mjs?mutant=... is the service with some texts of its sources
// replaced. What lies outside of js/server and js/queue is shared with the right one.

const SERVER = new URL('../../../js/server/', import.meta.url).href;
const QUEUE = new URL('../../../js/queue/', import.meta.url).href;

let isRegistered = false;

/**
 * @param {[file: string, right: string, wrong: string][]} edits of js/server and js/queue, whose file names differ; each right text is there once
 * @param {string} [file] of js/server
 * @returns {Promise<object>} the module
 */
export function importMutant(edits, file = 'index.mjs') {
  if (!isRegistered) register(new URL('./mutant_hooks.mjs', import.meta.url), { data: { folders: [SERVER, QUEUE] } });
  isRegistered = true;
  const id = Buffer.from(JSON.stringify(edits)).toString('base64url');
  return import(`${SERVER}${file}?mutant=${id}`);
}

/**
 * Whether a check finds the fault: it rejects. One that waits for what never comes does not pass either.
 * @param {() => Promise<void>} check
 * @param {{hangMs: number}} how milliseconds after which it would have passed
 * @returns {Promise<string>} 'passes', 'fails' or 'hangs'
 */
export async function outcomeOf(check, { hangMs }) {
  const waiting = new AbortController();
  const late = sleep(hangMs, 'hangs', { signal: waiting.signal }).catch(() => {});
  const outcome = await Promise.race([
    check().then(
      () => 'passes',
      () => 'fails',
    ),
    late,
  ]);
  waiting.abort();
  return outcome;
}
