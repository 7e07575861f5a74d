/**
 * What telar reads of a material beyond metallic-roughness, one row a property. The one source of it: js/build/material
 * writes from it, when CMake configures, the loader's rules and readers, the fields of the material, the
 * texture slots, the features of programs, and the inputs of the shaders; js/build/shading and js/three have from it what
 * the browser calls the same. No imports: it runs in browsers too.
 *
 * @typedef {object} Row
 * @property {string} key - In glTF; in C++ the field has the same name.
 * @property {'float' | 'vec2' | 'vec3' | 'name'} [type] - float where it is left out; colours are linear Rec.709; a name is for
 *   the loader alone.
 * @property {number} [default] - 0 where it is left out.
 * @property {number} [min] - 0 where it is left out.
 * @property {number} [max] - 1 where it is left out. What lies outside of the range is clamped with W_RANGE.
 * @property {'angle' | 'ior' | 'distance'} [kind] - angle: radians, any number; ior: 0 stands for the most; distance: 0 stands
 *   for infinity.
 * @property {string} [extension] - That it stands in, where that is not the layer's.
 * @property {string} [within] - Object of the extension that it stands in; such rows have readers of their own.
 * @property {string} [unit] - For the comment.
 * @property {Texture} [texture] - Whose texel it is multiplied by.
 * @property {string} [input] - Name in MaterialInputs (shaders/material); null: no shading reads it there. Left out: the key
 *   without "Factor".
 * @property {string} [declaredIf] - Features of which one makes shaders declare it, where that is not the layer's alone.
 * @property {string} [cpp] - What programs take, over `l` and `key`; left out: the field itself.
 * @property {string} [three] - Name in MeshPhysicalMaterial; that of its texture is the same with "Map".
 *
 * @typedef {object} Texture
 * @property {string} key - In glTF; in C++ the field has the same name.
 * @property {string} [name] - In the shaders, where it is not the key without "Texture": NAMEMap, vNAMEUv, NAMEUvTransform.
 * @property {string} channels - r, g, b, a or rgb.
 * @property {boolean} [srgb] - A colour.
 * @property {boolean} [asked] - Shaders read it by functions NAMEUv() and NAMETexel(uv) where they will.
 *
 * @typedef {object} Layer
 * @property {string} name - Of its feature, as a member of VariantKey; in shaders NAME.
 * @property {string} extension
 * @property {'layers' | 'fabric'} member - Of Material that holds it.
 * @property {string} when - Condition in C++ over `l`, and `m`, the material, under which it shows: else it is not compiled in.
 * @property {boolean} [keepsTextures] - They are read whatever the factors; else under that condition alone, as nothing reads them.
 * @property {string} [label] - In info.features.
 * @property {boolean} [physical] - false: GLTFLoader makes no MeshPhysicalMaterial of it.
 * @property {string} [three] - Define of three.js that has it.
 * @property {string[]} [shadings] - Families of shadings that read it, where not all do.
 * @property {Row[]} rows
 * @property {Derived[]} [derived]
 * @property {NormalTexture} [normal]
 * @property {Texel} [texel] - A texture that multiplies nothing.
 *
 * @typedef {object} Derived - What shaders take in another form than glTF has it: a uniform of this name.
 * @property {string} name
 * @property {'float' | 'vec2' | 'vec3'} type
 * @property {string} [cpp] - Over `l`.
 * @property {number[]} [constant] - In place of a uniform: what a texel changes later.
 * @property {string} [three] - Expression in three.js's shaders.
 * @property {string} [input] - As in Row.
 * @property {string} [times] - Texel that it is multiplied by.
 * @property {Texture} [range] - Texel that chooses between x and y; without a texture y.
 *
 * @typedef {object} NormalTexture - A normal map of the layer's own.
 * @property {string} key
 * @property {string} scale - Field of its scale.
 * @property {string} three
 *
 * @typedef {Texture & {type: string, neutral: number[], input?: null, within?: string, unit: string}} Texel - `neutral`: what
 *   it reads where there is none.
 */

/** The specifications give no upper bounds for these; beyond them the terms of shading leave fp32, and nothing looks different. */
const IOR_MAX = 1000;
const SPECULAR_COLOR_MAX = 65504;
const THICKNESS_MAX = 1e6; // nanometres
const VOLUME_MAX = 1e12; // metres, and as small a part of one
const BUMP_MAX = 1e4;
const DISPERSION_MAX = 40; // beyond it red light would travel faster than in empty space
const THREADS_MAX = 1e6; // per unit of u or v: finer than any texture

