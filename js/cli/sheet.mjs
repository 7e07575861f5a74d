import { readdir, readFile } from 'node:fs/promises';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { createSheet, firstSpec } from '../sheet/index.mjs';
import { checkShared } from '../sheet/shared_shot.mjs';
import { removeUnfinished, writeFileAtomically } from '../api/atomic_file.mjs';
import { refuseWarnings } from '../api/fail_on.mjs';
import { maxFileBytes, readLimits, readTimeout } from './limits.mjs';
import { checkModel, readModel } from './models.mjs';
import { environmentOf, refuseOverwriting } from './overwritten.mjs';
import { readShotOptions } from './shot_options.mjs';
import { readAll } from './streams.mjs';

/** Largest spec: a sheet of hundreds of pages has one megabyte. */
const SPEC_BYTES = 8 * 2 ** 20;

const ENDINGS = { '.pdf': 'pdf', '.svg': 'svg', '.png': 'png' };

const usage = (message) => new TelarError('E_USAGE', message);

/**
 * telar sheet MODEL [--spec SPEC] -o sheet.pdf
 * The tech sheet of a model: one PDF, or one SVG or PNG a page. With --init the first spec, to be edited.
 * @param {string} given path or file: URL of a model, or - for stdin
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} exit code
 */
export async function sheet(given, options, context) {
  const format = formatOf(options);
  if ([given, options.spec, options.shot, options.previous].filter((file) => file === '-').length > 1) throw usage('- (stdin) can stand for one file only');
  const { model } = await checkModel(given);
  const limits = readLimits(options.limit);
  const timeoutMs = readTimeout(options.timeoutMs);
  const shot = await readShotOptions(options, context);
  checkShared(shot, 'shot');
  const [givenSpec, previous] = [await readSpecFile('--spec', options.spec, context), await readSpecFile('--previous', options.previous, context)];
  const fonts = await Promise.all((options.font ?? []).map((file) => readBytes('--font', file)));
  const templates = templatesOf(options.template);
  await refuseOverwriting({
    inputs: [...inputsOf(options), environmentOf(shot), ...imagesOf(givenSpec, options.spec)],
    models: [model],
    outputs: await writtenBy(options.output),
    maxBytes: maxFileBytes(limits),
  });
  const source = await readModel(model, limits, context);
  const renderer = await context.api.createRenderer({ backend: options.backend, limits, failOn: options.failOn, timeoutMs, signal: context.signal });
  try {
    const loaded = await renderer.load(source, { signal: context.signal });
    const name = model === '-' ? '' : path.basename(model).replace(/\.[^.]+$/, '');
    const spec = givenSpec ?? firstSpec(loaded.facts, { name });
    if (format === 'json') {
      for (const warning of loaded.facts.warnings) context.console.warning(warning, model);
      return await writeSpec(spec, options.output, context);
    }
    const bar = await context.console.progress(1, { gradual: true });
    const made = await createSheet(loaded, spec, {
      renderer,
      format,
      fonts,
      templates,
      shot,
      previous,
      limits,
      timeoutMs,
      resolve: (image) => readBeside(options.spec, image),
      signal: context.signal,
      onProgress: (part) => bar.reach?.(0, part),
    }).finally(() => bar.stop());
    return await tell(made, { options, format, model }, context);
  } finally {
    removeUnfinished();
    await renderer.close();
  }
}

function formatOf({ output, init }) {
  const ending = path.extname(output).toLowerCase();
  if (init) {
    if (ending !== '.json' && output !== '-') throw usage(`--init writes a spec: name a .json file with -o, got ${shown(output)}`);
    return 'json';
  }
  if (ENDINGS[ending]) return ENDINGS[ending];
  throw usage(`-o ${shown(output)}: expected a name that ends in ${Object.keys(ENDINGS).join(', ')}; with --init in .json`);
}

async function readBytes(option, file) {
  try {
    return await readFile(file);
  } catch (cause) {
    throw new TelarError('E_FILE', `${option} ${shown(file)} cannot be read (${cause.code})`, { cause });
  }
}

