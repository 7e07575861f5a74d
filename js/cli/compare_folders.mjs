import { readdir } from 'node:fs/promises';
import path from 'node:path';
import { encodePng, foldersReport, heatMap, junitReport } from '../compare/index.mjs';
import { checkName, checkText } from '../compare/figures.mjs';
import { EXIT_OVER_THE_GATE } from '../error/table.mjs';
import { TelarError, toTelarError, worstExit } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { writeFileAtomically } from '../api/atomic_file.mjs';
import { maskFiles } from './compare_options.mjs';
import { comparePair, readPicture } from './compare_pair.mjs';
import { maxFileBytes } from './limits.mjs';
import { refuseOverwriting } from './overwritten.mjs';

/** `telar compare` of two folders: images of one name are compared. */

const IMAGE = /\.(png|jpe?g|webp)$/i;

/** Names of the images in a folder and beneath, hidden ones left out. */
async function imagesIn(folder, beneath = '') {
  const found = [];
  let entries;
  try {
    entries = await readdir(path.join(folder, beneath), { withFileTypes: true });
  } catch (cause) {
    throw new TelarError('E_FILE', `the folder ${shown(path.join(folder, beneath))} cannot be read (${cause.code})`, { cause });
  }
  for (const entry of entries) {
    if (entry.name.startsWith('.')) continue;
    const name = path.join(beneath, entry.name);
    if (entry.isDirectory()) found.push(...(await imagesIn(folder, name)));
    else if (IMAGE.test(entry.name)) found.push(name);
  }
  return found;
}

/** What a status means for the run. */
const PROBLEMS = {
  missing: 'there is no actual image: draw it, or delete the expected one',
  new: 'there is no expected image: --update accepts it',
};

/**
 * @typedef {object} Compared one name
 * @property {string} name of the file beneath both folders
 * @property {'within' | 'over' | 'missing' | 'new' | 'failed' | 'updated'} status
 * @property {object} [comparison] without flipMap
 * @property {object} [verdict]
 * @property {object[]} [hints]
 * @property {TelarError} [error]
 * @property {{expected?: string, actual?: string, heatMap?: string}} [files] in the report
 */

class FolderComparison {
  #folders;
  #options;
  #context;

  constructor(folders, options, context) {
    this.#folders = folders;
    this.#options = options;
    this.#context = context;
  }

  #fileOf(side, name) {
    return path.join(this.#folders[side], name);
  }

