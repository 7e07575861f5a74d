import { LAYERS, texturesOf } from '../../material/table.mjs';
import { assignMaterial } from '../assign_material.mjs';
import { sheenDye, transmissionDye } from '../dye.mjs';
import { asNumbers } from './number_maps.mjs';

/** Names of glTF for what GLTFLoader leaves to us. */
const FABRIC = 'TELAR_materials_fabric';
const DIFFUSE_TRANSMISSION = 'KHR_materials_diffuse_transmission';

/** Textures within an extension: path of keys, whether their colours are sRGB. */
const texturesIn = (name) =>
  LAYERS.filter(({ extension }) => extension === name)
    .flatMap(texturesOf)
    .map(({ key, within, srgb }) => [[...(within ? [within] : []), key], srgb]);

/** What the file says of its materials, with presets and without; for each parser. */
const filled = new WeakMap();

/**
 * What the file says of a material, with the values of its fabric's preset where it says nothing; as renderer/asset does it.
 * @param {object} parser - Of GLTFLoader.
 * @param {number} index - In the file's materials.
 * @param {(() => Promise<{PRESETS: Record<string, {material: object}>}>) | null} loadPresets - null for no presets.
 * @returns {Promise<{definition: object, isPreset: boolean}>} Extension `TELAR_materials_fabric` in place of extras.
 */
async function definitionOf(parser, index, loadPresets) {
  const { extras, ...definition } = parser.json.materials[index];
  const fabric = definition.extensions?.[FABRIC] ?? extras?.[FABRIC];
  if (!fabric) return { definition, isPreset: false };
  const own = { ...definition, extensions: { ...definition.extensions, [FABRIC]: fabric } };
  const presets = loadPresets && fabric.preset ? (await loadPresets()).PRESETS : {};
  const preset = Object.hasOwn(presets, fabric.preset) && presets[fabric.preset];
  return preset ? { definition: dyed(merged(preset.material, own), own), isPreset: true } : { definition: own, isPreset: false };
}

const SHEEN = 'KHR_materials_sheen';

/** The preset's sheen, and its light that passes through, in the colour of a material that says nothing of them. */
function dyed(definition, own) {
  const color = definition.pbrMetallicRoughness?.baseColorFactor;
  if (!color) return definition;
  const extensions = { ...definition.extensions };
  const dye = (extension, key, factors) => {
    const layer = extensions[extension];
    if (!layer || own.extensions[extension]?.[key]) return;
    extensions[extension] = { ...layer, [key]: (layer[key] ?? [1, 1, 1]).map((c, i) => c * factors[i]) };
  };
  dye(SHEEN, 'sheenColorFactor', sheenDye(color));
  dye(DIFFUSE_TRANSMISSION, 'diffuseTransmissionColorFactor', transmissionDye(color));
  return { ...definition, extensions };
}

/** RFC 7396: `patch` over `target`. */
function merged(target, patch) {
  if (typeof patch !== 'object' || patch === null || Array.isArray(patch)) return patch;
  const result = typeof target === 'object' && target !== null && !Array.isArray(target) ? { ...target } : {};
  for (const [key, value] of Object.entries(patch)) {
    if (value === null) delete result[key];
    else result[key] = merged(result[key], value);
  }
  return result;
}

/**
 * The material that cloth is drawn with where the file names a preset: loaded as GLTFLoader loads the file's own.
 * @param {object} parser - Of GLTFLoader.
 * @param {import('three').Mesh} mesh - Whose geometry decides on vertex colours and tangents.
 * @param {import('three').Material} original - Its material.
 * @param {(() => Promise<object>) | null} loadPresets
 * @returns {Promise<{material: import('three').Material, definition: object | null}>}
 */
export async function clothOf(parser, mesh, original, loadPresets) {
  const index = parser?.associations.get(original)?.materials;
  if (index === undefined) return { material: original, definition: null };
  if (!filled.has(parser)) filled.set(parser, new Map());
  const known = filled.get(parser);
  const key = `${index} ${loadPresets !== null}`;
  if (!known.has(key)) known.set(key, loadCloth(parser, index, loadPresets));
  const { definition, material } = await known.get(key);
  return { definition, material: material ? finalMaterial(parser, mesh, material) : original };
}

async function loadCloth(parser, index, loadPresets) {
  const { definition, isPreset } = await definitionOf(parser, index, loadPresets);
  if (!isPreset) return { definition, material: null };
  // By a name, which is none of the file's numbers: the list of its materials stays as it is.
  const added = `${index} with its preset`;
  parser.json.materials[added] = definition;
  return { definition, material: await parser.getDependency('material', added) };
}

/** The material as GLTFLoader gives it to a mesh. */
function finalMaterial(parser, mesh, material) {
  const before = mesh.material;
  assignMaterial(parser, mesh, material);
  const result = mesh.material;
  mesh.material = before;
  return result;
}

/**
 * The two extensions of a material, their textures loaded.
 * @param {object} parser - Of GLTFLoader.
 * @param {object | null} definition - As of clothOf.
 * @param {typeof import('three')} THREE
 * @param {(texture: import('three').Texture) => import('three').Texture} [placed] - Of a cloth that a shot put on: its texture on the garment.
 * @returns {Promise<{fabric: object | null, diffuseTransmission: object | null}>} As FabricMaterial takes them.
 */
export async function extensionsOf(parser, definition, THREE, placed = (texture) => texture) {
  const [fabric, diffuseTransmission] = await Promise.all(
    [FABRIC, DIFFUSE_TRANSMISSION].map(async (name) => {
      const extension = definition?.extensions?.[name];
      if (!extension) return null;
      const copy = structuredClone(extension);
      await Promise.all(
        texturesIn(name).map(([path, isColor]) => {
          if (isColor) return loadTexture(parser, copy, path, THREE.SRGBColorSpace, placed);
          return loadTexture(parser, copy, path, undefined, (texture) => placed(asNumbers(THREE, texture)));
        }),
      );
      return copy;
    }),
  );
  return { fabric, diffuseTransmission };
}

/**
 * What the back leaves out is as on the front, also where that is dyed.
 * @param {object | null} fabric - Of extensionsOf().
 * @param {import('three').MeshPhysicalMaterial} front - As it is drawn.
 */
export function finishBack(fabric, { color, map, roughness }) {
  const back = fabric?.back;
  if (!back) return;
  if (back.baseColorFactor === undefined && back.baseColorTexture === undefined)
    Object.assign(back, { baseColorFactor: color.toArray(), baseColorTexture: map });
  back.roughnessFactor ??= roughness;
}

/** Puts the texture itself in place of what the file says of it. */
async function loadTexture(parser, extension, path, colorSpace, placed) {
  const key = path.at(-1);
  const holder = path.slice(0, -1).reduce((part, name) => part?.[name], extension);
  if (!holder?.[key]) return;
  const reference = holder[key];
  delete holder[key];
  await parser.assignTexture(holder, key, reference, colorSpace);
  if (holder[key]) holder[key] = placed(holder[key]);
}
