import { INDEX_MAX } from '../../shot/table/rows.mjs';

/** TypeScript from JSON Schema (the subset that zod writes for the shot). */

const indent = (text) => text.replaceAll('\n', '\n  ');
const literal = (value) => (typeof value === 'string' ? `'${value}'` : JSON.stringify(value));
const identifier = (key) => (/^[A-Za-z_$][\w$]*$/.test(key) ? key : `'${key}'`);

/** "0 to 1", "above 0", "" */
export function range({ minimum, maximum, exclusiveMinimum }) {
  // The largest index or float is no bound that a reader needs.
  const ends = [minimum, maximum].map((x) => (x === undefined || Math.abs(x) >= INDEX_MAX ? undefined : Number(x.toPrecision(6))));
  const low = exclusiveMinimum === undefined ? ends[0] : `above ${exclusiveMinimum}`;
  if (low === undefined) return ends[1] === undefined ? '' : `at most ${ends[1]}`;
  if (ends[1] !== undefined) return `${low} to ${ends[1]}`;
  return exclusiveMinimum === undefined ? `at least ${low}` : low;
}

function comment(node) {
  const parts = [
    node.description,
    range(node) && `Range ${range(node)}.`,
    node.default !== undefined && JSON.stringify(node.default) !== '{}' && `@default ${JSON.stringify(node.default)}`,
  ].filter(Boolean);
  return parts.length > 0 ? `/** ${parts.map((part) => (/[.!?]$|^@/.test(part) ? part : `${part}.`)).join(' ')} */\n` : '';
}

function objectType({ properties, additionalProperties, required = [] }, foreign = []) {
  if (!properties) return `Record<string, ${typeText(additionalProperties)}>`;
  const lines = Object.entries(properties).map(([key, node]) => `${comment(node)}${identifier(key)}${required.includes(key) ? '' : '?'}: ${typeText(node)};`);
  lines.push(...foreign.map((key) => `${identifier(key)}?: never;`));
  return `{\n  ${indent(lines.join('\n'))}\n}`;
}

/** Type expression of a schema node. */
export function typeText(node) {
  if (node.tsType) return node.tsType;
  if (node.const !== undefined) return literal(node.const);
  if (node.enum) return node.enum.map(literal).join(' | ');
  if (Array.isArray(node.type)) return node.type.map((type) => typeText({ ...node, type })).join(' | ');
  if (node.oneOf) return node.oneOf.map(typeText).join(' | ');
  if (node.anyOf) return unionText(node.anyOf);
  if (node.prefixItems) return `[${node.prefixItems.map(typeText).join(', ')}]`;
  switch (node.type) {
    case 'object':
      return objectType(node);
    case 'array':
      return arrayType(typeText(node.items));
    case 'integer':
      return 'number';
    case 'number':
    case 'string':
    case 'boolean':
    case 'null':
      return node.type;
    default:
      throw new Error(`no type for ${JSON.stringify(node)}`);
  }
}

/**
 * Without a key that tells the branches apart, TypeScript lets an object mix theirs: each branch forbids the others' keys.
 */
function unionText(branches) {
  const keys = new Set(branches.flatMap(({ properties = {} }) => Object.keys(properties)));
  return branches
    .map((branch) =>
      branch.properties
        ? objectType(
            branch,
            [...keys].filter((key) => !Object.hasOwn(branch.properties, key)),
          )
        : typeText(branch),
    )
    .join(' | ');
}

const arrayType = (element) => (/[|{]/.test(element) ? `Array<${element}>` : `${element}[]`);

export const interfaceText = (name, doc, node) => `/** ${doc} */\nexport interface ${name} ${objectType(node)}\n`;
