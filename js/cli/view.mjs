import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFile, stat } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { writeFileAtomically } from '../api/atomic_file.mjs';
import { maxFileBytes, readLimits, readTimeout } from './limits.mjs';
import { checkModel, readModel } from './models.mjs';
import { environmentOf, refuseOverwriting } from './overwritten.mjs';
import { readShotOptions } from './shot_options.mjs';

/**
 * telar view MODEL
 * A page on this machine with what the browser client shows beside what the server draws. Runs until it is interrupted.
 * @param {string} given path or file: URL of a model, or - for a GLB on stdin
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} 0 after the interrupt
 */
export async function view(given, options, context) {
  const { console, signal, api } = context;
  if (given === '-' && options.shot === '-') throw new TelarError('E_USAGE', '- (stdin) can stand for one file only');
  const { model } = await checkModel(given);
  const shot = await readShotOptions(options, context);
  const limits = readLimits(options.limit);
  await refuseOverwriting({
    inputs: [{ file: options.shot, what: 'the shot' }, environmentOf(shot)],
    models: [model],
    outputs: [{ file: options.spec, what: '--spec' }],
    maxBytes: maxFileBytes(limits),
  });
  const source = await readModel(model, limits, context);
  const { openView } = await import('../view/index.mjs');
  const renderer = await api.createRenderer({ backend: options.backend, limits, failOn: options.failOn, timeoutMs: readTimeout(options.timeoutMs), signal });
  try {
    const page = await openView({ renderer, source, shot, spec: specOf(options.spec), port: options.port, three: options.three, signal });
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

/** Largest spec, as of `telar sheet`. */
const SPEC_BYTES = 8 * 2 ** 20;

/** The file of --spec, which is read and written while the page is open. */
function specOf(file) {
  if (file === undefined) return undefined;
  if (path.extname(file).toLowerCase() !== '.json')
    throw new TelarError('E_USAGE', `--spec ${shown(file)}: expected the name of a .json file, which is written to`);
  const at = path.resolve(file);
  const read = async () => {
    try {
      const { size } = await stat(at);
      if (size <= SPEC_BYTES) return await readFile(at);
      throw new TelarError('L_FILE_BYTES', `--spec ${shown(file)} has ${size} bytes, more than the ${SPEC_BYTES} of a spec`, {
        limit: { name: 'L_FILE_BYTES', max: SPEC_BYTES, actual: size },
      });
    } catch (cause) {
      if (cause.code === 'ENOENT') return undefined;
      if (cause instanceof TelarError) throw cause;
      throw new TelarError('E_FILE', `--spec ${shown(file)} cannot be read (${cause.code})`, { cause });
    }
  };
  return { name: path.basename(at), read, write: (bytes) => writeFileAtomically(at, bytes) };
}

function openBrowser(url, console) {
  const child = spawn('xdg-open', [url], { detached: true, stdio: 'ignore' });
  child.on('error', () => console.note('There is no xdg-open here: open the address by hand.'));
  child.unref();
}
