import { TelarError } from '../error/index.mjs';

/** Turns what zod found wrong into one sentence: full path, what is expected, what was given. */

const MAX_SHOWN = 60;

/**
 * What a complaint is about: how messages name it, and the code of its errors.
 * @typedef {{name: string, code: string}} About
 */

/** @type {About} */
const SHOT = Object.freeze({ name: 'shot', code: 'E_SHOT' });

/** ["lights", 0, "color"] -> "shot.lights[0].color". @param {(string | number)[]} path @param {About} [about] */
export function pathText(path, { name } = SHOT) {
  return path.reduce((text, key) => {
    if (typeof key === 'number') return `${text}[${key}]`;
    return /^[A-Za-z_$][\w$]*$/.test(key) ? `${text}.${key}` : `${text}[${shown(String(key))}]`;
  }, name);
}

/** JSON pointer (RFC 6901). */
export const pointerText = (path) => path.map((key) => `/${String(key).replaceAll('~', '~0').replaceAll('/', '~1')}`).join('');

/** Lists within each other that are looked into: with more, a message is cut anyway. */
const MAX_DEPTH = MAX_SHOWN / 2;

/** A value as it may stand in a message: short, without control characters. */
export const shown = (value) => shownWithin(value, 0);

/** The same within so many lists. */
function shownWithin(value, depth) {
  if (value === undefined) return 'nothing';
  if (typeof value === 'number' || value === null || typeof value === 'boolean') return String(value);
  if (typeof value === 'string') return cut(JSON.stringify(value));
  if (ArrayBuffer.isView(value)) return `${value.byteLength} bytes`;
  if (Array.isArray(value)) return depth > MAX_DEPTH ? '[...]' : cut(`[${value.map((item) => shownWithin(item, depth + 1)).join(', ')}]`);
  if (typeof value === 'object')
    return cut(
      `{${Object.keys(value)
        .map((key) => JSON.stringify(key))
        .join(', ')}}`,
    );
  return `a ${typeof value}`;
}

const cut = (text) => (text.length <= MAX_SHOWN ? text : `${text.slice(0, MAX_SHOWN - 4)}...${text.at(-1)}`);

/**
 * @param {(string | number)[]} path
 * @param {string} expected noun phrase
 * @param {unknown} value as given
 * @param {About} [about]
 */
export function wrongValue(path, expected, value, about = SHOT) {
  return new TelarError(about.code, `${pathText(path, about)}: expected ${expected}, got ${shown(value)}`, { pointer: pointerText(path) });
}

/** Edits between two words: characters added, dropped, replaced, or two neighbours swapped. */
function editDistance(a, b) {
  const rows = [Array.from({ length: b.length + 1 }, (_, j) => j)];
  for (let i = 1; i <= a.length; ++i) {
    rows[i] = [i];
    for (let j = 1; j <= b.length; ++j) {
      const replaced = rows[i - 1][j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1);
      const isSwap = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      rows[i][j] = Math.min(rows[i][j - 1] + 1, rows[i - 1][j] + 1, replaced, isSwap ? rows[i - 2][j - 2] + 1 : Infinity);
    }
  }
  return rows[a.length][b.length];
}

/**
 * The known word nearest to a mistyped one, or undefined when none is near.
 * @param {string} word
 * @param {string[]} known
 * @param {number} [share] part of the word's letters that may be wrong
 */
export function nearest(word, known, share = 1 / 3) {
  const [best] = known
    .map((candidate) => ({ candidate, edits: editDistance(word.toLowerCase().slice(0, 64), candidate.toLowerCase()) }))
    .sort((a, b) => a.edits - b.edits);
  return best && best.edits <= Math.ceil(word.length * share) ? best.candidate : undefined;
}

function unknownKey(path, key, allowed, elsewhere, about) {
  const near = nearest(
    key,
    [...allowed, ...elsewhere].filter((name) => name !== key),
  );
  const hint = near ? `did you mean ${near}?` : `expected one of ${allowed.join(', ')}`;
  return new TelarError(about.code, `${pathText([...path, key], about)}: unknown key, ${hint}`, { pointer: pointerText([...path, key]) });
}

const valueAt = (root, path) => path.reduce((value, key) => value?.[key], root);
const isPlainObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value) && !ArrayBuffer.isView(value);

/** Schema behind default, optional and the like, and behind one that is made late. */
function unwrap(schema) {
  const { innerType, def } = schema?._zod ?? {};
  const inner = innerType ?? def?.innerType ?? (def?.type === 'pipe' ? def.in : undefined);
  return inner ? unwrap(inner) : schema;
}

