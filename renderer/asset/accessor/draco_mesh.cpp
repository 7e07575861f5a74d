#include "asset/accessor/draco_mesh.h"

#include <draco/mesh/mesh.h>

#include "asset/accessor/accessor.h"
#include "asset/accessor/draco_decoder.h"
#include "asset/check/pointer.h"

namespace telar::asset {

struct DracoMesh::Mesh {
  std::unique_ptr<draco::PointCloud> cloud;  ///< a draco::Mesh, unless it is points alone
};

namespace {

/// Most that libdraco was seen to hold at once for a face and for a vertex: connectivity, seams, values in two forms.
constexpr std::uint64_t WORKING_BYTES = 100;

void checkCounts(const DracoCounts& counts, const DracoExpectation& expected, const Limits& limits,
                 const std::string& where) {
  if (counts.points) {
    if (!expected.points) fail("E_DRACO", "the Draco data holds points, but the primitive's mode is another", where);
    checkLimit("L_VERTICES", static_cast<double>(limits.vertices), static_cast<double>(counts.vertices), where);
    return;
  }
  if (expected.indices != 0 && counts.faces * 3 != expected.indices) {
    fail("E_DRACO", "the Draco mesh has another number of faces than its index accessor", where);
  }
  checkSum("L_TRIANGLES", static_cast<double>(limits.triangles), static_cast<double>(counts.faces), where);
  checkSum("L_VERTICES", static_cast<double>(limits.vertices), static_cast<double>(counts.vertices), where);
  // A mesh cannot use more vertices than it has corners. How many points come of them is known after decoding only.
  if (counts.vertices > counts.faces * 3) {
    fail("E_DRACO", "the Draco mesh declares more vertices than its faces can use", where);
  }
}

std::vector<std::uint32_t> readIndices(const draco::Mesh& mesh, const std::string& where) {
  std::vector<std::uint32_t> out;
  out.reserve(std::size_t{mesh.num_faces()} * 3);
  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face) {
    for (const draco::PointIndex& point : mesh.face(face)) {
      if (point.value() >= mesh.num_points()) fail("E_DRACO", "a Draco face names a vertex that does not exist", where);
      out.push_back(point.value());
    }
  }
  return out;
}

template <typename T>
void convert(const draco::PointCloud& mesh, const draco::PointAttribute& attribute, std::span<T> out,
             const std::string& where) {
  const auto components = static_cast<unsigned>(attribute.num_components());
  if (!attribute.is_mapping_identity() && attribute.indices_map_size() < mesh.num_points()) {
    fail("E_DRACO", "a Draco attribute has fewer entries than the mesh has vertices", where);
  }
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex value = attribute.mapped_index(point);
    if (value.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(value, attribute.num_components(), &out[std::size_t{point.value()} * components])) {
      fail("E_DRACO", "a Draco attribute does not fit its accessor", where);
    }
  }
}

template <typename T>
void convertIntegers(const draco::PointCloud& mesh, const draco::PointAttribute& attribute, int componentType,
                     bool normalized, std::span<float> out, const std::string& where) {
  std::vector<T> values(out.size());
  convert<T>(mesh, attribute, values, where);
  for (std::size_t i = 0; i < values.size(); ++i) {
    out[i] = fromComponent(static_cast<double>(values[i]), componentType, normalized, Normalizing::kFetched);
  }
}

}  // namespace

DracoMesh::DracoMesh(MemoryBudget::Loan loan, std::unique_ptr<Mesh> mesh)
    : loan_(std::move(loan)), mesh_(std::move(mesh)) {}
DracoMesh::DracoMesh(DracoMesh&&) noexcept = default;
DracoMesh::~DracoMesh() = default;

DracoMesh DracoMesh::decode(std::span<const std::byte> data, const DracoExpectation& expected,
                            const DracoBounds& bounds, const std::string& where) {
  const DracoCounts counts = readDracoCounts(data, where);
  checkCounts(counts, expected, bounds.limits, where);
  auto loan = bounds.memory.lend(WORKING_BYTES * (counts.faces + counts.vertices), where);
  auto decoded = decodeDraco(data, counts, loan, bounds.cancel, where);
  DracoMesh out(std::move(loan), std::make_unique<Mesh>(Mesh{std::move(decoded)}));
  const draco::PointCloud& cloud = *out.mesh_->cloud;
  if (cloud.num_points() != expected.vertices) {
    fail("E_DRACO",
         "the Draco mesh has " + std::to_string(cloud.num_points()) + " vertices, its accessors say " +
             std::to_string(expected.vertices),
         where);
  }
  if (counts.points) return out;
  out.indices_ = readIndices(static_cast<const draco::Mesh&>(cloud), where);
  if (expected.indices != 0 && out.indices_->size() != expected.indices) {
    fail("E_DRACO", "the Draco mesh has another number of indices than its index accessor", where);
  }
  return out;
}

void DracoMesh::readFloats(std::uint32_t uniqueId, int componentType, bool normalized, unsigned components,
                           std::span<float> out, const std::string& where) const {
  const draco::PointCloud& mesh = *mesh_->cloud;
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(uniqueId);
  if (!attribute) fail("E_DRACO", "the Draco mesh has no attribute of this id", where);
  if (static_cast<unsigned>(attribute->num_components()) != components) {
    fail("E_DRACO", "the Draco attribute has another number of components than its accessor", where);
  }
  switch (componentType) {
    case COMPONENT_I8:
      return convertIntegers<std::int8_t>(mesh, *attribute, componentType, normalized, out, where);
    case COMPONENT_U8:
      return convertIntegers<std::uint8_t>(mesh, *attribute, componentType, normalized, out, where);
    case COMPONENT_I16:
      return convertIntegers<std::int16_t>(mesh, *attribute, componentType, normalized, out, where);
    case COMPONENT_U16:
      return convertIntegers<std::uint16_t>(mesh, *attribute, componentType, normalized, out, where);
    case COMPONENT_U32:
      return convertIntegers<std::uint32_t>(mesh, *attribute, componentType, normalized, out, where);
    default:
      return convert<float>(mesh, *attribute, out, where);
  }
}

}  // namespace telar::asset
