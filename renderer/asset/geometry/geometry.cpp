#include "asset/geometry/geometry.h"

#include "asset/accessor/draco_mesh.h"
#include "asset/check/pointer.h"
#include "asset/document/extension_value.h"
#include "asset/geometry/deformers.h"
#include "asset/geometry/repair.h"
#include "asset/geometry/topology.h"

namespace telar::asset {
namespace {

constexpr const char* DRACO_EXTENSION = "KHR_draco_mesh_compression";
constexpr const char* UV_NAMES[] = {"TEXCOORD_0", "TEXCOORD_1"};
constexpr const char* VISIBILITY_NAMES[] = {"_TELAR_VISIBILITY", "_TELAR_VISIBILITY_BACK"};

}  // namespace

int GeometryReader::attribute(const Source& source, const std::string& name) const {
  const auto found = source.attributes.find(name);
  return found == source.attributes.end() ? -1 : found->second;
}

void GeometryReader::checkAttribute(const Source& source, const std::string& name, unsigned least,
                                    unsigned most) const {
  const int accessor = attribute(source, name);
  if (accessor < 0) return;
  const std::string where = where_ + pointer("attributes", name);
  const unsigned components = from_.accessors.components(accessor);
  const auto& info = from_.accessors.info(accessor);
  if (components < least || components > most || info.type > TINYGLTF_TYPE_VEC4 ||
      info.componentType == COMPONENT_U32) {
    fail("E_ACCESSOR", "the accessor has a type that this attribute cannot have", where);
  }
  if (info.count != from_.accessors.count(attribute(source, "POSITION"))) {
    fail("E_ACCESSOR", "the accessor has " + std::to_string(info.count) + " elements, POSITION has another number",
         where);
  }
}

void GeometryReader::checkLayout(const Source& source) const {
  for (const char* name : {"POSITION", "NORMAL"}) checkAttribute(source, name, 3, 3);
  for (const char* name : UV_NAMES) checkAttribute(source, name, 2, 2);
  checkAttribute(source, "TANGENT", 4, 4);
  checkAttribute(source, "COLOR_0", 3, 4);
  for (const char* name : VISIBILITY_NAMES) checkAttribute(source, name, 4, 4);
  if (source.indices < 0) return;
  const auto& info = from_.accessors.info(source.indices);
  const std::string where = where_ + "/indices";
  const bool isUnsigned =
      info.componentType == COMPONENT_U8 || info.componentType == COMPONENT_U16 || info.componentType == COMPONENT_U32;
  if (from_.accessors.components(source.indices) != 1 || !isUnsigned) {
    fail("E_ACCESSOR", "indices must be a SCALAR accessor of unsigned integers", where);
  }
}

/// Before any of them is allocated: an accessor may have many elements and no bytes. Each is uploaded too.
void GeometryReader::chargeStreams(const Source& source) const {
  const std::uint64_t vertices = from_.accessors.count(attribute(source, "POSITION"));
  std::uint64_t floats = 0;
  for (const auto& [name, count] : {std::pair{"POSITION", 3}, {"NORMAL", 3}, {"TANGENT", 4}, {"COLOR_0", 4}}) {
    if (attribute(source, name) >= 0) floats += static_cast<std::uint64_t>(count);
  }
  for (const char* name : UV_NAMES) floats += attribute(source, name) >= 0 ? 2 : 0;
  for (const char* name : VISIBILITY_NAMES) floats += attribute(source, name) >= 0 ? 4 : 0;
  std::uint64_t indices = source.indices >= 0 ? from_.accessors.count(source.indices) : 0;
  if (source.mode == MODE_STRIP || source.mode == MODE_FAN) indices = 3 * std::max(indices, vertices);
  from_.memory.charge(2 * sizeof(float) * (vertices * floats + indices), where_);
}

std::optional<DracoMesh> GeometryReader::decodeDraco(const Source& source) const {
  const auto found = source.extensions.find(DRACO_EXTENSION);
  if (found == source.extensions.end()) return std::nullopt;
  DracoExpectation expected;
  expected.vertices = from_.accessors.count(attribute(source, "POSITION"));
  // A strip's accessor counts the strip, the Draco mesh its triangles.
  const bool counted = source.indices >= 0 && source.mode != MODE_STRIP;
  expected.points = source.mode == MODE_POINTS;
  expected.indices = counted ? from_.accessors.count(source.indices) : 0;
  const auto data = from_.resources.view(found->second.Get("bufferView").GetNumberAsInt());
  auto mesh = DracoMesh::decode(data, expected, {from_.limits, from_.memory, from_.cancel},
                                where_ + pointer("extensions", DRACO_EXTENSION));
  if (!counted && mesh.indices()) from_.memory.charge(2 * sizeof(std::uint32_t) * mesh.indices()->size(), where_);
  return mesh;
}

void GeometryReader::readStream(const Source& source, const DracoMesh* draco, const std::string& name,
                                std::span<float> out) const {
  const int accessor = attribute(source, name);
  if (draco) {
    const auto& ids = source.extensions.at(DRACO_EXTENSION).Get("attributes");
    if (ids.Has(name)) {
      const auto& info = from_.accessors.info(accessor);
      draco->readFloats(static_cast<std::uint32_t>(ids.Get(name).GetNumberAsInt()), info.componentType, info.normalized,
                        from_.accessors.components(accessor), out,
                        where_ + pointer("extensions", DRACO_EXTENSION, "attributes", name));
      return;
    }
    // Without a view either, the attribute would silently be zeros.
    const auto& info = from_.accessors.info(accessor);
    if (info.bufferView < 0 && !info.sparse.isSparse) {
      fail("E_DRACO",
           "the Draco mesh does not hold the attribute " + telar::quoted(name) + ", and its accessor has no data",
           where_ + pointer("extensions", DRACO_EXTENSION, "attributes"));
    }
  }
  from_.accessors.readFloats(accessor, out, Normalizing::kFetched);
}

Order GeometryReader::readOrder(const Source& source, const DracoMesh* draco, std::size_t vertices) const {
  if (draco) return draco->indices();
  if (source.indices < 0) return std::nullopt;
  std::vector<std::uint32_t> out(from_.accessors.count(source.indices));
  from_.accessors.readUnsigned(source.indices, out);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i] >= vertices) {
      fail("E_INDEX",
           "index " + std::to_string(i) + " names vertex " + std::to_string(out[i]) + " of " + std::to_string(vertices),
           pointer("accessors", source.indices));
    }
  }
  return out;
}