  /** @returns {Promise<Compared>} */
  async compare(name, { expected, actual }) {
    if (!expected || !actual) return this.#alone(name, expected ? 'expected' : 'actual');
    const { settings, masks } = this.#context;
    try {
      const [first, second] = [
        await readPicture(this.#fileOf('expected', name), this.#context),
        await readPicture(this.#fileOf('actual', name), this.#context),
      ];
      const {
        images,
        comparison: { flipMap, ...comparison },
        verdict,
        hints,
      } = await comparePair({ expected: first.image, actual: second.image }, { ...settings, masksOf: masks(name) });
      const files = verdict.pass ? undefined : await this.#keep(name, { images, heat: { flipMap, ...comparison } });
      if (!verdict.pass && this.#options.update) await this.#accept(name, second.bytes);
      return { name, status: verdict.pass ? 'within' : this.#options.update ? 'updated' : 'over', comparison, verdict, hints, files };
    } catch (thrown) {
      this.#context.signal?.throwIfAborted();
      return { name, status: 'failed', error: toTelarError(thrown) };
    }
  }

  /** An image that one folder alone has. What was drawn must be an image before it is accepted. */
  async #alone(name, side) {
    try {
      const { bytes, image } = await readPicture(this.#fileOf(side, name), this.#context);
      const files = await this.#keep(name, { [side]: image });
      const isAccepted = side === 'actual' && this.#options.update;
      if (isAccepted) await this.#accept(name, bytes);
      return { name, status: isAccepted ? 'updated' : side === 'actual' ? 'new' : 'missing', files };
    } catch (thrown) {
      this.#context.signal?.throwIfAborted();
      return { name, status: 'failed', error: toTelarError(thrown) };
    }
  }

  #accept(name, bytes) {
    return writeFileAtomically(this.#fileOf('expected', name), bytes, this.#context.signal);
  }

  /** Writes the pictures of the report. @returns {Promise<object | undefined>} links to them */
  async #keep(name, { images: [first, second] = [], heat, expected = first, actual = second }) {
    const { report } = this.#options;
    if (report === undefined) return undefined;
    const { signal } = this.#context;
    const pictures = { expected, actual, heatMap: heat && heatMap(heat) };
    const files = {};
    for (const [kind, image] of Object.entries(pictures)) {
      if (!image) continue;
      const parts = partsOf(name, kind);
      files[kind] = parts.map(encodeURIComponent).join('/');
      await writeFileAtomically(path.join(report, ...parts), await encodePng(image, { signal }), signal);
    }
    return files;
  }
}

/** Where a picture lies in the report. */
const partsOf = (name, kind) => ['pictures', ...name.split(path.sep), `${kind}.png`];

/** What is read is not what is written. @throws {TelarError} E_USAGE */
async function refuseOver(names, { expected, actual }, options, { limits }) {
  const { report, junit } = options;
  const pictures = names.flatMap((name) => ['expected', 'actual', 'heatMap'].map((kind) => partsOf(name, kind)));
  const pages = report === undefined ? [] : [['index.html'], ...pictures].map((parts) => path.join(report, ...parts));
  await refuseOverwriting({
    inputs: [
      ...names.map((name) => ({ file: path.join(expected, name), what: 'EXPECTED' })),
      ...names.map((name) => ({ file: path.join(actual, name), what: 'ACTUAL' })),
      ...maskFiles(options, names),
    ],
    outputs: [...pages.map((file) => ({ file, what: '--report' })), { file: junit, what: '--junit' }],
    maxBytes: maxFileBytes(limits),
  });
}

const isGood = ({ status }) => status === 'within' || status === 'updated';
const exitOf = (compared) => compared.error?.exit ?? (isGood(compared) ? 0 : EXIT_OVER_THE_GATE);

function refuseOptions({ heatmap }) {
  if (heatmap !== undefined) throw new TelarError('E_USAGE', '--heatmap is of two images; --report holds the heat maps of folders');
}

/**
 * @param {{expected: string, actual: string}} folders
 * @param {object} options as commander parsed them
 * @param {object} context of the command, with `settings`, `masks`, and `isNew` where the folder of the expected ones is not there yet
 * @returns {Promise<number>} the highest exit code of the images: 1 where one is over the gate, missing or new
 */
export async function compareFolders(folders, options, context) {
  refuseOptions(options);
  const { console, signal } = context;
  const [expected, actual] = [new Set(context.isNew ? [] : await imagesIn(folders.expected)), new Set(await imagesIn(folders.actual))];
  const names = [...new Set([...expected, ...actual])].sort();
  if (names.length === 0) throw new TelarError('E_USAGE', `${shown(folders.expected)} and ${shown(folders.actual)} hold no PNG, JPEG or WebP`);
  await refuseOver(names, folders, options, context);
  const work = new FolderComparison(folders, options, context);
  const progress = await console.progress(names.length);
  const pictures = [];
  try {
    for (const [index, name] of names.entries()) {
      pictures.push(await work.compare(name, { expected: expected.has(name), actual: actual.has(name) }));
      progress.step(name, index);
      signal?.throwIfAborted();
    }
  } finally {
    progress.stop();
  }
  const exit = worstExit(pictures.map(exitOf));
  await writeReports(pictures, folders, options, context);
  await tell(pictures, folders, exit, context);
  return exit;
}

async function writeReports(pictures, folders, { report, junit, gate }, { signal }) {
  const told = pictures.map(({ status, ...picture }) => ({ ...picture, status, problem: PROBLEMS[status] ?? picture.error?.message }));
  const title = `${path.basename(path.resolve(folders.expected))} and ${path.basename(path.resolve(folders.actual))}`;
  if (report !== undefined) await writeFileAtomically(path.join(report, 'index.html'), Buffer.from(foldersReport(told, { title, gate })), signal);
  if (junit !== undefined) await writeFileAtomically(junit, Buffer.from(junitReport(told)), signal);
}

async function tell(pictures, folders, exit, { console, settings }) {
  for (const { error } of pictures) if (error) console.error(error);
  const counts = {};
  for (const { status } of pictures) counts[status] = (counts[status] ?? 0) + 1;
  const said = Object.entries(counts)
    .map(([status, count]) => `${count} ${WORDS[status]}`)
    .join(', ');
  const objects = pictures.map(({ name, status, comparison, verdict, hints, error }) => ({
    name,
    ok: isGood({ status }),
    status,
    ...(verdict && { checks: verdict.checks }),
    ...(hints?.length > 0 && { hints }),
    ...comparison,
    ...(error && { error }),
  }));
  const lines = pictures.filter(({ status }) => status !== 'within' && status !== 'failed').flatMap(linesOf);
  await console.result({ ok: exit === 0, exit, ...folders, gate: settings.gate, counts, pictures: objects }, [
    ...lines,
    `${pictures.length} ${pictures.length === 1 ? 'image' : 'images'}: ${said} (gate ${settings.gate})`,
  ]);
}

const WORDS = { within: 'within the gate', over: 'over it', missing: 'missing', new: 'new', failed: 'not compared', updated: 'accepted' };

function linesOf({ name, status, verdict, hints = [] }) {
  const over = verdict?.checks.filter(({ pass }) => !pass).map((item) => `${checkName(item)} ${checkText(item)}`) ?? [];
  const about = over.length > 0 ? over.join('; ') : PROBLEMS[status];
  return [`${status.padEnd(8)} ${name}${about ? `: ${about}` : ''}`, ...hints.map(({ message }) => `         hint: ${message}`)];
}
