/**
 * The nodes that an object hangs on, itself first, by the file's numbers and names; without a file those of the scene.
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave.
 * @param {import('three').Object3D} object
 * @returns {{index: number, name: string}[]}
 */
export function nodesOf({ scene, parser }, object) {
  const nodes = [];
  for (let at = object; at; at = at === scene ? null : at.parent) {
    const index = parser ? parser.associations.get(at)?.nodes : at.id;
    if (index !== undefined) nodes.push({ index, name: parser ? parser.json.nodes[index].name : at.name });
  }
  return nodes;
}