void GeometryReader::readElements(const Source& source, const DracoMesh* draco, const std::vector<bool>& bad,
                                  Primitive& out) const {
  const std::size_t vertices = out.positions.size();
  Order order = readOrder(source, draco, vertices);
  // To leave elements out, all are written out one by one.
  if (!bad.empty()) from_.memory.charge(4 * sizeof(std::uint32_t) * (order ? order->size() : vertices), where_);
  out.topology = toTopology(draco && draco->indices() ? MODE_TRIANGLES : source.mode, vertices, order);
  const std::size_t dropped = bad.empty() ? 0 : dropElements(out.topology, vertices, bad, order);
  if (dropped > 0) {
    from_.warnings.add("W_NONFINITE", std::to_string(dropped) + " elements touch vertices that are not finite", where_);
  }
  if (drawsNothing(out.topology, vertices, order)) {
    from_.warnings.add("W_GEOMETRY", "the primitive has no complete element and was left out", where_);
    out.positions.clear();
  } else if (order) {
    out.indices = std::move(*order);
  }
}

void GeometryReader::readAttributes(const Source& source, const DracoMesh* draco, Primitive& out) const {
  const std::size_t vertices = out.positions.size();
  if (attribute(source, "NORMAL") >= 0) {
    out.normals.resize(vertices);
    readStream(source, draco, "NORMAL", floatsOf(out.normals));
  }
  if (attribute(source, "TANGENT") >= 0) {
    out.tangents.resize(vertices);
    readStream(source, draco, "TANGENT", floatsOf(out.tangents));
  }
  for (std::size_t set = 0; set < out.uvs.size(); ++set) {
    if (attribute(source, UV_NAMES[set]) < 0) continue;
    out.uvs[set].resize(vertices);
    readStream(source, draco, UV_NAMES[set], floatsOf(out.uvs[set]));
  }
  for (std::size_t side = 0; side < out.visibility.size(); ++side) {
    if (attribute(source, VISIBILITY_NAMES[side]) < 0) continue;
    out.visibility[side].resize(vertices);
    readStream(source, draco, VISIBILITY_NAMES[side], floatsOf(out.visibility[side]));
  }
  const int color = attribute(source, "COLOR_0");
  if (color < 0) return;
  out.colorsHaveAlpha = from_.accessors.components(color) == 4;
  out.colors.resize(vertices, glm::vec4(1));
  if (out.colorsHaveAlpha) return readStream(source, draco, "COLOR_0", floatsOf(out.colors));
  const auto loan = from_.memory.lend(vertices * sizeof(glm::vec3), where_);
  std::vector<glm::vec3> rgb(vertices);
  readStream(source, draco, "COLOR_0", floatsOf(rgb));
  for (std::size_t i = 0; i < vertices; ++i) out.colors[i] = glm::vec4(rgb[i], 1.0f);
}

void GeometryReader::repairStreams(Primitive& out) const {
  const auto warn = [&](std::size_t changed, const char* what) {
    if (changed == 0) return;
    from_.warnings.add("W_NONFINITE", std::to_string(changed) + " " + what, where_);
  };
  warn(repairNormals(out), "normals were not usable and were replaced");
  warn(repairTangents(out), "tangents were not of length 1; without length they are not used");
  for (auto& uvs : out.uvs) warn(repairUvs(uvs), "texture coordinates were not finite and were set to 0");
  warn(repairColors(out.colors), "vertex colours were out of range and were clamped");
  for (auto& visibility : out.visibility) warn(repairVisibility(visibility), "ambient visibilities were not usable");
}

