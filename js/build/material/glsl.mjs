import { capital, CORE_TEXTURES, inputName, LAYERS, texturesOf, textureName, upper } from '../../material/table.mjs';

/** The shaders' part of js/material/table.mjs: files that shaders/ includes, written when CMake configures. */

const HEADER = '// Written from js/material/table.mjs.\n';

const section = (condition, lines) => (lines.length > 0 ? [`#if ${condition}`, ...lines, '#endif'] : []);

const commented = (line, unit) => (unit ? `${line}  // ${unit}` : line);

const textOf = (lines) => `${lines.join('\n')}\n`;

/** What reads a texture as the server's shaders name it. */
const OWN_NAMES = {
  factor: ({ key, name }) => name ?? key,
  texel: (texture) => `texture(${textureName(texture)}Map, v${capital(textureName(texture))}Uv)`,
  lookup: (texture) => ({ map: `${textureName(texture)}Map`, uv: `v${capital(textureName(texture))}Uv` }),
};

const textureComment = ({ srgb, channels, unit }) => (srgb ? 'sRGB' : `linear: ${unit ?? channels.toUpperCase()}`);

/** vec2(1.0, 0.0) */
const constantOf = ({ type, constant }) => `${type}(${constant.map((number) => number.toFixed(1)).join(', ')})`;

/** struct MaterialInputs: also compiled as C++. */
export function inputTypes() {
  const layers = LAYERS.flatMap(({ name, rows, derived = [], texel }) =>
    section(upper(name), [
      ...rows
        .filter((row) => !row.within && row.type !== 'name' && inputName(row))
        .map((row) => commented(`  ${row.type ?? 'float'} ${inputName(row)};`, row.unit)),
      ...derived.filter(inputName).map((value) => commented(`  ${value.range ? 'float' : value.type} ${inputName(value)};`, value.unit)),
      ...(texel && texel.input !== null ? [commented(`  ${texel.type} ${textureName(texel)}Texel;`, texel.unit)] : []),
    ]),
  );
  return textOf([
    `${HEADER}// What the file says of a material at one point: factors times texels, linear Rec.709, under the names of glTF.`,
    'struct MaterialInputs {',
    '#if ALL_TERMS',
    '  ThreeTerms three;  // of a release of three.js, chosen at run time: in C++ only',
    '#endif',
    '  vec3 baseColor;',
    '  float metallic;',
    '  float roughness;  // perceptual',
    ...layers,
    '};',
  ]);
}

/** Uniforms and varyings of the fragment stage. */
export function fragmentDeclarations(layers = LAYERS) {
  return layers.flatMap((layer) => {
    const { name, rows, derived = [], normal } = layer;
    const apart = rows.filter(({ declaredIf }) => declaredIf);
    const factors = rows.filter((row) => !row.within && row.type !== 'name' && !apart.includes(row) && (inputName(row) || !derived.length));
    return [
      ...apart.flatMap((row) => section(row.declaredIf, [commented(`uniform ${row.type ?? 'float'} ${row.key};`, row.unit)])),
      ...section(upper(name), [
        ...factors.map((row) => commented(`uniform ${row.type ?? 'float'} ${row.key};`, row.unit)),
        ...derived.filter(({ cpp }) => cpp).map((value) => commented(`uniform ${value.type} ${value.name};`, value.unit)),
      ]),
      ...texturesOf(layer).flatMap((texture) =>
        section(`${upper(textureName(texture))}_MAP`, [
          `uniform sampler2D ${textureName(texture)}Map;  // ${textureComment(texture)}`,
          `in vec2 v${capital(textureName(texture))}Uv;`,
          ...(texture === normal || texture.isNormal ? [`uniform vec2 ${normal.scale};`] : []),
        ]),
      ),
    ];
  });
}

/**
 * Adds to MaterialInputs what the layers have.
 * @param {typeof OWN_NAMES} names
 * @param {(layer: import('../../material/table.mjs').Layer) => boolean} isRead
 */
