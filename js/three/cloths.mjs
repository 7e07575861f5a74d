import { dressingsOf } from '../shot/dressings.mjs';
import { assignMaterial } from './assign_material.mjs';
import { sheenDye, transmissionDye } from './dye.mjs';
import { nodesOf } from './nodes.mjs';
import { metresPerUv, wearersOf } from './uv_scale.mjs';
import { materialIndexOf } from './variant.mjs';

/** Parts of a model in another cloth: `materials` of the shot, as renderer/asset/scene/dress.cpp puts them on. */

/** What a mesh had before it was dressed. */
const undressed = new WeakMap();

/**
 * Of a material that was put on.
 * @typedef {object} Worn
 * @property {object} parser - Of the file that says what it is made of.
 * @property {import('three').Material} material - As that file has it.
 * @property {(material: import('three').Material) => void} finish - Changes a copy of that into what is worn, the color for one.
 * @property {(texture: import('three').Texture) => import('three').Texture | null} placed - A texture of that file, on the garment.
 * @property {(layer: object) => object} through - Its KHR_materials_diffuse_transmission in the colour that is worn.
 */

/** @type {WeakMap<import('three').Material, Worn>} */
const worn = new WeakMap();

/** @returns {Worn | undefined} */
export const wornCloth = (material) => worn.get(material);

/**
 * What the parts of a model are called, in the file's words.
 * @param {{scene: import('three').Object3D, parser: object}} model - What GLTFLoader gave.
 * @returns {import('../shot/dressings.mjs').Names}
 */
export function namesOf({ scene, parser }) {
  const nodes = [];
  const visit = (object, parent) => {
    const node = object === scene ? undefined : parser.associations.get(object)?.nodes;
    const isNew = node !== undefined && node !== nodes[parent]?.node;
    if (isNew) nodes.push({ node, name: parser.json.nodes[node].name ?? '', parent });
    const at = isNew ? nodes.length - 1 : parent;
    for (const child of object.children) visit(child, at);
  };
  visit(scene, -1);
  return { materials: (parser.json.materials ?? []).map(({ name = '' }) => name), nodes };
}

/** Gives every mesh back what it had before it was dressed. */
export function takeOffCloths(scene) {
  scene.traverse((mesh) => {
    const before = undressed.get(mesh);
    if (before) Object.assign(mesh, before);
    undressed.delete(mesh);
  });
}

/** What the meshes of a model wear, by its scene: made once for as long as shots put on the same. */
const wardrobes = new WeakMap();

/**
 * Puts the cloths of a shot on a model that shows its own materials, in the shot's variant and pose.
 * @param {object} shot - Resolved.
 * @param {{scene: import('three').Object3D, parser: object}} model
 * @param {object} options
 * @param {typeof import('three')} options.THREE
 * @param {(preset: string) => Promise<{scene: import('three').Object3D, parser: object}>} [options.cloths] - Gives js/assets/cloths/PRESET.glb
 *   as GLTFLoader loads it.
 */
export async function putOnCloths({ materials, variant, pose }, model, { THREE, cloths }) {
  const key = JSON.stringify([Object.entries(materials), variant, pose]);
  let wardrobe = wardrobes.get(model.scene);
  if (wardrobe?.key !== key) {
    wardrobe?.made.forEach((item) => item.dispose());
    wardrobes.delete(model.scene);
    if (Object.keys(materials).length === 0) return;
    wardrobe = await fill({ key, made: new Set(), looks: new Map() }, { materials, variant }, model, { THREE, cloths });
    wardrobes.set(model.scene, wardrobe);
  }
  for (const [mesh, look] of wardrobe.looks) {
    undressed.set(mesh, { material: mesh.material, geometry: mesh.geometry });
    Object.assign(mesh, look);
  }
}