function child(schema, key, value) {
  const { def } = unwrap(schema);
  if (def.type === 'object') return def.shape[key];
  if (def.type === 'array') return def.element;
  if (def.type === 'tuple') return def.items[key];
  if (def.type === 'record') return def.valueType;
  if (def.discriminator) return def.options.find((option) => unwrap(option.def.shape[def.discriminator]).def.values[0] === value?.[def.discriminator]);
  return undefined;
}

/** Keys that an object may have; of a union, those of all its branches. */
function knownKeys(schema) {
  const { def } = unwrap(schema);
  if (def.type === 'object') return Object.keys(def.shape);
  return def.type === 'union' ? [...new Set(def.options.flatMap(knownKeys))] : [];
}

/** The schema at the end of `path`, through the lights that the value picks; undefined inside a union's branch. */
function schemaAt(schema, path, value) {
  if (schema === undefined) return undefined;
  const here = unwrap(schema);
  if (here.def.discriminator && isPlainObject(value)) return schemaAt(child(here, undefined, value), path, value);
  return path.length === 0 ? here : schemaAt(child(here, path[0], value), path.slice(1), value?.[path[0]]);
}

const isUnion = ({ def }) => def.type === 'union' && def.discriminator === undefined;

/** What a branch of a union says of the value, when it is of the value's type. */
function branchIssues(branch, value) {
  const { type } = unwrap(branch).def;
  if (isPlainObject(value) ? type !== 'object' : !Array.isArray(value) || type !== 'tuple') return [];
  const result = branch.safeParse(value);
  if (result.success) return [];
  const unknown = result.error.issues.find(({ code, path }) => code === 'unrecognized_keys' && path.length === 0)?.keys.length ?? 0;
  return [{ branch, issues: result.error.issues, unknown }];
}

/** Whether the value says by a key of one possible value that it is of this branch. */
function isNamed(branch, value) {
  const { shape = {} } = unwrap(branch).def;
  return Object.entries(shape).some(([key, schema]) => {
    const { type, values } = unwrap(schema).def;
    return type === 'literal' && values.length === 1 && values[0] === value[key];
  });
}

/** The branch that the caller most likely meant: the one named, then fewest unknown keys, then fewest complaints. */
function likeliestBranch(union, value) {
  return union.def.options
    .flatMap((branch) => branchIssues(branch, value))
    .sort((a, b) => isNamed(b.branch, value) - isNamed(a.branch, value) || a.unknown - b.unknown || a.issues.length - b.issues.length)[0];
}

/** Whether an object names none of several things that are named by one key each, or two: what one branch says of it would mislead. */
function isOfNoBranch(union, value) {
  if (!isPlainObject(value)) return false;
  const shapes = union.def.options.map((branch) => unwrap(branch).def.shape).filter(Boolean);
  if (shapes.some((shape) => Object.keys(shape).length !== 1)) return false;
  return Object.keys(value).length === 0 || shapes.filter((shape) => Object.keys(shape)[0] in value).length > 1;
}

/**
 * @param {import('zod').ZodError['issues']} issues
 * @param {unknown} root the value that was parsed
 * @param {import('zod').ZodType} schema
 * @param {{path?: (string | number)[], known?: string[], about?: About}} [context] path of `root` in what is complained about; keys that
 *   a mistyped one may mean
 * @returns {TelarError} about the first complaint
 */
export function complaint(issues, root, schema, { path: prefix = [], known = [], about = SHOT } = {}) {
  // A mistyped key also makes its right name missing: the typing error explains both.
  const issue = issues.find(({ code }) => code === 'unrecognized_keys') ?? issues[0];
  const path = [...prefix, ...issue.path];
  const value = valueAt(root, issue.path);
  const here = schemaAt(schema, issue.path, root);
  if (here && isUnion(here)) {
    const likely = likeliestBranch(here, value);
    if (likely && !isOfNoBranch(here, value)) return complaint(likely.issues, value, likely.branch, { path, known: knownKeys(here), about });
  }
  if (issue.code === 'unrecognized_keys') return unknownKey(path, issue.keys[0], knownKeys(here), known, about);
  if (issue.code === 'too_big' && Array.isArray(value))
    return new TelarError(about.code, `${pathText(path, about)}: expected ${issue.message}, got ${value.length}`, { pointer: pointerText(path) });
  return wrongValue(path, issue.message, value, about);
}
