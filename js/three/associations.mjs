/** Scenes that were looked at. */
const recalled = new WeakSet();

/**
 * Tells again what of the file the objects of a model's scene are. GLTFLoader keeps that of the scene that it has loaded last, which of a file with several need not be
 * the one that is drawn: parts of it would be found nowhere. The loader adds the nodes of a scene in the file's order, and those below a node behind what that draws.
 * @param {{scene: import('three').Object3D, scenes?: import('three').Object3D[], parser?: object}} model - What GLTFLoader gave, as it gave it.
 */
export function recallAssociations({ scene, scenes = [], parser }) {
  const { scenes: files = [], nodes = [], scene: first = 0 } = parser?.json ?? {};
  if (files.length < 2 || recalled.has(scene)) return;
  recalled.add(scene);
  const numbers = new Map();
  const visit = (object, index) => {
    if (!object) return; // a caller has taken it out
    numbers.set(object, index);
    const { children = [] } = nodes[index];
    const own = object.children.length - children.length;
    for (const [i, child] of children.entries()) visit(object.children[own + i], child);
  };
  const drawn = files[scenes.includes(scene) ? scenes.indexOf(scene) : first];
  for (const [i, index] of (drawn.nodes ?? []).entries()) visit(scene.children[i], index);
  const tell = (object, known) => parser.associations.set(object, { ...known, ...parser.associations.get(object) });
  for (const [object, index] of numbers) {
    tell(object, { nodes: index });
    // One that was half told when the other scene was done lacks its mesh.
    for (const [primitives, mesh] of drawnBy(object, numbers).entries()) tell(mesh, { meshes: nodes[index].mesh, primitives });
  }
}

/** What a node draws, a primitive each, without the nodes below it. */
function drawnBy(object, numbers) {
  const own = object.isMesh || object.isLine || object.isPoints ? [object] : [];
  return [...own, ...object.children.filter((child) => !numbers.has(child)).flatMap((child) => drawnBy(child, numbers))];
}
