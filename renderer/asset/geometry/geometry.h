#pragma once
#include <optional>

#include "asset/accessor/accessor.h"
#include "asset/geometry/topology.h"
#include "core/memory_budget.h"

namespace telar::asset {

class DracoMesh;

/// Reads primitives into the streams that are drawn.
class GeometryReader {
 public:
  struct Sources {
    const Document& document;
    const Resources& resources;
    const Accessors& accessors;
    const Limits& limits;
    const CancelToken& cancel;
    Warnings& warnings;
    MemoryBudget& memory;
    bool tolerant = false;                            ///< a texture without a readable image is a warning
    std::span<const std::byte> file = {};             ///< of the model
    std::shared_ptr<const void> fileOwner = nullptr;  ///< null = images are decoded before the scene is there
  };
  explicit GeometryReader(const Sources& sources) : from_(sources) {}

  /// None where nothing of the primitive can be drawn (a warning says why).
  /// @param joints of the smallest skin that moves the mesh; 0 = none does
  /// @throws Error{E_ACCESSOR, E_STRIDE, E_INDEX, E_SPARSE, E_DRACO, E_SKIN, L_*, X_CANCELLED}
  std::optional<Primitive> read(int mesh, std::size_t primitive, std::size_t joints);

 private:
  using Source = tinygltf::Primitive;

  int attribute(const Source& source, const std::string& name) const;
  void checkAttribute(const Source& source, const std::string& name, unsigned least, unsigned most) const;
  void checkLayout(const Source& source) const;
  void chargeStreams(const Source& source) const;
  std::optional<DracoMesh> decodeDraco(const Source& source) const;
  void readStream(const Source& source, const DracoMesh* draco, const std::string& name, std::span<float> out) const;
  Order readOrder(const Source& source, const DracoMesh* draco, std::size_t vertices) const;
  void readElements(const Source& source, const DracoMesh* draco, const std::vector<bool>& bad, Primitive& out) const;
  void readAttributes(const Source& source, const DracoMesh* draco, Primitive& out) const;
  void repairStreams(Primitive& out) const;
  void readVariants(const Source& source, Primitive& out) const;
  void measure(const Source& source, Primitive& out) const;

  Sources from_;
  std::string where_;
};

}  // namespace telar::asset
