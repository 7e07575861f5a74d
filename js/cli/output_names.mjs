import { statSync } from 'node:fs';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { nearest, shown } from '../shot/complain.mjs';
import { FORMATS } from '../shot/table/output.mjs';

/** Where each picture goes, and in which format. */

const FORMAT_OF = Object.fromEntries(Object.entries(FORMATS).flatMap(([format, { extensions }]) => extensions.map((extension) => [extension, format])));
const EXTENSION_OF = Object.fromEntries(
  Object.entries(FORMATS).map(
    ([
      format,
      {
        extensions: [first],
      },
    ]) => [format, first],
  ),
);
const BRACES = /\{([a-z]+)\}/gi;

const usage = (message) => new TelarError('E_USAGE', message);

function isFolder(file) {
  if (file.endsWith('/')) return true;
  try {
    return statSync(file).isDirectory();
  } catch {
    return false; // absent or out of reach: writing will tell
  }
}

/** Longest part of a name that a model's text gives, in characters: file systems hold 255 bytes. */
const MAX_PART = 60;

/** Text of a model as part of a file name: it leads nowhere, and shows on every system. */
const asFileName = (text) =>
  [
    ...text
      .replace(/[\u0000-\u001f\u007f/\\<>:"|?*]+/g, '-')
      .trim()
      .replace(/^\.+/, ''),
  ]
    .slice(0, MAX_PART)
    .join('') || 'unnamed';

/** What each pair of braces stands for. */
const PARTS = {
  name: ({ model }) => (model === '-' ? 'stdin' : path.parse(model).name),
  index: (_job, index) => String(index + 1),
  parent: ({ model }) => (model === '-' ? 'stdin' : path.basename(path.dirname(path.resolve(model))) || 'root'),
  folder: ({ folder }) => folder || '.',
  variant: ({ variant }) => asFileName(variant),
  view: ({ view }) => asFileName(view),
};

/** {name} and the like in a pattern, known ones alone. */
function checkPattern(pattern) {
  const known = Object.keys(PARTS);
  for (const [braces, part] of pattern.matchAll(BRACES)) {
    if (known.includes(part)) continue;
    const near = nearest(part, known);
    throw usage(
      `${shown(pattern)}: ${braces} stands for nothing; ${near ? `did you mean {${near}}?` : `expected ${known.map((name) => `{${name}}`).join(' ')}`}`,
    );
  }
}

const isPattern = (text) => text.search(BRACES) >= 0;

/** Which parts the name of a picture needs in a folder. */
function folderPattern(jobs, crosses) {
  const parts = ['{name}', ...(crosses.variants ? ['{variant}'] : []), ...(crosses.views ? ['{view}'] : [])];
  return path.join(jobs.some(({ folder }) => folder !== '') ? '{folder}' : '', parts.join('-'));
}

/** The pattern of one -o, or of one line of a manifest. */
function patternOf(out, jobs, crosses, format) {
  checkPattern(out);
  if (isPattern(out)) return out;
  const extension = EXTENSION_OF[format ?? 'png'] ?? '';
  if (isFolder(out) || (jobs.length > 1 && path.extname(out) === '')) return path.join(out, folderPattern(jobs, crosses) + extension);
  if (jobs.length > 1)
    throw usage(`-o ${shown(out)}: many ${crosses.views || crosses.variants ? 'pictures' : 'models'} need a folder, or a pattern such as out/{name}.png`);
  return out;
}

function formatOf(file, wanted) {
  const extension = FORMAT_OF[path.extname(file).toLowerCase()];
  if (!extension && wanted === undefined) {
    throw usage(`-o ${shown(file)}: expected a name that ends in ${Object.keys(FORMAT_OF).join(' ')}, or a shot with output.format`);
  }
  if (extension && wanted !== undefined && extension !== wanted) {
    throw usage(`-o ${shown(file)} means ${extension}, but the shot's output.format is ${wanted}; drop one of them`);
  }
  return wanted ?? extension;
}

const filled = (pattern, job, index) => path.normalize(pattern.replaceAll(BRACES, (_, part) => PARTS[part](job, index)));

const wantedFormat = ({ shot }) => shot.output?.format;

/**
 * @param {string | undefined} out of -o: a file, a folder, a pattern, or - for stdout; undefined where a manifest names every output
 * @param {import('./jobs.mjs').Job[]} jobs
 * @param {{views: boolean, variants: boolean}} crosses whether a model has many views, variants
 * @returns {Array<{file: string, format: string}>} as long as jobs; file "-" for stdout
 * @throws {TelarError} E_USAGE
 */
export function outputNames(out, jobs, crosses) {
  if (out === '-') {
    if (jobs.length > 1) throw usage('-o -: only one image fits on stdout; give a folder, or a pattern such as out/{name}.png');
    return [{ format: wantedFormat(jobs[0]) ?? 'png', file: '-' }];
  }
  const unnamed = jobs.filter(({ output }) => output === undefined);
  if (out === undefined && unnamed.length > 0) throw usage(`${unnamed[0].where}: there is no output; name one there, or a folder or pattern with -o`);
  const outputs = new Array(jobs.length);
  for (const [, sharing] of sharingJobs(jobs)) {
    const patterns = new Map();
    for (const index of sharing) {
      const job = jobs[index];
      const format = wantedFormat(job);
      if (!patterns.has(format))
        patterns.set(
          format,
          patternOf(
            job.output ?? out,
            sharing.map((i) => jobs[i]),
            crosses,
            format,
          ),
        );
      const file = filled(patterns.get(format), job, index);
      outputs[index] = { file, format: formatOf(file, format) };
    }
  }
  refuseClashes(outputs, jobs, out);
  return outputs;
}

/** Indices of the jobs by what names their outputs: -o, or a line of the manifest. */
function sharingJobs(jobs) {
  const sharing = new Map();
  jobs.forEach(({ output, where }, index) => {
    const by = output === undefined ? '-o' : where;
    if (!sharing.has(by)) sharing.set(by, []);
    sharing.get(by).push(index);
  });
  return sharing;
}

/** Parts that would tell two pictures apart. */
const telling = (pattern, first, second) =>
  ['parent', 'variant', 'view'].filter((part) => !pattern.includes(`{${part}}`) && PARTS[part](first) !== PARTS[part](second));

/** What a message calls a picture. */
const described = (job, other) =>
  [shown(job.model), ...['variant', 'view'].filter((part) => job[part] !== other[part]).map((part) => `${part} ${shown(job[part])}`)].join(', ');

function refuseClashes(outputs, jobs, out) {
  const owner = new Map();
  outputs.forEach(({ file }, i) => {
    const key = path.resolve(file);
    if (owner.has(key)) {
      const [first, second] = [jobs[owner.get(key)], jobs[i]];
      const [part = 'index'] = telling(second.output ?? out, first, second);
      throw usage(`${described(first, second)} and ${described(second, first)} would both be written to ${shown(file)}; use a pattern with {${part}}`);
    }
    owner.set(key, i);
  });
  const overwritten = jobs.find(({ model }) => model !== '-' && owner.has(path.resolve(model)));
  if (overwritten) throw usage(`-o would overwrite the model ${shown(overwritten.model)}`);
}
