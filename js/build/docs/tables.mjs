import { range } from './types.mjs';

/** Markdown tables of the shot's options and of the error codes. */

const code = (value) => `\`${typeof value === 'string' && value !== '' ? value : JSON.stringify(value)}\``;
const cell = (text) => String(text).replaceAll('|', '\\|').replaceAll('\n', ' ');

/** A line of a Markdown table. */
export const row = (cells) => `| ${cells.map(cell).join(' | ')} |`;

/** The lines that a Markdown table begins with. */
export const heading = (names) => [row(names), row(names.map(() => '---'))];

function valuesText(node) {
  if (node.tsType) return node.tsType;
  if (node.const !== undefined) return code(node.const);
  if (node.enum) return node.enum.map(code).join(' ');
  if (Array.isArray(node.type)) return node.type.map((type) => valuesText({ ...node, type })).join(', ');
  const branches = node.anyOf ?? node.oneOf;
  if (branches) return [...new Set(branches.map(valuesText))].join(', ');
  if (node.prefixItems) return `[${node.prefixItems.map(() => 'number').join(', ')}]`;
  if (node.type === 'array') return `list of ${valuesText(node.items)}`;
  if (node.type === 'object' && !node.properties) return `{name: ${valuesText(node.additionalProperties)}}`;
  if (node.type === 'integer') return `integer ${range(node)}`.trim();
  if (node.type === 'number') return `number ${range(node)}`.trim();
  return node.type;
}

const objectsOf = (node) => (node.properties ? [node] : (node.anyOf ?? node.oneOf ?? []).flatMap(objectsOf));

/** Whether an object has any names, with an object each. */
const isRecord = ({ properties, additionalProperties }) => !properties && additionalProperties?.properties !== undefined;

/** Rows of an object's keys; the objects inside follow their own row. */
function rowsOf(path, node) {
  return Object.entries(node.properties).flatMap(([key, property]) => {
    const name = path ? `${path}.${key}` : key;
    const inner = property.type === 'array' && property.items ? objectsOf(property.items) : objectsOf(property);
    const value = property.default === undefined || JSON.stringify(property.default) === '{}' ? '' : code(property.default);
    const own = row([code(name), valuesText(property), value, property.description ?? '']);
    return [
      own,
      ...(isRecord(property) ? rowsOf(`${name}.NAME`, property.additionalProperties) : []),
      ...inner.flatMap((object) => {
        const type = object.properties.type?.const;
        return rowsOf(`${name}${property.type === 'array' ? `[${type ?? ''}]` : ''}`, object);
      }),
    ].filter((line) => !/\[\w+\]\.type`/.test(line));
  });
}

/** The rows of a table of all keys. @param {object} schema JSON Schema of an object */
export const keyRows = (schema) => [...heading(['key', 'values', 'default', 'meaning']), ...new Set(rowsOf('', schema))];

/** @param {object} schema JSON Schema of the shot */
export function optionsPage(schema) {
  return [
    '# The shot',
    '',
    'What to draw: the same object for the browser client and the server. `resolveShot(shot, facts)` writes out every default.',
    'Lengths are metres, angles degrees (spot cones: radians, as in three.js), colours CSS (sRGB) or linear `[r, g, b]`. glTF axes: +Y up, the front faces +Z.',
    'Unknown keys, wrong types, NaN and values out of range are errors that name the path.',
    'This page is generated from js/shot/table by `node js/build/docs/generate.mjs`.',
    '',
    ...keyRows(schema),
    '',
    ...FRAMING,
    '',
  ].join('\n');
}

/** How a view frames, in words. */
const FRAMING = [
  '## Framing',
  '',
  'A view stands as far away as the model needs to take `camera.fit` of the frame in its tighter dimension, with its picture in the middle.',
  '',
  '* **Ground.** Where the shot has a `ground`, the shadow on it is not cut by the frame: the camera moves away and aside as far as that needs, and not',
  '  at all where the shadow is in the frame already. A shadow longer than three diagonals of the model, of a low sun or a lamp beside the model, runs',
  '  out of the frame as in a photograph. `frame: "model"` frames the model as if there were no ground.',
  '* **True scale.** With `scale` and `size` the frame is as high as these say, whatever `fit` asks for. Where it is too small for the model with its',
  '  shadow, the model is in its middle.',
  '* **Parts.** `frame: {node: "Sleeve"}` frames the nodes of that name with all beneath them, `frame: {material: "Denim"}` what wears that material in the',
  "  shot's variant; an index does too. The rest of the model is drawn, and lies in front of the part where it stands there.",
  '  The command line takes `--frame node=Sleeve`. `resolveShot` needs to know what the part measures: `renderer.factsOf(model, shot)` says it, and',
  '  `factsOf(model, { THREE, frame, variant })` of `telar/three`.',
  '* **One scale.** Each view has its own distance, so that a model that turns seems to breathe. With `fitTo: "turntable"` the pictures of one elevation share',
  '  distance, height and axis; with `fitTo: "all"` those of every direction share distance and target. `--fit-to` on the command line.',
  "* **Cuts.** `fit` above 1 lets the frame cut the model (and its shadow). The camera stays outside of the model's box.",
];

/** @param {typeof import('../../error/table.mjs').TABLE} table */
export function errorsPage(table) {
  const rows = Object.entries(table).map(([name, { kind, exit, http, retryable, meaning, cure }]) =>
    row([code(name), kind, exit, http, retryable ? 'yes' : 'no', meaning, cure]),
  );
  return [
    '# Error and warning codes',
    '',
    'The same in JavaScript (`TelarError`), `--json` of the CLI, HTTP problem+json and queue results.',
    'Exit codes: 0 done, 1 compared and over the gate, 2 usage, 3 input, 4 limit, 5 time or memory, 6 this machine, 7 internal or a crash.',
    'Of many models in one run, the highest exit code is told.',
    'This page is generated from js/error/table.mjs by `node js/build/docs/generate.mjs`.',
    '',
    ...heading(['code', 'kind', 'exit', 'HTTP', 'retry', 'meaning', 'cure']),
    ...rows,
    '',
  ].join('\n');
}

/**
 * Rows of the properties of a hand-written JSON Schema, references resolved.
 * @param {object} schema
 */
export function fieldRows(schema) {
  const resolved = ({ $ref, ...node }) => ({ ...($ref && schema.$defs[$ref.split('/').at(-1)]), ...node });
  const rows = (prefix, properties) =>
    Object.entries(properties).flatMap(([key, property]) => {
      const node = resolved(property);
      const isInfo = property.$ref?.endsWith('textureInfo');
      const value = node.default === undefined ? '' : code(node.default);
      const own = row([code(`${prefix}${key}`), isInfo ? 'textureInfo' : fieldType(node), value, node.description ?? '']);
      return [own, ...(node.properties && !isInfo ? rows(`${prefix}${key}.`, node.properties) : [])];
    });
  return [...heading(['property', 'values', 'default', 'meaning']), ...rows('', schema.properties)];
}

const fieldType = (node) => (node.type === 'array' ? `${node.minItems} x ${valuesText(node.items)}` : valuesText(node));