export function inputsFunction(names = OWN_NAMES, isRead = () => true) {
  const product = (row) => {
    const input = `m.${inputName(row)}`;
    const times = row.texture && section(`${upper(textureName(row.texture))}_MAP`, [`  ${input} *= ${names.texel(row.texture, row)}.${row.texture.channels};`]);
    return [`  ${input} = ${row.constant ? constantOf(row) : names.factor(row)}${row.times ? ` * ${row.times}` : ''};`, ...(times ?? [])];
  };
  const between = (value) => {
    const range = names.factor(value);
    return [
      `#if ${upper(textureName(value.range))}_MAP`,
      `  m.${inputName(value)} = between(${range}, ${names.texel(value.range, value.range)}.${value.range.channels});`,
      '#else',
      `  m.${inputName(value)} = ${range}.y;`,
      '#endif',
    ];
  };
  const lone = (texel) => [
    `#if ${upper(textureName(texel))}_MAP`,
    `  m.${textureName(texel)}Texel = ${names.texel(texel, texel)}.${texel.channels};`,
    '#else',
    `  m.${textureName(texel)}Texel = ${constantOf({ ...texel, constant: texel.neutral })};`,
    '#endif',
  ];
  const body = LAYERS.filter(isRead).flatMap(({ name, rows, derived = [], texel }) =>
    section(upper(name), [
      ...rows.filter((row) => !row.within && row.type !== 'name' && inputName(row)).flatMap(product),
      ...derived.filter(inputName).flatMap((value) => (value.range ? between(value) : product(value))),
      ...(texel && texel.input !== null ? lone(texel) : []),
    ]),
  );
  const ranged = LAYERS.filter(({ derived }) => derived?.some(({ range }) => range)).map(({ name }) => upper(name));
  const lookups = LAYERS.filter(isRead)
    .flatMap(texturesOf)
    .filter(({ asked }) => asked)
    .flatMap((texture) => {
      const { map, uv } = names.lookup(texture);
      return section(`${upper(textureName(texture))}_MAP`, [
        `vec2 ${textureName(texture)}Uv() { return ${uv}; }`,
        `vec4 ${textureName(texture)}Texel(vec2 uv) { return texture(${map}, uv); }`,
      ]);
    });
  return [
    ...lookups,
    ...section(ranged.join(' || '), ['float between(vec2 range, float t) { return (range.y - range.x) * t + range.x; }']),
    '',
    'MaterialInputs withLayerInputs(MaterialInputs m, vec4 metallicRoughness) {',
    ...body,
    '  return m;',
    '}',
  ];
}

/** Texture coordinates, as the vertex stage gives them. */
export const vertexDeclarations = (textures) =>
  textures.flatMap((texture) =>
    section(`${upper(textureName(texture))}_MAP`, [`uniform mat3 ${textureName(texture)}UvTransform;`, `out vec2 v${capital(textureName(texture))}Uv;`]),
  );

export const vertexMain = (textures) =>
  textures.flatMap((texture) =>
    section(`${upper(textureName(texture))}_MAP`, [
      `v${capital(textureName(texture))}Uv = vec2(${textureName(texture)}UvTransform * vec3(${upper(textureName(texture))}_UV1 == 1 ? uv1 : uv0, 1.0));`,
    ]),
  );

export const ALL_TEXTURES = [...CORE_TEXTURES, ...LAYERS.flatMap(texturesOf)];

const ownFragmentDeclarations = () => fragmentDeclarations().filter((line) => !line.startsWith('in '));

// Once for both stages: shaders/material/varyings.glsl.
const ownVertexDeclarations = () => vertexDeclarations(ALL_TEXTURES).map((line) => line.replace(/^out /, 'VARYING '));

/** @returns {Record<string, string>} Path below shaders/: text. */
export const shaderFiles = () => ({
  'material/input_types.glsl': inputTypes(),
  'material/layer_declarations.glsl': `${HEADER}// Factors are linear Rec.709; sRGB textures are decoded by the sampler.\n${textOf(ownFragmentDeclarations())}`,
  'material/layer_inputs.glsl': HEADER + textOf(inputsFunction()),
  'material/uv_varyings.glsl': HEADER + textOf(ownVertexDeclarations()),
  'material/uv_transforms.glsl': `${HEADER}// Inside main() of the vertex stage.\n${textOf(vertexMain(ALL_TEXTURES))}`,
});
