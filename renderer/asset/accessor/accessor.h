#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "asset/accessor/resources.h"

namespace telar::asset {

/// componentType of the glTF specification (GL's own enums).
enum Component : int {
  COMPONENT_I8 = 5120,
  COMPONENT_U8 = 5121,
  COMPONENT_I16 = 5122,
  COMPONENT_U16 = 5123,
  COMPONENT_U32 = 5125,
  COMPONENT_F32 = 5126,
};

/// Bytes of one component; 0 for a type that glTF does not have (5124 INT among them).
unsigned componentBytes(int componentType);

/// How a normalized integer becomes a float. The last bit differs, and with it the picture where light is steep.
enum class Normalizing : std::uint8_t {
  kDivided,  ///< as three.js does where JavaScript reads the value: morph targets, instances, animations
  kFetched,  ///< by the reciprocal, as Mesa does where the vertex stage fetches it
};

/// An integer component as a float: as it is, or normalized as OpenGL ES 3.0 section 2.1.6 says.
float fromComponent(double value, int componentType, bool normalized, Normalizing normalizing);

/// The components of a stream, one after the other: what readFloats() writes into.
template <typename Vector>
std::span<float> floatsOf(std::vector<Vector>& vectors) {
  return {reinterpret_cast<float*>(vectors.data()), vectors.size() * sizeof(Vector) / sizeof(float)};
}

/// Reads accessors of any component type, strided, sparse or without a buffer view (zeros).
class Accessors {
 public:
  Accessors(const Document& document, const Resources& resources, const CancelToken& cancel)
      : document_(document), resources_(resources), cancel_(cancel) {}

  /// Checks every accessor against its buffer view, and that the views of vertex indices have no stride. @throws
  /// Error{E_ACCESSOR, E_STRIDE, E_SPARSE}
  void check() const;

  const tinygltf::Accessor& info(int accessor) const {
    return document_.model.accessors[static_cast<std::size_t>(accessor)];
  }
  std::uint64_t count(int accessor) const { return info(accessor).count; }
  unsigned components(int accessor) const;

  /// @param out count * components floats, or fewer: then the first ones alone. @throws Error{E_SPARSE, X_CANCELLED}
  void readFloats(int accessor, std::span<float> out, Normalizing normalizing = Normalizing::kDivided) const;

  /// For vertex indices and joints: components that are unsigned integers.
  /// @param out count * components values. @throws Error{E_SPARSE, X_CANCELLED}
  void readUnsigned(int accessor, std::span<std::uint32_t> out) const;

 private:
  template <typename Out>
  void read(int accessor, std::span<Out> out, Normalizing normalizing) const;

  const Document& document_;
  const Resources& resources_;
  const CancelToken& cancel_;
};

}  // namespace telar::asset
