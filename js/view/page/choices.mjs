import schema from '../../shot/schema.json' with { type: 'json' };

/** Values and defaults as the schema of the shot declares them. */

const branches = (node) => (node ? [node, ...(node.anyOf ?? node.oneOf ?? [])] : []);

/** Node of a dotted path such as "camera.fit", in the first branch that has it; undefined where none has. */
const nodeAt = (path) => path.split('.').reduce((node, key) => branches(node).find(({ properties }) => properties?.[key])?.properties[key], schema);

/** @returns {string[]} the names that a key of the shot takes */
export const choicesOf = (path) => branches(nodeAt(path)).find((node) => node.enum)?.enum ?? [];

/** @returns {unknown} the value of a key that a shot leaves out */
export const defaultOf = (path) => nodeAt(path)?.default;

/** Whether a shot may have the key. */
export const hasKey = (path) => nodeAt(path) !== undefined;
