import { matchesName } from '../shot/name_pattern.mjs';
import { nodesOf } from './nodes.mjs';
import { materialIndexOf } from './variant.mjs';

/** The materials that stand in for others, with those. */
const solid = new WeakMap();
/** Of each model's scene, by material, those that stood in for it: one for each opacity that it had at once. They are kept for the next shot. */
const ghosts = new WeakMap();
/** Meshes that a ghost was made of, with whether they cast shadows. */
const casting = new WeakMap();

/** A name as a ghost gives it: * stands for any characters. */
const matches = (wanted, index, name = '') => (typeof wanted === 'number' ? wanted === index : matchesName(wanted, name));

const mapped = (material, change) => (Array.isArray(material) ? material.map(change) : change(material));

/** Puts back what applyGhosts() has put others in place of. @param {import('three').Object3D} root */
export function removeGhosts(root) {
  root.traverse((object) => {
    if (!object.material) return;
    object.material = mapped(object.material, (material) => solid.get(material) ?? material);
    if (casting.has(object)) object.castShadow = casting.get(object);
    casting.delete(object);
  });
}

/** The last ghosts of a node that an object hangs on, and of its material; none for a scene without a parser. */
function ghostsOf(model, object, { ghost, variant }) {
  const { parser } = model;
  const last = [];
  if (!parser) return last;
  const nodes = nodesOf(model, object);
  const index = materialIndexOf(parser, object, variant);
  for (const part of ghost) {
    const { node, material } = part;
    if (node !== undefined && nodes.some((one) => matches(node, one.index, one.name))) last[0] = part;
    if (material !== undefined && index !== undefined && matches(material, index, parser.json.materials[index].name)) last[1] = part;
  }
  return last.filter(Boolean);
}

/** Opacity of what an object draws: that of its node times that of its material. */
const opacityOf = (model, object, shot) => ghostsOf(model, object, shot).reduce((product, { opacity }) => product * opacity, 1);

/**
 * Whether a shot leaves out what an object draws.
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave.
 * @param {import('three').Object3D} object
 * @param {{ghost: object[], variant: string}} shot - Resolved, or not.
 */
export const isLeftOut = (model, object, shot) => ghostsOf(model, object, shot).some(({ opacity }) => opacity === 0);

/** Ghosts of a material, for a model. @returns {import('three').Material[]} */
function ghostsFor({ scene }, material) {
  if (!ghosts.has(scene)) ghosts.set(scene, new WeakMap());
  const ofModel = ghosts.get(scene);
  if (!ofModel.has(material)) ofModel.set(material, []);
  return ofModel.get(material);
}

/** A material that goes with another one. */
function companionOf(material) {
  const made = new material.constructor();
  material.addEventListener('dispose', () => made.dispose());
  return made;
}

/** A copy of a material as it is now, blended as GLTFLoader sets up alpha mode BLEND. @param {number} place - Among its ghosts. */
function ghostOf(model, material, opacity, place) {
  const made = ghostsFor(model, material);
  made[place] ??= companionOf(material);
  const ghost = made[place].copy(material);
  // The opacity of what is opaque is none. The alpha of its map and vertices counts, as on the server.
  const own = material.transparent || material.alphaTest > 0 ? material.opacity : 1;
  Object.assign(ghost, {
    transparent: true,
    depthWrite: false,
    alphaTest: 0,
    opacity: own * opacity,
    visible: material.visible && opacity > 0,
    needsUpdate: true,
  });
  solid.set(ghost, material);
  return ghost;
}

/**
 * Draws parts of a model translucent, or not at all, as the server does (renderer/frame/ghosts.h). After variant and shading.
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave.
 * @param {{ghost: object[], variant: string}} shot - Resolved.
 */
export function applyGhosts(model, shot) {
  if (shot.ghost.length === 0 || !model.parser) return;
  const made = new Map();
  model.scene.traverse((object) => {
    if (!object.material) return;
    const opacity = opacityOf(model, object, shot);
    if (opacity === 1) return;
    object.material = mapped(object.material, (material) => {
      if (!made.has(material)) made.set(material, new Map());
      const byOpacity = made.get(material);
      if (!byOpacity.has(opacity)) byOpacity.set(opacity, ghostOf(model, material, opacity, byOpacity.size));
      return byOpacity.get(opacity);
    });
    casting.set(object, object.castShadow);
    object.castShadow = false;
  });
}
