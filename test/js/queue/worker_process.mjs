import { appendFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';
import { TelarError, openQueue } from '../../../js/queue/index.mjs';
import { resultOf } from './support.mjs';

// A worker of the tests, in a process of its own: node worker_process.mjs OPTIONS [LOG]. Each run is a line of LOG.

const [options, log] = process.argv.slice(2);
const queue = await openQueue(JSON.parse(options));

const work = async ({ asked }, { signal, onProgress }) => {
  if (log) appendFileSync(log, `${asked.name}\n`);
  process.stdout.write(`runs ${asked.name}\n`);
  if (asked.kills) process.kill(process.pid, 'SIGKILL');
  onProgress(0.5);
  if (asked.sleep) await sleep(asked.sleep, undefined, { signal }).catch(() => signal.throwIfAborted());
  return resultOf(asked.name);
};

queue.take(work, { atOnce: 1 });
process.on('SIGTERM', async () => {
  const late = setTimeout(() => queue.abort(new TelarError('X_SHUTDOWN', 'it ends')), 200);
  await queue.idle();
  clearTimeout(late);
  await queue.close();
  process.exit(0);
});
process.stdout.write('ready\n');