/** @returns {Promise<object | undefined>} undefined where there is none */
async function readSpecFile(option, file, { stdin, signal }) {
  if (file === undefined) return undefined;
  const bytes = file === '-' ? await readAll(stdin, SPEC_BYTES, signal) : await readBytes(option, file);
  if (bytes.length > SPEC_BYTES) {
    throw new TelarError('L_FILE_BYTES', `${option} ${shown(file)} has ${bytes.length} bytes, more than the ${SPEC_BYTES} of a spec`, {
      limit: { name: 'L_FILE_BYTES', max: SPEC_BYTES, actual: bytes.length },
    });
  }
  try {
    return JSON.parse(bytes.toString('utf8'));
  } catch (error) {
    throw new TelarError('E_SPEC', `${option} ${shown(file)} is not JSON: ${error.message}`, { pointer: '' });
  }
}

const inputsOf = ({ spec, previous, shot, font = [] }) => [
  { file: spec, what: 'the spec' },
  { file: previous, what: 'the spec of the last revision' },
  { file: shot, what: 'the shot' },
  ...font.map((file) => ({ file, what: 'the font' })),
];

/** Images that a spec names. It is not checked yet. */
function imagesOf(spec, specFile) {
  const rows = ['bill', 'labels', 'artwork'].flatMap((list) => (Array.isArray(spec?.[list]) ? spec[list] : []));
  const names = [spec?.header?.logo, ...rows.map((row) => row?.image)].filter((name) => typeof name === 'string');
  return names.map((name) => ({ file: path.resolve(folderOf(specFile), name), what: 'an image of the spec' }));
}

/** The file of -o, and what numbered pages would take the place of: how many pages there are is known when the sheet is laid out. */
async function writtenBy(output) {
  const { dir, name, ext } = path.parse(output);
  const isNumbered = ['svg', 'png'].includes(ENDINGS[ext.toLowerCase()]);
  const beside = isNumbered ? await readdir(dir || '.').catch(() => []) : [];
  const isPage = (file) => file.startsWith(`${name}-`) && file.endsWith(ext) && /^[1-9]\d*$/.test(file.slice(name.length + 1, file.length - ext.length));
  return [output, ...beside.filter(isPage).map((file) => path.join(dir, file))].map((file) => ({ file, what: '-o' }));
}

/** Where a spec's images begin. */
const folderOf = (spec) => path.resolve(spec === undefined || spec === '-' ? '.' : path.dirname(spec));

/** Images lie beside the spec or beneath its folder. */
async function readBeside(spec, image) {
  const folder = folderOf(spec);
  const file = path.resolve(folder, image);
  if (path.relative(folder, file).startsWith('..')) throw new TelarError('E_URI_DENIED', `the image ${shown(image)} leads out of the folder of the spec`);
  return readFile(file).catch(() => null);
}

/** --template NAME=FOLDER */
function templatesOf(list = []) {
  return Object.fromEntries(
    list.map((text) => {
      const at = text.indexOf('=');
      if (at < 1) throw usage(`--template ${shown(text)}: expected NAME=FOLDER`);
      return [text.slice(0, at), path.resolve(text.slice(at + 1))];
    }),
  );
}

async function writeSpec(spec, output, { console, signal }) {
  const text = `${JSON.stringify(spec, null, 2)}\n`;
  if (output === '-') await console.bytes(Buffer.from(text));
  else {
    await writeFileAtomically(output, Buffer.from(text), signal);
    await console.result({ ok: true, exit: 0, spec: output }, [output]);
  }
  return 0;
}

/** "sheet.png" of several pages: sheet-1.png, sheet-2.png, ... */
function namesOf(output, count) {
  const { dir, name, ext } = path.parse(output);
  return count === 1 ? [output] : Array.from({ length: count }, (_, i) => path.join(dir, `${name}-${i + 1}${ext}`));
}

async function tell({ files, info }, { options, format, model }, { console, signal }) {
  // Those of the file and of the pictures have been refused before.
  refuseWarnings(options.failOn, info.warnings);
  const outputs = namesOf(options.output, format === 'pdf' ? 1 : files.length);
  for (const [i, file] of outputs.entries()) await writeFileAtomically(file, files[i], signal);
  for (const warning of info.warnings) console.warning(warning, model);
  await console.result({ ok: true, exit: 0, model, outputs, bytes: files.map(({ length }) => length), info }, outputs);
  return 0;
}
