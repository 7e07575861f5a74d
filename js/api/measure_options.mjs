import { checkObject, checkSignal, isObject, loading, STRICT, wrongOption } from './options.mjs';

const POINTS_MAX = 1024;
const isVector = (value) => Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
const isIndex = (value) => Number.isSafeInteger(value) && value >= 0 && value < 2 ** 32;
const isName = (value) => (typeof value === 'string' && value !== '') || (isIndex(value) && value < 2 ** 31);

function vector(name, value) {
  if (!isVector(value)) throw wrongOption(name, '[x, y, z] in metres', value);
  return value;
}

function flag(name, value) {
  if (typeof value !== 'boolean') throw wrongOption(name, 'true or false', value);
  return value;
}

/** How far barycentric weights may be from a sum of 1. */
const WEIGHTS_TOLERANCE = 1e-6;

function weightsOf(name, weights) {
  const sum = isVector(weights) ? weights[0] + weights[1] + weights[2] : 0;
  if (!isVector(weights) || weights.some((weight) => weight < 0) || Math.abs(sum - 1) > WEIGHTS_TOLERANCE) {
    throw wrongOption(name, 'three barycentric weights of at least 0, whose sum is 1', weights);
  }
  return weights.map((weight) => weight / sum);
}

function point(name, value) {
  if (isVector(value)) return { position: value };
  if (!isObject(value)) throw wrongOption(name, '[x, y, z] in metres, {node, triangle, weights} or {node, vertex}', value);
  const onVertex = 'vertex' in value;
  checkObject(name, value, onVertex ? ['node', 'primitive', 'vertex'] : ['node', 'primitive', 'triangle', 'weights']);
  const { node, primitive = 0 } = value;
  if (!isName(node)) throw wrongOption(`${name}.node`, "a node's name or index", node);
  if (!isIndex(primitive) || primitive >= 2 ** 31) throw wrongOption(`${name}.primitive`, "the index of one of the mesh's primitives", primitive);
  const which = onVertex ? 'vertex' : 'triangle';
  if (!isIndex(value[which])) throw wrongOption(`${name}.${which}`, 'an index', value[which]);
  if (onVertex) return { node, primitive, vertex: value.vertex };
  return { node, primitive, triangle: value.triangle, weights: weightsOf(`${name}.weights`, value.weights) };
}

function pointsAsk(name, { points, along = 'straight', closed = false }) {
  if (!Array.isArray(points) || points.length < 2 || points.length > POINTS_MAX) {
    throw wrongOption(`${name}.points`, `a list of 2 to ${POINTS_MAX} points`, Array.isArray(points) ? points.length : points);
  }
  if (along !== 'straight' && along !== 'surface') throw wrongOption(`${name}.along`, '"straight" or "surface"', along);
  return { kind: 'points', points: points.map((value, i) => point(`${name}.points[${i}]`, value)), along, closed: flag(`${name}.closed`, closed) };
}

function girthAsk(name, { girth }) {
  checkObject(`${name}.girth`, girth, ['point', 'normal', 'tight']);
  const { normal = [0, 1, 0], tight = false } = girth;
  if (!isVector(normal) || !(Math.hypot(...normal) > 0)) throw wrongOption(`${name}.girth.normal`, 'a direction [x, y, z]', normal);
  return { kind: 'girth', point: vector(`${name}.girth.point`, girth.point), normal, tight: flag(`${name}.girth.tight`, tight) };
}

function borderAsk(name, { border }) {
  if (border !== true) throw wrongOption(`${name}.border`, 'true', border);
  return { kind: 'border' };
}

const ASKS = { points: pointsAsk, girth: girthAsk, border: borderAsk };

function askOf(name, options) {
  const asked = Object.keys(ASKS).filter((key) => options[key] !== undefined);
  if (asked.length !== 1) throw wrongOption(name, 'one of points, girth, border', asked.length === 0 ? options : asked);
  return ASKS[asked[0]](name, options);
}

/** The part of a model that is meant: {node} or {material}, by name or index. */
export function partOption(name, part) {
  if (part === undefined || part === null) return null;
  checkObject(name, part, ['node', 'material']);
  const kinds = Object.keys(part).filter((key) => part[key] !== undefined);
  if (kinds.length !== 1 || !isName(part[kinds[0]])) throw wrongOption(name, '{node} or {material}, by name or index', part);
  return { kind: kinds[0], which: part[kinds[0]] };
}

/** Longest distance over which parts are joined: a metre. */
const JOIN_MAX = 1;

/** Keys of what is measured. */
export const ASK_KEYS = ['points', 'along', 'closed', 'girth', 'border', 'part', 'join', 'variant'];
const KEYS = [...ASK_KEYS, 'pose', 'signal', 'timeoutMs'];

/**
 * What Model.measure() is asked, checked, with every default written out.
 * @param {object} options see js/api/measure.d.ts
 * @param {string} [name] of the options in messages
 * @param {string[]} [keys] that are known
 * @returns {{request: object, pose: object | undefined, signal: AbortSignal | undefined, timeoutMs: number | null | undefined}}
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function measureOptions(options, name = 'options', keys = KEYS) {
  checkObject(name, options, keys);
  const { part, join = 0, variant = '', pose, signal, timeoutMs } = options;
  if (!(join >= 0 && join <= JOIN_MAX)) throw wrongOption(`${name}.join`, `metres from 0 to ${JOIN_MAX}`, join);
  if (typeof variant !== 'string') throw wrongOption(`${name}.variant`, "a variant's name", variant);
  const request = { variant, part: partOption(`${name}.part`, part), join, ask: askOf(name, options) };
  return { request, pose, signal: checkSignal(signal), timeoutMs: loading({ timeoutMs }, STRICT).timeoutMs };
}
