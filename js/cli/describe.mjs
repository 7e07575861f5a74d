import { readFileSync } from 'node:fs';

/** Texts of the help, taken from the JSON Schema of the shot, so that the help and the schema cannot disagree. */

let schema;
const rootSchema = () => (schema ??= JSON.parse(readFileSync(new URL('../shot/schema.json', import.meta.url), 'utf8')));

const branchesOf = (node) => [node, ...(node.anyOf ?? node.oneOf ?? [])];

/** Schema node of a dotted path such as "camera.view", the first branch that has it. */
function nodeAt(path) {
  return path.split('.').reduce((node, key) => {
    const found = branchesOf(node).find(({ properties }) => properties && Object.hasOwn(properties, key));
    if (!found) throw new Error(`js/cli: the shot has no ${path}`);
    return found.properties[key];
  }, rootSchema());
}

/** Description of a key, with its values where they are few. */
export function describe(path) {
  const node = nodeAt(path);
  const values = branchesOf(node).find((branch) => branch.enum)?.enum;
  return values ? `${node.description} (${values.join(', ')})` : node.description;
}
