import { flat as FLAT } from '../shot/table/flat.mjs';
import { partOption } from './measure_options.mjs';
import { checkObject, checkSignal, loading, STRICT, wrongOption } from './options.mjs';

const KEYS = ['part', 'join', 'scale', 'creaseAngle', 'foldDepth', 'foldLength', 'tolerance', 'stitched', 'weights', 'color', 'signal', 'timeoutMs'];

/** Defaults are those of the shot's `flat`. */
const ROWS = FLAT.shape;
const defaultsOf = (rows) => Object.freeze(Object.fromEntries(Object.entries(rows).map(([key, row]) => [key, row.default])));

/** Line weights in millimetres. */
export const WEIGHTS = defaultsOf(ROWS.weights.shape);

function number(name, value, min, max, what) {
  if (typeof value === 'number' && value >= min && value <= max) return value;
  throw wrongOption(name, `${what} from ${min} to ${max}`, value);
}

function weightsOf(weights) {
  checkObject('options.weights', weights, Object.keys(WEIGHTS));
  const given = Object.entries(weights).filter(([, weight]) => weight !== undefined);
  for (const [kind, weight] of given) number(`options.weights.${kind}`, weight, 0, 10, 'millimetres');
  return { ...WEIGHTS, ...Object.fromEntries(given) };
}

function stitchedOf(stitched) {
  if (!Array.isArray(stitched)) throw wrongOption('options.stitched', 'a list of {node} or {material}', stitched);
  return stitched.map((part, i) => {
    if (part === null || part === undefined) throw wrongOption(`options.stitched[${i}]`, '{node} or {material}, by name or index', part);
    return partOption(`options.stitched[${i}]`, part);
  });
}

/** A colour of SVG that needs no escape. */
const COLOR = /^(#[0-9a-fA-F]{3,8}|[a-zA-Z]{3,20})$/;

/**
 * Options of Model.flat() with every default written out.
 * @param {object} options see js/api/flat.d.ts
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function flatOptions(options) {
  checkObject('options', options, KEYS);
  const {
    part,
    join = ROWS.join.default,
    scale,
    creaseAngle = ROWS.creaseAngle.default,
    foldDepth = ROWS.foldDepth.default,
    foldLength = ROWS.foldLength.default,
    tolerance = ROWS.tolerance.default,
    stitched = [],
    weights = {},
    color = 'black',
  } = options;
  if (scale !== undefined) number('options.scale', scale, 1e-3, 1e4, 'n of the scale 1:n,');
  if (typeof color !== 'string' || !COLOR.test(color)) throw wrongOption('options.color', 'a CSS name or #rrggbb', color);
  return {
    request: {
      part: partOption('options.part', part),
      join: number('options.join', join, 0, 1, 'metres'),
      creaseAngle: number('options.creaseAngle', creaseAngle, 1, 180, 'degrees'),
      foldDepth: number('options.foldDepth', foldDepth, 0, 1e3, 'metres'),
      foldLength: number('options.foldLength', foldLength, 0, 1, 'part of the height of the picture'),
      tolerance: number('options.tolerance', tolerance, 0, 10, 'pixels'),
      stitched: stitchedOf(stitched),
    },
    style: { scale, weights: weightsOf(weights), color },
    signal: checkSignal(options.signal),
    timeoutMs: loading({ timeoutMs: options.timeoutMs }, STRICT).timeoutMs,
  };
}
