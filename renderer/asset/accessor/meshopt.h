#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "asset/document/tinygltf_model.h"
#include "telar/limits.h"

namespace telar {
class LazyLibrary;
}

namespace telar::asset {

/// EXT_meshopt_compression, or KHR_meshopt_compression, of a buffer view. Types and indices are known from the schema.
struct MeshoptView {
  enum class Mode { kAttributes, kTriangles, kIndices };
  enum class Filter { kNone, kOctahedral, kQuaternion, kExponential };

  std::string where;  ///< JSON pointer of the extension object
  int buffer = 0;
  std::uint64_t byteOffset = 0, byteLength = 0;  ///< of the compressed data in its buffer
  std::uint64_t byteStride = 0, count = 0;       ///< of what comes of it
  Mode mode = Mode::kAttributes;
  Filter filter = Filter::kNone;
};

/// What the extension of a view says, checked in itself and against the view; none = the view is not compressed.
/// @throws Error{E_MESHOPT}
std::optional<MeshoptView> readMeshoptView(const tinygltf::BufferView& view, std::size_t index);

/// Decompresses buffer views, with libmeshoptimizer, which the first one loads.
class MeshoptDecoder {
 public:
  explicit MeshoptDecoder(const Limits& limits);
  ~MeshoptDecoder();

  /// @param source view.byteLength bytes
  /// @return count * byteStride bytes; nothing is allocated that the source could not fill
  /// @throws Error{E_MESHOPT, L_MESHOPT_BYTES, X_LIBRARY_MISSING}
  std::vector<std::byte> decode(const MeshoptView& view, std::span<const std::byte> source);

 private:
  const Limits& limits_;
  std::unique_ptr<LazyLibrary> library_;
  std::uint64_t decodedBytes_ = 0;
};

}  // namespace telar::asset
