/**
 * The cameras that stand in a loaded model, as the server lists them: by their number in the file, then level by level.
 *
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave, world matrices up to date.
 * @param {import('three').Box3} box - Of the model: a camera looks at the point of its axis that is nearest to the middle.
 * @param {typeof import('three')} THREE
 * @returns {object[]} Explicit cameras with a name: metres, degrees; far null = infinite.
 */
export function camerasOf({ scene, parser }, box, THREE) {
  const { json } = parser;
  const placed = [];
  scene.traverse((object) => {
    if (!object.isCamera || !isPlaced(object)) return;
    const holder = holderOf(parser, object);
    const node = json.nodes[parser.associations.get(holder).nodes];
    if (isUsable(json.cameras[node.camera])) placed.push({ object, node, number: node.camera, level: levelOf(holder, scene) });
  });
  // Nodes of one level come in the file's order already.
  placed.sort((a, b) => a.number - b.number || a.level - b.level);
  const centre = box.getCenter(new THREE.Vector3());
  return placed.map(({ object, node, number }) => {
    const source = json.cameras[number];
    return { name: source.name || node.name || '', ...lensOf(source), ...placeOf(object, centre, THREE) };
  });
}

/** The node of the file: the camera itself, or a group around it and what else the node holds. */
const holderOf = ({ associations }, object) => (associations.get(object)?.nodes === undefined ? object.parent : object);

const levelOf = (object, scene) => (object === scene ? 0 : 1 + levelOf(object.parent, scene));

/** Whether its axes are whole: a scale of zero leaves a camera no direction. */
function isPlaced({ matrixWorld }) {
  const determinant = matrixWorld.determinant();
  return Number.isFinite(determinant) && determinant !== 0;
}

/** What the server leaves out with a warning. */
function isUsable({ type, perspective, orthographic }) {
  const { znear, zfar = 0, yfov, aspectRatio = 0, xmag, ymag } = type === 'perspective' ? perspective : orthographic;
  if (zfar !== 0 && zfar <= znear) return false;
  if (type === 'perspective') return znear > 0 && yfov > 0 && yfov < Math.PI && aspectRatio >= 0;
  return znear >= 0 && zfar > 0 && xmag > 0 && ymag > 0;
}

function lensOf({ type, perspective, orthographic }) {
  if (type === 'perspective') return { projection: type, fovY: (perspective.yfov * 180) / Math.PI, near: perspective.znear, far: perspective.zfar ?? null };
  return { projection: type, height: 2 * orthographic.ymag, near: orthographic.znear, far: orthographic.zfar };
}

function placeOf(object, centre, THREE) {
  const [right, up, back, position] = [0, 1, 2, 3].map(() => new THREE.Vector3());
  object.matrixWorld.extractBasis(right, up, back);
  position.setFromMatrixPosition(object.matrixWorld);
  const forward = back.negate().normalize();
  const distance = centre.clone().sub(position).dot(forward);
  const target = position.clone().addScaledVector(forward, distance > 0 ? distance : 1);
  return { position: position.toArray(), target: target.toArray(), up: up.normalize().toArray() };
}
