import { CORE_TEXTURES, inputName, LAYERS, POLISHED, texturesOf, textureName, upper } from '../../material/table.mjs';

/** The C++ part of js/material/table.mjs: files that renderer/ includes, written when CMake configures. */

const HEADER = '// Written from js/material/table.mjs.\n';

const textOf = (lines) => `${HEADER}${lines.join('\n')}\n`;

const TYPES = { float: 'float', vec2: 'glm::vec2', vec3: 'glm::vec3' };

/** Numbers of a list of a type; 1 for one that is no list. */
const WIDTHS = { vec2: 2, vec3: 3 };

const real = (number) => `${Number.isInteger(number) ? `${number}.0` : number}f`;

/** Rows that stand in the extension itself: they have fields and readers. */
const plainRows = ({ rows }) => rows.filter(({ within, type }) => !within && type !== 'name');

const plainTextures = (layer) => texturesOf(layer).filter(({ within }) => !within);

const ofMember = (member) => LAYERS.filter((layer) => layer.member === member);

const fieldOf = ({ key, type = 'float', kind, default: value = 0, unit }) => {
  const first = kind === 'distance' ? 'std::numeric_limits<float>::infinity()' : real(value);
  return `  ${TYPES[type]} ${key}{${first}};${unit ? `  ///< ${unit}` : ''}`;
};

/** Fields of PhysicalLayers or FabricLayers. */
const fields = (member) =>
  textOf(
    ofMember(member).flatMap((layer) => {
      const lines = [
        ...plainRows(layer).map(fieldOf),
        ...plainTextures(layer).map(
          (texture) => `  TextureRef ${texture.key};  ///< ${texture.srgb ? 'sRGB' : `linear: ${texture.unit ?? texture.channels.toUpperCase()}`}`,
        ),
        ...(layer.normal ? [`  float ${layer.normal.scale}{1.0f};`] : []),
      ];
      return lines.length > 0 ? [`  // ${layer.extension}`, ...lines] : [];
    }),
  );

/** Rows of a layer, and the properties that hold textures. */
const properties = (layer) =>
  [...layer.rows, ...texturesOf(layer).map(({ key, within }) => ({ key, within, type: 'texture' }))].map((row) => ({ extension: layer.extension, ...row }));

/** extension: what stands in it, objects within objects. */
function schemaTree() {
  const tree = {};
  for (const row of LAYERS.flatMap(properties)) {
    const path = [row.extension, ...(row.within?.split('/') ?? [])];
    const holder = path.reduce((object, key) => (object[key] ??= {}), tree);
    holder[row.key] = row.type ?? 'float';
  }
  return tree;
}

const schemaField = (key, value, name) =>
  ({
    float: `number("${key}")`,
    texture: `object("${key}", INFO_RULE)`,
    name: `{.key = "${key}", .kind = Kind::kName}`,
  })[value] ?? (typeof value === 'string' ? `items("${key}", ${WIDTHS[value]})` : `object("${key}", ${name}_RULE)`);

/** What the loader takes of the extensions: asset/document/schema_tables.cpp. */
function schemaRules() {
  const lines = [];
  const visit = (name, object) => {
    for (const [key, value] of Object.entries(object)) if (typeof value === 'object') visit(`${name}_${upper(key)}`, value);
    const list = Object.entries(object).map(([key, value]) => schemaField(key, value, `${name}_${upper(key)}`));
    lines.push(`constexpr Field ${name}[] = {${list.join(', ')}};`, `constexpr ObjectRule ${name}_RULE{${name}};`);
  };
  for (const [extension, object] of Object.entries(schemaTree())) visit(upper(extension), object);
  return textOf(lines);
}

const extensions = (layers) => [...new Set(layers.flatMap(properties).map(({ extension }) => extension))];

/** Statement that reads one row from `in`. */
function reading({ key, type = 'float', kind, default: value = 0, min = 0, max = 1 }) {
  if (kind === 'angle') return `out.${key} = in.angle("${key}");`;
  if (kind === 'ior') return `out.${key} = in.ior("${key}", ${value}, ${min}, ${max});`;
  if (kind === 'distance') return `out.${key} = in.distance("${key}", ${min}, ${max});`;
  if (type === 'vec2') return `out.${key} = glm::vec2(in.color("${key}", ${value}, ${max}));`;
  return type === 'float' ? `out.${key} = in.factor("${key}", ${value}, ${min}, ${max});` : `out.${key} = in.color("${key}", ${value}, ${max});`;
}