/** Makes what the meshes are to wear: `looks` by mesh, and in `made` what is to be disposed of with it. */
async function fill(wardrobe, { materials, variant }, model, { THREE, cloths }) {
  const dressings = dressingsOf(materials, namesOf(model));
  if (!cloths && dressings.some(({ preset }) => preset !== null))
    throw new Error('shot.materials: give applyShot `cloths`, which loads telar/cloths/PRESET.glb by GLTFLoader');
  model.scene.updateMatrixWorld(true);
  const opened = new Map();
  for (const [mesh, { index, dressing }] of wearers(model, variant, dressings)) {
    const key = `${dressings.indexOf(dressing)} ${index}`;
    if (!opened.has(key)) opened.set(key, await open(model, index, dressing, { THREE, cloths, made: wardrobe.made }));
    const look = opened.get(key)(mesh);
    if (!look) continue;
    wardrobe.looks.set(mesh, look);
    wardrobe.made.add(look.material);
    if (look.geometry !== mesh.geometry) wardrobe.made.add(look.geometry);
  }
  return wardrobe;
}

/** The meshes that are dressed, each with the dressing that holds: the last of its node, else the last of its material. */
function wearers(model, variant, dressings) {
  const found = new Map();
  model.scene.traverse((mesh) => {
    if (!mesh.isMesh && !mesh.isLine && !mesh.isPoints) return;
    const index = materialIndexOf(model.parser, mesh, variant);
    if (index === undefined) return;
    // A mesh of several primitives is a group of the node.
    const node = nodesOf(model, mesh)[0]?.index;
    const dressing = dressings.findLast(({ nodes }) => nodes.includes(node)) ?? dressings.findLast(({ materials }) => materials.includes(index));
    if (dressing) found.set(mesh, { index, dressing });
  });
  return found;
}

/** @returns {Promise<(mesh: import('three').Mesh) => object | undefined>} What a mesh that wears this material of the file shows instead: {material, geometry}. */
async function open(model, index, dressing, { THREE, cloths, made }) {
  const color = dressing.color && new THREE.Color().setRGB(...dressing.color, THREE.LinearSRGBColorSpace);
  if (dressing.preset === null) return (mesh) => color && recolored(model, mesh, color);
  const { scene, parser } = await cloths(dressing.preset);
  scene.updateMatrixWorld(true);
  const square = firstMesh(scene);
  // As the file has it: GLTFLoader has changed that of the square for its geometry.
  const material = await parser.getDependency('material', parser.associations.get(square.material).materials);
  const [garment, tile] = [metresPerUv(wearersOf(model, index), THREE), metresPerUv([square], THREE)];
  const matrix = garment && tile && placement(THREE, dressing.metresPerUv ?? garment, tile, dressing);
  const placed = memo((texture) => {
    const out = placedTexture(texture, matrix);
    if (out) made.add(out);
    return out;
  });
  return (mesh) => {
    const own = { material: mesh.material, geometry: mesh.geometry };
    if (dressing.rotation !== 0) mesh.geometry = withoutTangents(mesh.geometry);
    assignMaterial(model.parser, mesh, dressed(own.material, material, color, placed));
    const look = { material: mesh.material, geometry: mesh.geometry };
    Object.assign(mesh, own);
    const map = color || material.map ? undefined : own.material.map;
    const through = (layer) => withColor(layer, transmissionDye((color ?? own.material.color).toArray()), map);
    worn.set(look.material, { parser, material, finish: (copy) => copy.copy(look.material), placed, through });
    return look;
  };
}

/** A mesh's own material in another color. A picture that cuts its shape out stays. */
function recolored(model, mesh, color) {
  const own = mesh.material;
  const isDyed = !own.sheenColor || own.sheenColor.getHex() === 0; // a sheen that the file does not have is the preset's
  const [before, after] = [own.color, color].map((dye) => sheenDye(dye.toArray()));
  const finish = (copy) => {
    if (isDyed && copy.sheenColor) scaleColor(copy.sheenColor, (i) => after[i] / before[i]);
    copy.color.copy(color);
    if (!own.transparent && own.alphaTest === 0) copy.map = null;
  };
  const material = own.clone();
  finish(material);
  const [had, has] = [own.color, color].map((dye) => transmissionDye(dye.toArray()));
  const isOwn = saysThrough(model.parser, own);
  const through = (layer) =>
    isOwn
      ? layer
      : withColor(
          layer,
          has.map((c, i) => c / had[i]),
        );
  worn.set(material, { parser: model.parser, material: own, finish, placed: (texture) => texture, through });
  return { material, geometry: mesh.geometry };
}

