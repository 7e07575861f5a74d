import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { removeUnfinished, writeFileAtomically } from '../api/atomic_file.mjs';
import { maxFileBytes, readLimits, readTimeout } from './limits.mjs';
import { checkModel, readModel } from './models.mjs';
import { refuseOverwriting } from './overwritten.mjs';

const usage = (message) => new TelarError('E_USAGE', message);

/**
 * telar bake MODEL -o OUT
 * The model with its ambient visibility in its vertices.
 * @param {string} given path or file: URL of a model, or - for stdin
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} exit code
 */
export async function bake(given, options, { api, console, stdin, signal }) {
  const { output, rays } = options;
  if (output === '-' && options.json) throw usage('-o - and --json both want stdout; give a file to -o');
  if (rays !== undefined && !/^\d{1,9}$/.test(rays)) throw usage(`--rays: expected a whole number, got ${shown(rays)}`);
  const { model } = await checkModel(given);
  const limits = readLimits(options.limit);
  await refuseOverwriting({ models: [model], outputs: [{ file: output, what: '-o' }], maxBytes: maxFileBytes(limits) });
  const source = await readModel(model, limits, { stdin, signal });
  const { data, info } = await api.bake(source, {
    ...(rays !== undefined && { rays: Number(rays) }),
    limits,
    failOn: options.failOn,
    timeoutMs: readTimeout(options.timeoutMs),
    signal,
  });
  for (const warning of info.warnings) console.warning(warning, model);
  if (output === '-') {
    await console.bytes(data);
    return 0;
  }
  checkOutput(model, output, info);
  try {
    await writeFileAtomically(output, data, signal);
  } finally {
    removeUnfinished();
  }
  await console.result({ ok: true, exit: 0, model, output, bytes: data.length, info }, [output]);
  return 0;
}

/** A file that names others finds them from its own folder alone. */
function checkOutput(model, output, { format, parts }) {
  if (path.extname(output).toLowerCase() !== `.${format}`) throw usage(`-o ${shown(output)}: the model is a .${format} file, and so is what is written`);
  if (parts.length === 0 || model === '-') return;
  const [from, to] = [model, output].map((file) => path.dirname(path.resolve(file)));
  if (from !== to) throw usage(`-o ${shown(output)}: the model names ${shown(parts[0])} beside it; write into the folder of the model`);
}
