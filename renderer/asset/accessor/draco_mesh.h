#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/memory_budget.h"
#include "telar/cancel.h"
#include "telar/limits.h"

namespace telar::asset {

/// What the accessors of a Draco primitive promise.
struct DracoExpectation {
  std::uint64_t vertices = 0;
  std::uint64_t indices = 0;  ///< 0 = the primitive has no index accessor
  bool points = false;        ///< the primitive's mode is POINTS, which a point cloud must go with
};

/// What decoding may cost.
struct DracoBounds {
  const Limits& limits;
  MemoryBudget& memory;
  const CancelToken& cancel;
};

/// A mesh, or a cloud of points, decoded by libdraco: indices and counts are checked, attribute values may still be
/// NaN.
class DracoMesh {
 public:
  /// @param where JSON pointer of the extension object, for errors
  /// @throws Error{E_DRACO, L_TRIANGLES, L_VERTICES, L_MEMORY_BYTES, X_CANCELLED}
  static DracoMesh decode(std::span<const std::byte> data, const DracoExpectation& expected, const DracoBounds& bounds,
                          const std::string& where);
  DracoMesh(DracoMesh&&) noexcept;
  ~DracoMesh();

  /// Of triangles; none = a cloud of points.
  const std::optional<std::vector<std::uint32_t>>& indices() const { return indices_; }

  /// Reads one attribute as the values that an accessor of this type would hold.
  /// @param out vertices * components floats
  /// @throws Error{E_DRACO} where there is no such attribute or it does not fit the accessor
  void readFloats(std::uint32_t uniqueId, int componentType, bool normalized, unsigned components, std::span<float> out,
                  const std::string& where) const;

 private:
  struct Mesh;
  DracoMesh(MemoryBudget::Loan loan, std::unique_ptr<Mesh> mesh);
  MemoryBudget::Loan loan_;
  std::unique_ptr<Mesh> mesh_;
  std::optional<std::vector<std::uint32_t>> indices_;
};

/// Counts in a Draco header, read before libdraco allocates by them. Exposed for tests.
struct DracoCounts {
  std::uint64_t faces = 0;
  std::uint64_t vertices = 0;  ///< points, or encoded vertices where the mesh is edgebreaker
  bool points = false;         ///< a point cloud: no faces
  bool sequential = false;     ///< else edgebreaker, or a k-d tree of points
};

/// src: Draco bitstream specification 2.2, sections 3 "Draco Decoder" to 5 "Connectivity"
/// @throws Error{E_DRACO} for anything but a triangular mesh or a point cloud of bitstream version 2.2
DracoCounts readDracoCounts(std::span<const std::byte> data, const std::string& where);

}  // namespace telar::asset
