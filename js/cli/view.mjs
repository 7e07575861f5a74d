import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { TelarError } from '../error/index.mjs';
import { maxFileBytes, readLimits, readTimeout } from './limits.mjs';
import { checkModel } from './models.mjs';
import { readShotOptions } from './shot_options.mjs';
import { readAll } from './streams.mjs';

/**
 * telar view MODEL
 * A page on this machine with what the browser client shows beside what the server draws. Runs until it is interrupted.
 * @param {string} model path, or - for a GLB on stdin
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} 0 after the interrupt
 */
export async function view(model, options, context) {
  const { console, signal, api, stdin } = context;
  if (model === '-' && options.shot === '-') throw new TelarError('E_USAGE', '- (stdin) can stand for one file only');
  await checkModel(model);
  const shot = await readShotOptions(options, context);
  const limits = readLimits(options.limit);
  const source = model === '-' ? await readAll(stdin, maxFileBytes(limits), signal) : model;
  const { openView } = await import('../view/index.mjs');
  const renderer = await api.createRenderer({ backend: options.backend, limits, failOn: options.failOn, timeoutMs: readTimeout(options.timeoutMs), signal });
  try {
    const page = await openView({ renderer, source, shot, port: options.port, three: options.three, signal });
    try {
      await console.result({ ok: true, url: page.url, port: page.port, model }, [page.url]);
      console.note('Ctrl-C ends.');
      if (options.open) openBrowser(page.url, console);
      if (signal && !signal.aborted) await once(signal, 'abort');
    } finally {
      await page.close();
    }
  } finally {
    await renderer.close();
  }
  return 0;
}

function openBrowser(url, console) {
  const child = spawn('xdg-open', [url], { detached: true, stdio: 'ignore' });
  child.on('error', () => console.note('There is no xdg-open here: open the address by hand.'));
  child.unref();
}