/** How the extensions are read, in a function with `layer(name)` and `out`. */
const readers = (member) =>
  textOf([
    'const auto& l = out;',
    ...extensions(ofMember(member)).flatMap((extension) => {
      const layers = ofMember(member)
        .map((layer) => ({
          ...layer,
          rows: plainRows(layer).filter((row) => (row.extension ?? layer.extension) === extension),
          textures: layer.extension === extension ? plainTextures(layer) : [],
        }))
        .filter(({ rows, textures }) => rows.length + textures.length > 0);
      return [
        `if (const Layer in = layer("${extension}")) {`,
        ...layers.flatMap(({ rows, textures, normal, keepsTextures, when, extension: own }) => {
          const read = textures.map(({ key }) => `out.${key} = in.texture("${key}");`);
          return [
            ...rows.map((row) => `  ${reading(row)}`),
            ...(normal && own === extension ? [`  out.${normal.scale} = in.scale("${normal.key}");`] : []),
            ...(keepsTextures || read.length === 0 ? read.map((line) => `  ${line}`) : [`  if (${when}) {`, ...read.map((line) => `    ${line}`), '  }']),
          ];
        }),
        '}',
      ];
    }),
  ]);

const rowsWithin = (object) => LAYERS.flatMap(({ rows }) => rows.filter(({ within }) => within === object));

/** How an object in an extension is read: `in` to `out`. */
const readersWithin = (object) => textOf(rowsWithin(object).map(reading));

/** Lines within quotes, for a list of names. */
const names = (list) => textOf(list.map((name) => `"${name}",`));

/** X-macro of the features of programs: define, member, name in info.features. */
function features() {
  const rows = LAYERS.flatMap((layer) => [
    [upper(layer.name), layer.name, layer.label ?? kebab(layer.name)],
    ...texturesOf(layer).flatMap((texture) => {
      const name = textureName(texture);
      return [
        [`${upper(name)}_MAP`, `${name}Map`, `${kebab(name)}-map`],
        [`${upper(name)}_UV1`, `${name}Uv1`, ''],
      ];
    }),
  ]);
  return textOf(['#define TELAR_LAYER_FEATURES(F) \\', rows.map(([define, member, name]) => `  F(${define}, ${member}, "${name}")`).join(' \\\n')]);
}

const kebab = (name) => upper(name).toLowerCase().replaceAll('_', '-');

/** X-macros of the textures: field of Material, name in shaders, whether it is sRGB, feature that it belongs to. */
function textures() {
  const row = (field, texture, feature) => `  T(${field}, ${textureName(texture)}, ${Boolean(texture.srgb)}, ${feature})`;
  const core = CORE_TEXTURES.map((texture) => row(texture.key, texture, 'none'));
  const layers = LAYERS.flatMap((layer) => texturesOf(layer).map((texture) => row(`${layer.member}.${textureName(texture)}Texture`, texture, layer.name)));
  return textOf([
    '#define TELAR_CORE_TEXTURES(T) \\',
    core.join(' \\\n'),
    '#define TELAR_LAYER_TEXTURES(T) \\',
    layers.join(' \\\n'),
    '#define TELAR_MATERIAL_TEXTURES(T) TELAR_CORE_TEXTURES(T) TELAR_LAYER_TEXTURES(T)',
  ]);
}

/** Which layers of a material show: over `m`, its `l` and `key`. */
const conditions = (member) => textOf(ofMember(member).map(({ name, when }) => `key.${name} = ${when};`));