void GeometryReader::readVariants(const Source& source, Primitive& out) const {
  const auto found = source.extensions.find("KHR_materials_variants");
  if (found == source.extensions.end()) return;
  for (const auto& mapping : arrayOf(found->second, "mappings")) {
    for (const auto& variant : arrayOf(mapping, "variants")) {
      out.variantMaterials[variant.GetNumberAsInt()] = mapping.Get("material").GetNumberAsInt();
    }
  }
}

namespace {

/// What a whole number counts for: three.js multiplies by it, and so has other bounds than positions for the least of signed ones.
double stepOf(int componentType, bool normalized) {
  if (!normalized) return 1;
  switch (componentType) {
    case COMPONENT_I8:
      return 1.0 / 127;
    case COMPONENT_U8:
      return 1.0 / 255;
    case COMPONENT_I16:
      return 1.0 / 32767;
    case COMPONENT_U16:
      return 1.0 / 65535;
    default:
      return 1;
  }
}

/// GLTFLoader's bounds: those that the accessor declares, whatever it holds, as far as they are numbers of a model; where it
/// declares none, of all vertices.
Bounds declaredBounds(const tinygltf::Accessor& info, const std::vector<glm::vec3>& positions) {
  constexpr double MOST = 1e18;  // of a coordinate: sums and products of such stay finite
  Bounds out;
  if (info.minValues.size() == 3 && info.maxValues.size() == 3) {
    const auto corner = [&](const std::vector<double>& v) {
      return glm::dvec3(v[0], v[1], v[2]) * stepOf(info.componentType, info.normalized);
    };
    const glm::dvec3 low = corner(info.minValues), high = corner(info.maxValues);
    const auto isUsable = [](const glm::dvec3& v) {
      return glm::all(glm::lessThanEqual(glm::abs(v), glm::dvec3(MOST)));
    };
    if (isUsable(low) && isUsable(high)) out = {low, high};
    return out;
  }
  for (const auto& position : positions) out.add(glm::dvec3(position));
  return out;
}

}  // namespace

/// Bounds of what is drawn, and a comparison with the declared ones, by which draws are sorted and nothing else.
void GeometryReader::measure(const Source& source, Primitive& out) const {
  const auto used = usedVertices(out.positions.size(), out.indices);
  out.bounds = drawnBounds(out.positions, used);
  const int accessor = attribute(source, "POSITION");
  const auto& info = from_.accessors.info(accessor);
  out.fileBounds = declaredBounds(info, out.positions);
  if (info.componentType != COMPONENT_F32 || (info.minValues.empty() && info.maxValues.empty())) return;
  bool right = info.minValues.size() == 3 && info.maxValues.size() == 3;
  const double slack = 1e-3 * out.bounds.diagonal();
  for (int i = 0; right && i < 3; ++i) {
    const double low = info.minValues[static_cast<std::size_t>(i)], high = info.maxValues[static_cast<std::size_t>(i)];
    right = low <= out.bounds.min[i] + slack && high >= out.bounds.max[i] - slack;
    // Vertices that no element uses may make the declared box larger.
    if (used.empty()) right = right && low >= out.bounds.min[i] - slack && high <= out.bounds.max[i] + slack;
  }
  if (right) return;
  from_.warnings.add("W_MINMAX", "min and max do not bound the positions; the real bounds are used",
                     pointer("accessors", accessor));
}

std::optional<Primitive> GeometryReader::read(int mesh, std::size_t primitive, std::size_t joints) {
  const Source& source = from_.document.model.meshes[static_cast<std::size_t>(mesh)].primitives[primitive];
  where_ = pointer("meshes", mesh, "primitives", primitive);
  from_.cancel.check();
  if (attribute(source, "POSITION") < 0) {
    from_.warnings.add("W_GEOMETRY", "the primitive has no POSITION and was left out", where_);
    return std::nullopt;
  }
  checkLayout(source);
  chargeStreams(source);
  const DeformerReader deformers(from_.accessors, from_.cancel, from_.warnings, source, where_, joints);
  deformers.check();
  from_.memory.charge(deformers.bytes(), where_);
  const auto draco = decodeDraco(source);
  const DracoMesh* mesher = draco ? &*draco : nullptr;
  Primitive out;
  out.positions.resize(from_.accessors.count(attribute(source, "POSITION")));
  readStream(source, mesher, "POSITION", floatsOf(out.positions));
  readElements(source, mesher, findBadVertices(out.positions), out);
  if (out.positions.empty()) return std::nullopt;
  readAttributes(source, mesher, out);
  repairStreams(out);
  out.file = static_cast<int>(primitive);
  out.material = source.material;
  readVariants(source, out);
  out.deformers = deformers.read(
      out, [&](const std::string& name, std::span<float> stream) { readStream(source, mesher, name, stream); });
  measure(source, out);
  return out;
}

}  // namespace telar::asset