const texture = (key, channels, more) => ({ key, channels, ...more });
const colour = (key) => texture(key, 'rgb', { srgb: true });

const FABRIC = 'TELAR_materials_fabric';

/** "sheenColor" as SHEEN_COLOR */
export const upper = (name) => name.replaceAll(/(?<=[a-z0-9])[A-Z]/g, '_$&').toUpperCase();

/** "sheenColor" as SheenColor */
export const capital = (name) => name[0].toUpperCase() + name.slice(1);

/** Name of a texture in the shaders. */
export const textureName = ({ key, name }) => name ?? key.replace(/Texture$/, '');

/** Name in MaterialInputs; null where it is not there. */
export const inputName = ({ input, key, name }) => (input === undefined ? (name ?? key.replace(/Factor$/, '')) : input);

/** @returns {Texture[]} Of a layer, in the order in which they are bound. */
export const texturesOf = ({ rows, derived = [], texel, normal }) =>
  [
    ...rows.map((row) => row.texture && { three: row.three, ...row.texture }),
    ...derived.map(({ range }) => range),
    texel,
    normal && { channels: 'rgb', isNormal: true, ...normal },
  ].filter(Boolean);

/** One set of yarns. */
const yarn = (within) => [
  { key: 'coverage', default: 0.5, within, unit: 'share of the surface that shows it, seen from far' },
  { key: 'roughnessFactor', default: 0.5, within, unit: 'perceptual, along the yarn: how straight its fibres lie' },
  { key: 'anisotropyStrength', within, unit: 'how much rougher across it: alpha = mix(roughness^2, 1, anisotropy^2)' },
  { key: 'specularColorFactor', type: 'vec3', default: 1, within, unit: 'on its normal reflectance' },
];

/** Which metals the shading "fabric" gives two highlights, one of flat facets of the normal map and one of the edges between them: by factors, not by texels. */
export const POLISHED = { roughnessMax: 0.3, metalnessMin: 0.5 };

/** Textures of metallic-roughness: their factors are the material's own fields. @type {Texture[]} */
export const CORE_TEXTURES = [
  { ...colour('baseColorTexture'), channels: 'rgba', three: '' },
  texture('metallicRoughnessTexture', 'gb', { three: 'roughness' }),
  texture('normalTexture', 'rgb', { three: 'normal' }),
  texture('occlusionTexture', 'r', { three: 'ao' }),
  { ...colour('emissiveTexture'), three: 'emissive' },
];