/** What programs take of the layers that they have: over `program`, `key`, `l`. */
const uniforms = (member) =>
  textOf(
    ofMember(member).flatMap((layer) => {
      const rows = plainRows(layer).filter((row) => inputName(row) || !layer.derived);
      const lines = [
        ...rows.map(({ key, cpp = `l.${key}` }) => `  program.set("${key}", ${cpp});`),
        ...(layer.derived ?? []).filter(({ cpp }) => cpp).map(({ name, cpp }) => `  program.set("${name}", ${cpp});`),
        ...(layer.normal ? [`  program.set("${layer.normal.scale}", normalScaleOf(l.${layer.normal.scale}, item));`] : []),
      ];
      const declaring = [upper(layer.name), ...rows.flatMap(({ declaredIf }) => declaredIf?.split(' || ') ?? [])];
      const condition = [...new Set(declaring)].map((feature) => `key.${LAYERS.find(({ name }) => upper(name) === feature).name}`).join(' || ');
      return [`if (${condition}) {`, ...lines, '}'];
    }),
  );

const swizzled = (texture, value) => (texture.channels === 'rgb' ? `Vec3(${value})` : `${value}.${texture.channels}`);

/** materialInputs() of brdf/material_inputs.h. */
const inputs = () =>
  textOf(
    LAYERS.flatMap(({ member, rows, derived = [], texel }) => {
      const list = [
        ...rows
          .filter((row) => !row.within && row.type !== 'name' && inputName(row))
          .map((row) => {
            const factor = row.type === 'vec3' ? `Vec3(l.${row.key})` : `Real(l.${row.key})`;
            const { texture } = row;
            return `m.${inputName(row)} = ${factor}${texture ? ` * ${swizzled(texture, `texel(l.${texture.key}, ${Boolean(texture.srgb)})`)}` : ''};`;
          }),
        ...derived.filter(inputName).map((value) => {
          const name = `m.${inputName(value)}`;
          if (value.constant) return `${name} = ${value.type === 'float' ? 'Real' : value.type.replace('vec', 'Vec')}(${value.constant.join(', ')});`;
          if (value.range) return `${name} = within(${value.cpp}, l.${value.range.key}, &Vec4::${value.range.channels});`;
          return `${name} = ${value.type.replace('vec', 'Vec')}(${value.cpp})${value.times ? ` * ${value.times}` : ''};`;
        }),
        ...(texel && texel.input !== null
          ? [
              `m.${textureName(texel)}Texel = l.${texel.key} ? Vec3(texel(l.${texel.key}, ${Boolean(texel.srgb)})) : Vec3(${texel.neutral.map((x) => `Real(${x})`).join(', ')});`,
            ]
          : []),
      ];
      return list.length > 0 ? ['{', `  const auto& l = material.${member};`, ...list.map((line) => `  ${line}`), '}'] : [];
    }),
  );

/** Numbers of an object, as constants. */
const constants = (prefix, numbers) => textOf(Object.entries(numbers).map(([key, value]) => `constexpr float ${prefix}_${upper(key)} = ${real(value)};`));

/** @returns {Record<string, string>} Path: text. */
export const cppFiles = () => ({
  'telar/physical_layers.inc': fields('layers'),
  'telar/fabric_layers.inc': fields('fabric'),
  'telar/yarn.inc': textOf(rowsWithin('weave/warp').map(fieldOf)),
  'telar/material_textures.inc': textures(),
  'asset/layer_rules.inc': schemaRules(),
  'asset/layer_fields.inc': textOf(extensions(LAYERS).map((extension) => `object("${extension}", ${upper(extension)}_RULE),`)),
  'asset/physical_readers.inc': readers('layers'),
  'asset/fabric_readers.inc': readers('fabric'),
  'asset/yarn_readers.inc': readersWithin('weave/warp'),
  'asset/weave_readers.inc': readersWithin('weave'),
  'asset/layer_extensions.inc': names(extensions(LAYERS)),
  'asset/physical_extensions.inc': names(extensions(LAYERS.filter(({ physical = true }) => physical))),
  'shader/layer_features.inc': features(),
  'pass/physical_conditions.inc': conditions('layers'),
  'pass/physical_uniforms.inc': uniforms('layers'),
  'pass/fabric_uniforms.inc': uniforms('fabric'),
  'pass/polished.inc': constants('POLISHED', POLISHED),
  'brdf/layer_inputs.inc': inputs(),
  'brdf/layers_on.inc': textOf(LAYERS.map(({ name }) => `#define ${upper(name)} 1`)),
  'brdf/layers_off.inc': textOf(LAYERS.map(({ name }) => `#undef ${upper(name)}`)),
});
