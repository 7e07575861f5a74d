import { once } from 'node:events';
import { constants } from 'node:fs';
import { open, readFile, realpath } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { tooLarge } from '../server/receive.mjs';
import { shown } from '../shot/complain.mjs';
import { readLimits, readTimeout, readWorkers } from './limits.mjs';
import { serviceOptions } from './service_options.mjs';
import { signingKeysOf } from './sign.mjs';

/** Milliseconds that the end of the workers gets beside the draining. */
const LEEWAY_MS = 5000;

/**
 * telar serve
 * Draws over HTTP until it is told to end; then it takes no more work, finishes what runs, and ends well.
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console, ending: {patienceMs: number, isWell: boolean}}} context
 * @returns {Promise<number>} 0
 */
export async function serve(options, { console, signal, stderr, env, ending }) {
  const { listen } = await import('../server/index.mjs');
  const workers = readWorkers('--workers', options.workers);
  const service = await listen(
    {
      ...serviceOptions(options, env),
      environments: await environmentsOf(options.environment),
      ...(options.store !== undefined && { store: options.store }),
      signingKeys: signingKeysOf(process.env),
      ...(options.models !== undefined && { resolve: await filesBeneath(options.models) }),
      pool: {
        backend: options.backend,
        limits: readLimits(options.limit),
        timeoutMs: readTimeout(options.timeoutMs),
        signal,
        ...(workers && { size: workers }),
        cgroup: options.cgroup,
      },
    },
    { log: stderr },
  );
  ending.patienceMs = service.drainMs + LEEWAY_MS;
  ending.isWell = true;
  for (const warning of service.warnings) console.warning(warning, 'queue');
  await console.result({ ok: true, url: service.url, port: service.port }, [service.url]);
  console.note('Ctrl-C ends.');
  if (!signal.aborted) await once(signal, 'abort');
  await service.drain();
  return 0;
}

/** --environment NAME=FILE */
async function environmentsOf(list = []) {
  const pairs = list.map(async (text) => {
    const at = text.indexOf('=');
    if (at < 1) throw new TelarError('E_USAGE', `--environment ${shown(text)}: expected NAME=FILE`);
    try {
      return [text.slice(0, at), await readFile(text.slice(at + 1))];
    } catch (cause) {
      throw new TelarError('E_FILE', `--environment ${shown(text)} cannot be read (${cause.code})`, { cause });
    }
  });
  return Object.fromEntries(await Promise.all(pairs));
}

/** References as names of files beneath a folder; what leads out of it, by links too, is not there. */
async function filesBeneath(folder) {
  const root = await realpath(folder).catch((cause) => {
    throw new TelarError('E_FILE', `--models ${shown(folder)} cannot be read (${cause.code})`, { cause });
  });
  return async (reference, { signal, maxBytes }) => {
    if (reference === '' || /[\0\\]/.test(reference)) return null;
    const file = await realpath(path.join(root, reference)).catch(() => undefined);
    if (file === undefined || !file.startsWith(root + path.sep)) return null;
    // A pipe is not waited for.
    const handle = await open(file, constants.O_RDONLY | constants.O_NONBLOCK | constants.O_NOFOLLOW).catch(() => undefined);
    if (!handle) return null;
    try {
      const facts = await handle.stat();
      if (!facts.isFile()) return null;
      if (facts.size > maxBytes) throw tooLarge('L_FILE_BYTES', maxBytes, facts.size, 'the model');
      return await handle.readFile({ signal });
    } finally {
      await handle.close();
    }
  };
}