/** Whether the file itself has light that passes through the material. */
function saysThrough({ associations, json }, material) {
  const { diffuseTransmissionFactor = 0 } = json.materials[associations.get(material)?.materials]?.extensions?.KHR_materials_diffuse_transmission ?? {};
  return diffuseTransmissionFactor > 0;
}

/** KHR_materials_diffuse_transmission with its colour multiplied, and a picture in place of none. */
function withColor(layer, factor, map) {
  const { diffuseTransmissionColorFactor: color = [1, 1, 1] } = layer;
  const texture = layer.diffuseTransmissionColorTexture ?? map;
  return { ...layer, diffuseTransmissionColorFactor: color.map((c, i) => c * factor[i]), ...(texture && { diffuseTransmissionColorTexture: texture }) };
}

const scaleColor = (color, factor) => color.fromArray(color.toArray().map((c, i) => c * factor(i)));

/** The tangents of a geometry stand along texture coordinates that a turned pattern does not have. */
const withoutTangents = (geometry) => (geometry.attributes.tangent ? geometry.clone().deleteAttribute('tangent') : geometry);

function firstMesh(scene) {
  let found;
  scene.traverse((object) => {
    found ??= object.isMesh ? object : undefined;
  });
  return found;
}

function memo(make) {
  const made = new Map();
  return (key) => {
    if (!made.has(key)) made.set(key, make(key));
    return made.get(key);
  };
}

/** From a garment's texture coordinates to those of a cloth: to metres, turned, to the cloth's own measure. */
function placement(THREE, garment, tile, { scale, rotation }) {
  const angle = THREE.MathUtils.degToRad(rotation);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const per = tile.map((metres) => 1 / (metres * scale));
  return new THREE.Matrix3().set(garment[0] * c * per[0], -garment[1] * s * per[0], 0, garment[0] * s * per[1], garment[1] * c * per[1], 0, 0, 0, 1);
}

/** A texture of the cloth where the garment has it; null where the garment has no texture coordinates. */
function placedTexture(texture, matrix) {
  if (!matrix) return null;
  const out = texture.clone();
  if (texture.matrixAutoUpdate) texture.updateMatrix();
  out.matrixAutoUpdate = false;
  out.matrix.multiplyMatrices(texture.matrix, matrix);
  out.channel = 0;
  return out;
}

function dressed(own, cloth, color, placed) {
  const out = cloth.clone();
  for (const [key, value] of Object.entries(out)) if (value?.isTexture) out[key] = placed(value);
  Object.assign(out, { name: own.name, side: own.side, aoMap: own.aoMap, aoMapIntensity: own.aoMapIntensity });
  const mean = out.map ? meanColor(out.map) : [1, 1, 1];
  const { r, g, b } = color ?? own.color;
  const dye = sheenDye([r, g, b]);
  if (out.sheenColor) scaleColor(out.sheenColor, (i) => dye[i]);
  out.color.setRGB(r / mean[0], g / mean[1], b / mean[2]);
  if (color || cloth.map) return out;
  return Object.assign(out, { map: own.map, transparent: own.transparent, opacity: own.opacity, alphaTest: own.alphaTest, depthWrite: own.depthWrite });
}

const linear = (code) => (code <= 0.04045 * 255 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4);

/** Mean of what is there of a picture of a colour, linear: the colour of a cloth is the mean of what its picture shows. */
const meanColor = memo(({ image }) => {
  const canvas = new OffscreenCanvas(image.width, image.height);
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  const { data } = context.getImageData(0, 0, image.width, image.height);
  const sum = [0, 0, 0, 0];
  for (let i = 0; i < data.length; i += 4) {
    for (let c = 0; c < 3; c++) sum[c] += data[i + 3] * linear(data[i + c]);
    sum[3] += data[i + 3];
  }
  return sum.every((value) => value > 0) ? sum.slice(0, 3).map((value) => value / sum[3]) : [1, 1, 1];
});
