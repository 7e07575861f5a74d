/** Scenes that were looked at. */
const recalled = new WeakSet();

/**
 * Tells again what of the file the objects of a model's scene are. GLTFLoader keeps that of the scene that it has loaded last, which of a file with several need not be
 * the one that is drawn: cloths, variants and parts would be found nowhere. Nodes that scenes share stay unknown: all but the first have a copy.
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave.
 */
export async function recallAssociations({ scene, parser }) {
  const { scenes = [], nodes = [] } = parser?.json ?? {};
  if (scenes.length < 2 || recalled.has(scene)) return;
  recalled.add(scene);
  const numbers = new Map();
  const visit = async (index) => {
    // It is there: the loader keeps it.
    numbers.set(await parser.getDependency('node', index), index);
    await Promise.all((nodes[index].children ?? []).map(visit));
  };
  await Promise.all((scenes[parser.json.scene ?? 0].nodes ?? []).map(visit));
  const tell = (object, known) => parser.associations.set(object, { ...known, ...parser.associations.get(object) });
  for (const [object, index] of numbers) {
    tell(object, { nodes: index });
    // One that was half told when the other scene was done lacks its mesh.
    drawnBy(object, numbers).forEach((mesh, primitives) => tell(mesh, { meshes: nodes[index].mesh, primitives }));
  }
}

/** What a node draws, a primitive each, without the nodes below it. */
function drawnBy(object, numbers) {
  const own = object.isMesh || object.isLine || object.isPoints ? [object] : [];
  return [...own, ...object.children.filter((child) => !numbers.has(child)).flatMap((child) => drawnBy(child, numbers))];
}