/** In the order in which features are told and textures are bound. @type {Layer[]} */
export const LAYERS = [
  {
    name: 'specular',
    extension: 'KHR_materials_specular',
    member: 'layers',
    three: 'USE_SPECULAR',
    keepsTextures: true,
    when: 'l.ior != 1.5f || l.specularFactor != 1 || l.specularColorFactor != glm::vec3(1) || l.specularTexture || l.specularColorTexture',
    rows: [
      { key: 'ior', kind: 'ior', default: 1.5, min: 1, max: IOR_MAX, extension: 'KHR_materials_ior', declaredIf: 'SPECULAR || TRANSMISSION', three: 'ior' },
      { key: 'specularFactor', default: 1, texture: texture('specularTexture', 'a'), three: 'specularIntensity' },
      { key: 'specularColorFactor', type: 'vec3', default: 1, max: SPECULAR_COLOR_MAX, texture: colour('specularColorTexture'), three: 'specularColor' },
    ],
  },
  {
    name: 'bump',
    extension: 'EXT_materials_bump',
    member: 'layers',
    three: 'USE_BUMPMAP',
    keepsTextures: true,
    when: 'l.bumpFactor != 0 && l.bumpTexture && !m.normalTexture',
    rows: [
      {
        key: 'bumpFactor',
        default: 1,
        min: -BUMP_MAX,
        max: BUMP_MAX,
        unit: 'of heights against the width of a pixel',
        // As the renderer of three.js has it.
        cpp: 'key.flipSided ? -l.bumpFactor : l.bumpFactor',
        three: 'bumpScale',
      },
    ],
    texel: { ...texture('bumpTexture', 'r', { three: 'bump', unit: 'R height' }), asked: true, input: null },
  },
  {
    name: 'clearcoat',
    extension: 'KHR_materials_clearcoat',
    member: 'layers',
    three: 'USE_CLEARCOAT',
    when: 'l.clearcoatFactor > 0',
    rows: [
      { key: 'clearcoatFactor', texture: texture('clearcoatTexture', 'r'), three: 'clearcoat' },
      { key: 'clearcoatRoughnessFactor', unit: 'perceptual', texture: texture('clearcoatRoughnessTexture', 'g'), three: 'clearcoatRoughness' },
    ],
    normal: { key: 'clearcoatNormalTexture', scale: 'clearcoatNormalScale', three: 'clearcoatNormal' },
  },
  {
    name: 'sheen',
    extension: 'KHR_materials_sheen',
    member: 'layers',
    three: 'USE_SHEEN',
    keepsTextures: true,
    when: 'l.sheenColorFactor != glm::vec3(0)',
    rows: [
      { key: 'sheenColorFactor', type: 'vec3', texture: colour('sheenColorTexture'), three: 'sheenColor' },
      { key: 'sheenRoughnessFactor', unit: 'perceptual', texture: texture('sheenRoughnessTexture', 'a'), three: 'sheenRoughness' },
    ],
  },
  {
    name: 'anisotropy',
    extension: 'KHR_materials_anisotropy',
    member: 'layers',
    three: 'USE_ANISOTROPY',
    when: 'l.anisotropyStrength > 0',
    rows: [
      { key: 'anisotropyStrength', input: null },
      { key: 'anisotropyRotation', kind: 'angle', unit: 'radians, counter-clockwise from the tangent', input: null },
    ],
    derived: [
      {
        name: 'anisotropyVector',
        type: 'vec2',
        unit: 'strength (cos rotation, sin rotation)',
        three: 'anisotropyVector',
        cpp: 'polar(l.anisotropyStrength, l.anisotropyRotation)',
      },
    ],
    texel: { ...texture('anisotropyTexture', 'rgb'), unit: 'RG direction, B strength', type: 'vec3', neutral: [0.5, 0.5, 1], three: 'anisotropy' },
  },
  {
    name: 'iridescence',
    extension: 'KHR_materials_iridescence',
    member: 'layers',
    three: 'USE_IRIDESCENCE',
    when: 'l.iridescenceFactor > 0',
    rows: [
      { key: 'iridescenceFactor', texture: texture('iridescenceTexture', 'r'), three: 'iridescence' },
      { key: 'iridescenceIor', default: 1.3, min: 1, max: IOR_MAX, three: 'iridescenceIOR' },
      { key: 'iridescenceThicknessMinimum', default: 100, max: THICKNESS_MAX, unit: 'nanometres', input: null },
      { key: 'iridescenceThicknessMaximum', default: 400, max: THICKNESS_MAX, unit: 'nanometres', input: null },
    ],
    derived: [
      {
        name: 'iridescenceThickness',
        type: 'vec2',
        unit: 'least, most, nanometres',
        range: texture('iridescenceThicknessTexture', 'g', { three: 'iridescenceThickness' }),
        cpp: 'glm::vec2(l.iridescenceThicknessMinimum, l.iridescenceThicknessMaximum)',
        three: 'vec2(iridescenceThicknessMinimum, iridescenceThicknessMaximum)',
      },
    ],
  },
  {
    name: 'diffuseRoughness',
    extension: 'KHR_materials_diffuse_roughness',
    member: 'layers',
    three: 'USE_DIFFUSE_ROUGHNESS',
    when: 'l.diffuseRoughnessFactor > 0',
    rows: [{ key: 'diffuseRoughnessFactor', texture: texture('diffuseRoughnessTexture', 'r'), three: 'diffuseRoughness' }],
  },
  {
    name: 'transmission',
    extension: 'KHR_materials_transmission',
    member: 'layers',
    when: 'l.transmissionFactor > 0',
    rows: [{ key: 'transmissionFactor', texture: texture('transmissionTexture', 'r'), input: null }],
  },
  {
    name: 'volume',
    extension: 'KHR_materials_volume',
    member: 'layers',
    when: 'l.transmissionFactor > 0 && l.thicknessFactor > 0',
    rows: [{ key: 'thicknessFactor', max: VOLUME_MAX, unit: 'mesh units', texture: texture('thicknessTexture', 'g'), input: null }],
  },
  {
    name: 'attenuation',
    extension: 'KHR_materials_volume',
    member: 'layers',
    when: 'l.transmissionFactor > 0 && l.thicknessFactor > 0 && std::isfinite(l.attenuationDistance) && l.attenuationColor != glm::vec3(1)',
    rows: [
      { key: 'attenuationDistance', kind: 'distance', min: 1 / VOLUME_MAX, max: VOLUME_MAX, unit: 'metres', input: null },
      { key: 'attenuationColor', type: 'vec3', default: 1, unit: 'of white light after attenuationDistance', input: null },
    ],
  },
  {
    name: 'dispersion',
    extension: 'KHR_materials_dispersion',
    member: 'layers',
    when: 'l.transmissionFactor > 0 && l.dispersion > 0 && l.ior != 1',
    rows: [{ key: 'dispersion', max: DISPERSION_MAX, unit: '20 / Abbe number', input: null }],
  },
  {
    name: 'diffuseTransmission',
    extension: 'KHR_materials_diffuse_transmission',
    member: 'fabric',
    shadings: ['fabric', 'principled'],
    physical: false,
    when: 'l.diffuseTransmissionFactor > 0',
    rows: [
      { key: 'diffuseTransmissionFactor', texture: texture('diffuseTransmissionTexture', 'a') },
      { key: 'diffuseTransmissionColorFactor', type: 'vec3', default: 1, texture: colour('diffuseTransmissionColorTexture') },
    ],
  },
  {
    name: 'flatness',
    extension: FABRIC,
    member: 'fabric',
    shadings: ['fabric', 'principled'],
    physical: false,
    when: 'l.flatness > 0',
    rows: [
      { key: 'preset', type: 'name' },
      { key: 'flatness', unit: "from Lambert's diffuse to that of a thin scattering sheet" },
    ],
  },
  {
    name: 'weave',
    extension: FABRIC,
    member: 'fabric',
    shadings: ['fabric'],
    physical: false,
    when: 'l.weave',
    rows: [{ key: 'threadsPerUv', type: 'vec2', max: THREADS_MAX, within: 'weave' }, ...yarn('weave/warp'), ...yarn('weave/weft')],
    derived: [
      { name: 'yarnCoverage', type: 'vec2', unit: 'warp, weft', cpp: 'glm::vec2(l.warp.coverage, l.weft.coverage)' },
      {
        name: 'yarnRoughness',
        type: 'vec2',
        unit: 'perceptual, along the yarn',
        cpp: 'glm::vec2(l.warp.roughnessFactor, l.weft.roughnessFactor)',
        times: 'metallicRoughness.g',
      },
      {
        name: 'yarnAnisotropy',
        type: 'vec2',
        unit: 'across it: alpha = mix(roughness^2, 1, anisotropy^2)',
        cpp: 'glm::vec2(l.warp.anisotropyStrength, l.weft.anisotropyStrength)',
      },
      { name: 'warpSpecularColor', type: 'vec3', cpp: 'l.warp.specularColorFactor' },
      { name: 'weftSpecularColor', type: 'vec3', cpp: 'l.weft.specularColorFactor' },
      { name: 'threadsPerUv', type: 'vec2', unit: 'yarns in one unit of vWeaveUv: warp, weft; 0 = not known', cpp: 'l.threadsPerUv', input: null },
      { name: 'yarnTurn', type: 'vec2', unit: 'cosine, sine of the angle by which yarns are turned out of their axes', constant: [1, 0] },
      { name: 'yarnSlope', type: 'float', unit: 'sine of that by which they rise', constant: [0] },
    ],
    texel: { ...texture('weaveTexture', 'rgba'), within: 'weave', unit: 'RG turn of the yarn, B its slope, A 0 weft .. 1 warp', input: null },
  },
  {
    name: 'back',
    extension: FABRIC,
    member: 'fabric',
    shadings: ['fabric'],
    physical: false,
    when: 'l.back',
    label: 'back-side',
    rows: [
      { key: 'baseColorFactor', type: 'vec3', default: 1, within: 'back' },
      { key: 'roughnessFactor', within: 'back' },
    ],
    derived: [
      { name: 'backColorFactor', type: 'vec3', cpp: 'l.backColorFactor', input: null },
      { name: 'backRoughness', type: 'float', unit: 'perceptual', cpp: 'l.backRoughnessFactor', input: null },
    ],
    texel: { ...colour('baseColorTexture'), name: 'backColor', within: 'back', input: null },
  },
];
