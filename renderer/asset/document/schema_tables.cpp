// What telar reads of a glTF document. src: glTF 2.0 specification, section 5 "Properties Reference", and the
// specifications of the extensions named here.
#include "asset/document/schema.h"

namespace telar::asset {
namespace {

constexpr std::string_view LIGHTS = "/extensions/KHR_lights_punctual/lights";
constexpr std::string_view VARIANTS = "/extensions/KHR_materials_variants/variants";

constexpr Field items(std::string_view key, std::uint64_t count) {
  return {.key = key, .kind = Kind::kNumbers, .min = count, .max = count};
}
constexpr Field number(std::string_view key) { return {.key = key, .kind = Kind::kNumber}; }
constexpr Field name() { return {.key = "name", .kind = Kind::kName}; }
constexpr Field index(std::string_view key, std::string_view target, bool required = false) {
  return {.key = key, .kind = Kind::kIndex, .required = required, .target = target};
}
constexpr Field object(std::string_view key, const ObjectRule& rule, bool required = false) {
  return {.key = key, .kind = Kind::kObject, .required = required, .object = &rule};
}
constexpr Field size(std::string_view key, std::string_view code, bool required = false, std::uint64_t min = 0,
                     std::uint64_t max = INTEGER_MAX) {
  return {.key = key, .kind = Kind::kSize, .required = required, .min = min, .max = max, .rangeCode = code};
}
/// An integer whose wrong values only cost a warning later on.
constexpr Field lenient(std::string_view key) {
  return {.key = key, .kind = Kind::kSize, .max = INT_32_MAX, .rangeCode = ""};
}
constexpr Field objects(std::string_view key, const ObjectRule& rule, std::uint64_t Limits::*limit = nullptr,
                        std::string_view limitName = {}) {
  return {.key = key, .kind = Kind::kObjects, .object = &rule, .limit = limit, .limitName = limitName};
}

constexpr Field ASSET[] = {{.key = "version", .kind = Kind::kText, .required = true},
                           {.key = "minVersion", .kind = Kind::kText},
                           {.key = "generator", .kind = Kind::kName},
                           {.key = "copyright", .kind = Kind::kName}};
constexpr ObjectRule ASSET_RULE{ASSET};

constexpr Field FALLBACK[] = {{.key = "fallback", .kind = Kind::kBool}};
constexpr ObjectRule FALLBACK_RULE{FALLBACK};
constexpr Field BUFFER_EXTENSIONS[] = {object("EXT_meshopt_compression", FALLBACK_RULE),
                                       object("KHR_meshopt_compression", FALLBACK_RULE)};
constexpr ObjectRule BUFFER_EXTENSIONS_RULE{BUFFER_EXTENSIONS};
constexpr Field BUFFER[] = {{.key = "uri", .kind = Kind::kText},
                            size("byteLength", "E_BUFFER", true, 1),
                            object("extensions", BUFFER_EXTENSIONS_RULE)};
constexpr ObjectRule BUFFER_RULE{BUFFER};

// tinygltf keeps integers of extensions as int, hence the 32-bit bounds: 2^32 + 4 would be read as 4.
constexpr Field MESHOPT[] = {index("buffer", "buffers", true),
                             size("byteOffset", "E_MESHOPT", false, 0, INT_32_MAX),
                             size("byteLength", "E_MESHOPT", true, 1, INT_32_MAX),
                             size("byteStride", "E_MESHOPT", true, 1, 256),
                             size("count", "E_MESHOPT", true, 1, INT_32_MAX),
                             {.key = "mode", .kind = Kind::kName, .required = true},
                             {.key = "filter", .kind = Kind::kName}};
constexpr ObjectRule MESHOPT_RULE{MESHOPT};
constexpr Field VIEW_EXTENSIONS[] = {object("EXT_meshopt_compression", MESHOPT_RULE),
                                     object("KHR_meshopt_compression", MESHOPT_RULE)};
constexpr ObjectRule VIEW_EXTENSIONS_RULE{VIEW_EXTENSIONS};

constexpr Field BUFFER_VIEW[] = {index("buffer", "buffers", true),
                                 size("byteOffset", "E_BUFFERVIEW"),
                                 size("byteLength", "E_BUFFERVIEW", true, 1),
                                 {.key = "byteStride",
                                  .kind = Kind::kSize,
                                  .min = 4,
                                  .max = 252,
                                  .step = 4,
                                  .rangeCode = "E_STRIDE",
                                  .negativeCode = "E_STRIDE"},
                                 object("extensions", VIEW_EXTENSIONS_RULE)};
constexpr ObjectRule BUFFER_VIEW_RULE{BUFFER_VIEW};

// tinygltf keeps these as int, hence the 32-bit bounds.
constexpr Field SPARSE_INDICES[] = {index("bufferView", "bufferViews", true),
                                    size("byteOffset", "E_SPARSE", false, 0, INT_32_MAX),
                                    size("componentType", "E_SPARSE", true, 5121, 5125)};
constexpr ObjectRule SPARSE_INDICES_RULE{SPARSE_INDICES};
constexpr Field SPARSE_VALUES[] = {index("bufferView", "bufferViews", true),
                                   size("byteOffset", "E_SPARSE", false, 0, INT_32_MAX)};
constexpr ObjectRule SPARSE_VALUES_RULE{SPARSE_VALUES};
constexpr Field SPARSE[] = {size("count", "E_SPARSE", true, 1, INT_32_MAX),
                            object("indices", SPARSE_INDICES_RULE, true), object("values", SPARSE_VALUES_RULE, true)};
constexpr ObjectRule SPARSE_RULE{SPARSE};

constexpr Field ACCESSOR[] = {index("bufferView", "bufferViews"),
                              size("byteOffset", "E_ACCESSOR"),
                              size("componentType", "E_ACCESSOR", true, 5120, 5126),
                              {.key = "normalized", .kind = Kind::kBool},
                              size("count", "E_ACCESSOR", true, 1),
                              {.key = "type", .kind = Kind::kName, .required = true},
                              {.key = "min", .kind = Kind::kNumbers},
                              {.key = "max", .kind = Kind::kNumbers},
                              object("sparse", SPARSE_RULE)};
constexpr ObjectRule ACCESSOR_RULE{ACCESSOR};

constexpr Field DRACO[] = {
    index("bufferView", "bufferViews", true),
    {.key = "attributes", .kind = Kind::kSizes, .required = true, .max = INT_32_MAX, .rangeCode = "E_DRACO"}};
constexpr ObjectRule DRACO_RULE{DRACO};
constexpr Field MAPPING[] = {index("material", "materials", true),
                             {.key = "variants", .kind = Kind::kIndices, .required = true, .target = VARIANTS}};
constexpr ObjectRule MAPPING_RULE{MAPPING};
constexpr Field MAPPINGS[] = {objects("mappings", MAPPING_RULE)};
constexpr ObjectRule MAPPINGS_RULE{MAPPINGS};
constexpr Field PRIMITIVE_EXTENSIONS[] = {object("KHR_draco_mesh_compression", DRACO_RULE),
                                          object("KHR_materials_variants", MAPPINGS_RULE)};
constexpr ObjectRule PRIMITIVE_EXTENSIONS_RULE{PRIMITIVE_EXTENSIONS};

constexpr Field PRIMITIVE[] = {{.key = "attributes", .kind = Kind::kIndexMap, .required = true, .target = "accessors"},
                               index("indices", "accessors"),
                               index("material", "materials"),
                               size("mode", "E_SCHEMA", false, 0, 6),
                               {.key = "targets",
                                .kind = Kind::kIndexMaps,
                                .target = "accessors",
                                .limit = &Limits::morphTargets,
                                .limitName = "L_MORPH_TARGETS"},
                               object("extensions", PRIMITIVE_EXTENSIONS_RULE)};
constexpr ObjectRule PRIMITIVE_RULE{PRIMITIVE};

constexpr Field MESH[] = {
    name(),
    {.key = "primitives", .kind = Kind::kObjects, .required = true, .object = &PRIMITIVE_RULE, .min = 1},
    {.key = "weights", .kind = Kind::kNumbers}};
constexpr ObjectRule MESH_RULE{MESH};

constexpr Field NODE_LIGHT[] = {index("light", LIGHTS, true)};
constexpr ObjectRule NODE_LIGHT_RULE{NODE_LIGHT};
constexpr Field INSTANCING[] = {
    {.key = "attributes", .kind = Kind::kIndexMap, .required = true, .target = "accessors"}};
constexpr ObjectRule INSTANCING_RULE{INSTANCING};
constexpr Field NODE_EXTENSIONS[] = {object("KHR_lights_punctual", NODE_LIGHT_RULE),
                                     object("EXT_mesh_gpu_instancing", INSTANCING_RULE)};
constexpr ObjectRule NODE_EXTENSIONS_RULE{NODE_EXTENSIONS};
constexpr Field NODE[] = {name(),
                          index("mesh", "meshes"),
                          index("skin", "skins"),
                          index("camera", "cameras"),
                          {.key = "children", .kind = Kind::kIndices, .target = "nodes"},
                          items("matrix", 16),
                          items("translation", 3),
                          items("rotation", 4),
                          items("scale", 3),
                          {.key = "weights", .kind = Kind::kNumbers},
                          object("extensions", NODE_EXTENSIONS_RULE)};
constexpr ObjectRule NODE_RULE{NODE};

constexpr Field TRANSFORM[] = {items("offset", 2), number("rotation"), items("scale", 2), lenient("texCoord")};
constexpr ObjectRule TRANSFORM_RULE{TRANSFORM};
constexpr Field INFO_EXTENSIONS[] = {object("KHR_texture_transform", TRANSFORM_RULE)};
constexpr ObjectRule INFO_EXTENSIONS_RULE{INFO_EXTENSIONS};
constexpr Field INFO[] = {index("index", "textures", true), lenient("texCoord"), number("scale"), number("strength"),
                          object("extensions", INFO_EXTENSIONS_RULE)};
constexpr ObjectRule INFO_RULE{INFO};  // scale: normal texture; strength: occlusion texture

constexpr Field PBR[] = {items("baseColorFactor", 4), object("baseColorTexture", INFO_RULE), number("metallicFactor"),
                         number("roughnessFactor"), object("metallicRoughnessTexture", INFO_RULE)};
constexpr ObjectRule PBR_RULE{PBR};
constexpr ObjectRule EMPTY_RULE{};
constexpr Field EMISSIVE[] = {number("emissiveStrength")};
constexpr ObjectRule EMISSIVE_RULE{EMISSIVE};
// One rule an extension, named as it is.
#include "asset/layer_rules.inc"
constexpr Field MATERIAL_EXTRAS[] = {object("TELAR_materials_fabric", TELAR_MATERIALS_FABRIC_RULE)};
constexpr ObjectRule MATERIAL_EXTRAS_RULE{MATERIAL_EXTRAS};
constexpr Field MATERIAL_EXTENSIONS[] = {
#include "asset/layer_fields.inc"
    object("KHR_materials_unlit", EMPTY_RULE), object("KHR_materials_emissive_strength", EMISSIVE_RULE)};
constexpr ObjectRule MATERIAL_EXTENSIONS_RULE{MATERIAL_EXTENSIONS};
constexpr Field MATERIAL[] = {name(),
                              object("pbrMetallicRoughness", PBR_RULE),
                              object("normalTexture", INFO_RULE),
                              object("occlusionTexture", INFO_RULE),
                              object("emissiveTexture", INFO_RULE),
                              items("emissiveFactor", 3),
                              {.key = "alphaMode", .kind = Kind::kName},
                              number("alphaCutoff"),
                              {.key = "doubleSided", .kind = Kind::kBool},
                              object("extensions", MATERIAL_EXTENSIONS_RULE),
                              {.key = "extras", .kind = Kind::kExtras, .object = &MATERIAL_EXTRAS_RULE}};
constexpr ObjectRule MATERIAL_RULE{MATERIAL};

constexpr Field IMAGE_SOURCE[] = {index("source", "images", true)};
constexpr ObjectRule IMAGE_SOURCE_RULE{IMAGE_SOURCE};
constexpr Field TEXTURE_EXTENSIONS[] = {object("KHR_texture_basisu", IMAGE_SOURCE_RULE),
                                        object("EXT_texture_webp", IMAGE_SOURCE_RULE)};
constexpr ObjectRule TEXTURE_EXTENSIONS_RULE{TEXTURE_EXTENSIONS};
constexpr Field TEXTURE[] = {index("sampler", "samplers"), index("source", "images"),
                             object("extensions", TEXTURE_EXTENSIONS_RULE)};
constexpr ObjectRule TEXTURE_RULE{TEXTURE};
constexpr Field IMAGE[] = {
    {.key = "uri", .kind = Kind::kText}, index("bufferView", "bufferViews"), {.key = "mimeType", .kind = Kind::kName}};
constexpr ObjectRule IMAGE_RULE{IMAGE};
constexpr Field SAMPLER[] = {lenient("magFilter"), lenient("minFilter"), lenient("wrapS"), lenient("wrapT")};
constexpr ObjectRule SAMPLER_RULE{SAMPLER};

constexpr Field SCENE[] = {name(), {.key = "nodes", .kind = Kind::kIndices, .target = "nodes"}};
constexpr ObjectRule SCENE_RULE{SCENE};
constexpr Field SKIN[] = {
    {.key = "joints", .kind = Kind::kIndices, .required = true, .target = "nodes", .min = 1, .rangeCode = "E_SKIN"},
    index("inverseBindMatrices", "accessors"),
    index("skeleton", "nodes")};
constexpr ObjectRule SKIN_RULE{SKIN};

constexpr Field TARGET[] = {index("node", "nodes"), {.key = "path", .kind = Kind::kName}};
constexpr ObjectRule TARGET_RULE{TARGET};
constexpr Field CHANNEL[] = {size("sampler", "E_SCHEMA", true, 0, INT_32_MAX), object("target", TARGET_RULE, true)};
constexpr ObjectRule CHANNEL_RULE{CHANNEL};
constexpr Field KEYFRAMES[] = {index("input", "accessors", true),
                               index("output", "accessors", true),
                               {.key = "interpolation", .kind = Kind::kName}};
constexpr ObjectRule KEYFRAMES_RULE{KEYFRAMES};
constexpr Field ANIMATION[] = {
    name(),
    {.key = "channels", .kind = Kind::kObjects, .required = true, .object = &CHANNEL_RULE},
    {.key = "samplers", .kind = Kind::kObjects, .required = true, .object = &KEYFRAMES_RULE}};
constexpr ObjectRule ANIMATION_RULE{ANIMATION};

constexpr Field VARIANT[] = {name()};
constexpr ObjectRule VARIANT_RULE{VARIANT};
constexpr Field VARIANT_LIST[] = {objects("variants", VARIANT_RULE)};
constexpr ObjectRule VARIANT_LIST_RULE{VARIANT_LIST};
constexpr Field ROOT_EXTENSIONS[] = {object("KHR_materials_variants", VARIANT_LIST_RULE)};
constexpr ObjectRule ROOT_EXTENSIONS_RULE{ROOT_EXTENSIONS};

constexpr Field DOCUMENT[] = {
    object("asset", ASSET_RULE, true),
    {.key = "extensionsUsed", .kind = Kind::kTexts},
    {.key = "extensionsRequired", .kind = Kind::kTexts},
    objects("buffers", BUFFER_RULE, &Limits::buffers, "L_BUFFERS"),
    objects("bufferViews", BUFFER_VIEW_RULE, &Limits::bufferViews, "L_BUFFER_VIEWS"),
    objects("accessors", ACCESSOR_RULE, &Limits::accessors, "L_ACCESSORS"),
    objects("nodes", NODE_RULE, &Limits::nodes, "L_NODES"),
    objects("materials", MATERIAL_RULE, &Limits::materials, "L_MATERIALS"),
    objects("textures", TEXTURE_RULE, &Limits::textures, "L_TEXTURES"),
    objects("images", IMAGE_RULE, &Limits::images, "L_IMAGES"),
    objects("samplers", SAMPLER_RULE, &Limits::textures, "L_TEXTURES"),
    objects("skins", SKIN_RULE, &Limits::nodes, "L_NODES"),
    objects("meshes", MESH_RULE),
    objects("animations", ANIMATION_RULE),
    objects("scenes", SCENE_RULE),
    index("scene", "scenes"),
    object("extensions", ROOT_EXTENSIONS_RULE),
};

}  // namespace

const ObjectRule DOCUMENT_RULE{DOCUMENT};

}  // namespace telar::asset
