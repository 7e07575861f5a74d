import { createHash } from 'node:crypto';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { firstSpec } from '../sheet/first_spec.mjs';
import { lengthOf } from '../sheet/lengths.mjs';
import { ABOUT, readSpec } from '../sheet/read.mjs';
import { basisOf } from '../sheet/scale.mjs';
import { lengthText } from '../sheet/units.mjs';
import { HttpError } from './http.mjs';

/** Lists of a spec that the page edits. What else the file holds stays as it is. */
export const EDITED = Object.freeze(['callouts', 'measures']);

/** Version of a file that is not there yet. */
const NEW = 'new';

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** What the text was indented by, so that a saved file differs in what was edited alone. */
function indentOf(text) {
  if (!/[\r\n]/.test(text.trim())) return 0;
  return /^[^\S\r\n]+(?=")/m.exec(text)?.[0] ?? 2;
}

/** A wrong body: what no page of ours sends. */
const wrongBody = (expected) => new HttpError(400, `the body: expected ${expected}`);

/**
 * The spec of a tech sheet that a view edits. It is read anew for each request, as another program may write it too.
 */
export class SpecFile {
  #name;
  #read;
  #write;
  #saving = Promise.resolve();

  /**
   * @param {object} file
   * @param {string} file.name shown to readers, without its folder
   * @param {() => Promise<Uint8Array | undefined>} file.read undefined: there is no such file yet
   * @param {(bytes: Uint8Array) => Promise<void>} file.write whole or not at all
   */
  constructor({ name, read, write }) {
    this.#name = name;
    this.#read = read;
    this.#write = write;
  }

  get name() {
    return this.#name;
  }

  /** @returns {Promise<{given: object, version: string, text?: string}>} the spec as it stands in the file, or a first one */
  async #current({ facts, style }) {
    const bytes = await this.#read();
    if (!bytes) return { given: firstSpec(facts, { name: style }), version: NEW };
    const text = Buffer.from(bytes).toString('utf8');
    let given;
    try {
      given = JSON.parse(text);
    } catch (error) {
      throw new TelarError(ABOUT.code, `${shown(this.#name)} is not JSON: ${error.message}`, { pointer: '' });
    }
    return { given, text, version: createHash('sha256').update(bytes).digest('hex') };
  }

  /**
   * What the page begins with.
   * @param {{facts: object, style: string}} model its facts, and the style's name where it has none
   * @throws {TelarError} E_SPEC
   */
  async describe(model) {
    const { given, version } = await this.#current(model);
    const { views, anchors, units, printedUnits, header } = readSpec(given, model.facts);
    return {
      name: this.#name,
      version,
      isNew: version === NEW,
      callouts: given.callouts ?? [],
      measures: given.measures ?? [],
      anchors,
      views: views.map((view) => ({ name: view.name, back: basisOf(view).back })),
      units,
      printedUnits,
      baseSize: header.baseSize,
    };
  }

  /**
   * Measures one point of measure as the sheet does.
   * @param {{measure: object, index: number}} body the row, not resolved, and its place in the list
   * @param {{facts: object, style: string, model: object, signal: AbortSignal}} context
   * @returns {Promise<{millimetres?: number, text?: string, path?: number[][], isLoop?: boolean, warnings: string[]}>}
   * @throws {TelarError} E_SPEC, E_MEASURE, L_MEASURE, ...
   */
  async measure(body, { model, signal, ...context }) {
    const { measure, index } = body ?? {};
    if (!isObject(measure) || !Number.isSafeInteger(index) || index < 0) throw wrongBody('{measure, index}');
    const { given } = await this.#current(context);
    const at = (text) => text.replace(/^spec\.measures\[0\]/, `spec.measures[${index}]`);
    let spec;
    try {
      spec = readSpec({ ...given, measures: [measure] }, context.facts);
    } catch (thrown) {
      if (!thrown.pointer?.startsWith('/measures/0')) throw thrown;
      throw new TelarError(thrown.code, at(thrown.message), { pointer: thrown.pointer.replace('/measures/0', `/measures/${index}`) });
    }
    const [row] = spec.measures;
    const { variant } = spec.views.find(({ name }) => name === row.view);
    const warnings = [];
    const warn = (_code, message) => warnings.push(message);
    const { length, path, isLoop } = await lengthOf(row, { model, anchors: spec.anchors, variant, pointer: `/measures/${index}`, call: { signal }, warn });
    if (length === undefined) return { warnings };
    return { millimetres: length, text: `${lengthText(length, spec.printedUnits)} ${spec.printedUnits}`, path, isLoop, warnings };
  }

  /**
   * Puts the edited lists into the file. Nothing is written unless all of the spec is sound and the file is what the page knows.
   * @param {{version: string, callouts: object[], measures: object[]}} body
   * @param {{facts: object, style: string}} context
   * @returns {Promise<{version: string}>} of the file as it stands now
   * @throws {TelarError} E_SPEC, X_OUTPUT
   * @throws {HttpError} 400, 409
   */
  save(body, context) {
    // One after the other: two pages of one view would both find the version that they know.
    const saved = this.#saving.then(() => this.#saveNow(body, context));
    this.#saving = saved.catch(() => {});
    return saved;
  }

  async #saveNow(body, context) {
    const keys = ['version', ...EDITED];
    if (!isObject(body) || Object.keys(body).some((key) => !keys.includes(key)) || keys.some((key) => body[key] === undefined))
      throw wrongBody(`{${keys.join(', ')}}`);
    const { given, text, version } = await this.#current(context);
    if (body.version !== version)
      throw new HttpError(409, `${shown(this.#name)} was changed by another program since it was read: reload the page, then edit again`);
    const edited = { ...given };
    // A list that was left out stays so while it is empty.
    for (const key of EDITED) if (body[key].length !== 0 || given[key] !== undefined) edited[key] = body[key];
    readSpec(edited, context.facts);
    const line = text === undefined || /\n$/.test(text) ? '\n' : '';
    const bytes = Buffer.from(JSON.stringify(edited, null, text === undefined ? 2 : indentOf(text)) + line);
    await this.#write(bytes);
    return { version: createHash('sha256').update(bytes).digest('hex') };
  }
}
