#include "asset/accessor/meshopt.h"

#include <meshoptimizer.h>

#include "asset/accessor/meshopt_filters.h"
#include "asset/check/pointer.h"
#include "core/lazy_library.h"

namespace telar::asset {
namespace {

using Mode = MeshoptView::Mode;
using Filter = MeshoptView::Filter;

constexpr const char* EXTENSIONS[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

/// The stream's kind in the upper half of its first byte, its version in the lower.
constexpr unsigned KINDS[] = {0xa, 0xe, 0xd};
constexpr unsigned NEWEST_VERSIONS[] = {0, 1, 1};

/// Most bytes that a byte of a vertex stream may become: a block of 256 vertices has 4 bytes of headers for each byte
/// of a vertex.
constexpr std::uint64_t VERTEX_BYTES_FROM_BYTE = 64;

[[noreturn]] void refuse(const std::string& what, const std::string& where, const char* key) {
  fail("E_MESHOPT", what, where + "/" + key);
}

std::uint64_t sizeAt(const tinygltf::Value& extension, const char* key) {
  return extension.Has(key) ? static_cast<std::uint64_t>(extension.Get(key).GetNumberAsDouble()) : 0;
}

Mode modeOf(const tinygltf::Value& extension, const std::string& where) {
  const auto& name = extension.Get("mode").Get<std::string>();
  if (name == "ATTRIBUTES") return Mode::kAttributes;
  if (name == "TRIANGLES") return Mode::kTriangles;
  if (name == "INDICES") return Mode::kIndices;
  refuse("the mode " + telar::quoted(name) + " is unknown", where, "mode");
}

Filter filterOf(const tinygltf::Value& extension, const std::string& where) {
  if (!extension.Has("filter")) return Filter::kNone;
  const auto& name = extension.Get("filter").Get<std::string>();
  if (name == "NONE") return Filter::kNone;
  if (name == "OCTAHEDRAL") return Filter::kOctahedral;
  if (name == "QUATERNION") return Filter::kQuaternion;
  if (name == "EXPONENTIAL") return Filter::kExponential;
  refuse("the filter " + telar::quoted(name) + " is not one that telar reads; encode without it", where, "filter");
}

bool strideFits(Mode mode, Filter filter, std::uint64_t stride) {
  if (mode != Mode::kAttributes) return stride == 2 || stride == 4;
  if (filter == Filter::kOctahedral) return stride == 4 || stride == 8;
  if (filter == Filter::kQuaternion) return stride == 8;
  return stride >= 4 && stride <= 256 && stride % 4 == 0;
}

/// What the specification demands of the values together.
void check(const MeshoptView& view, const tinygltf::BufferView& parent) {
  if (view.mode != Mode::kAttributes && view.filter != Filter::kNone) {
    refuse("a filter is for attributes only", view.where, "filter");
  }
  if (!strideFits(view.mode, view.filter, view.byteStride)) {
    refuse("the byteStride does not go with the mode and the filter", view.where, "byteStride");
  }
  if (view.mode == Mode::kTriangles && view.count % 3 != 0) {
    refuse("the count of triangles' indices is not a multiple of 3", view.where, "count");
  }
  // Both at most 2^31 and 256: this cannot wrap.
  if (view.count * view.byteStride != parent.byteLength) {
    refuse("count times byteStride is not the byteLength of the buffer view", view.where, "count");
  }
}

/// Whether so many bytes can hold so many elements at all; the library's own checks come after the allocation.
bool canHold(const MeshoptView& view) {
  switch (view.mode) {
    case Mode::kTriangles:
      return view.count / 3 <= view.byteLength;
    case Mode::kIndices:
      return view.count <= view.byteLength;
    default:
      return view.count * view.byteStride / VERTEX_BYTES_FROM_BYTE <= view.byteLength;
  }
}

void checkSource(const MeshoptView& view, std::span<const std::byte> source) {
  const auto mode = static_cast<std::size_t>(view.mode);
  const unsigned first = source.empty() ? 0 : std::to_integer<unsigned>(source.front());
  if (first >> 4 != KINDS[mode]) fail("E_MESHOPT", "the data does not start as its mode does", view.where);
  if ((first & 15) > NEWEST_VERSIONS[mode]) {
    fail("E_MESHOPT",
         "the data is of version " + std::to_string(first & 15) +
             " of its stream, which telar does not read; encode for " + EXTENSIONS[0],
         view.where);
  }
  if (!canHold(view)) fail("E_MESHOPT", "the data is too short for its count", view.where);
}

}  // namespace

std::optional<MeshoptView> readMeshoptView(const tinygltf::BufferView& parent, std::size_t index) {
  for (const char* name : EXTENSIONS) {
    const auto found = parent.extensions.find(name);
    if (found == parent.extensions.end()) continue;
    const tinygltf::Value& extension = found->second;
    MeshoptView out;
    out.where = pointer("bufferViews", index, "extensions", name);
    out.buffer = extension.Get("buffer").GetNumberAsInt();
    out.byteOffset = sizeAt(extension, "byteOffset");
    out.byteLength = sizeAt(extension, "byteLength");
    out.byteStride = sizeAt(extension, "byteStride");
    out.count = sizeAt(extension, "count");
    out.mode = modeOf(extension, out.where);
    out.filter = filterOf(extension, out.where);
    check(out, parent);
    return out;
  }
  return std::nullopt;
}

MeshoptDecoder::MeshoptDecoder(const Limits& limits) : limits_(limits) {}
MeshoptDecoder::~MeshoptDecoder() = default;

std::vector<std::byte> MeshoptDecoder::decode(const MeshoptView& view, std::span<const std::byte> source) {
  checkSource(view, source);
  decodedBytes_ += view.count * view.byteStride;
  checkLimit("L_MESHOPT_BYTES", static_cast<double>(limits_.meshoptBytes), static_cast<double>(decodedBytes_),
             view.where);
  if (!library_) {
    library_ =
        std::make_unique<LazyLibrary>("libmeshoptimizer.so.2d", "libmeshoptimizer2d", "meshopt-compressed models");
  }
  constexpr const char* DECODERS[] = {"meshopt_decodeVertexBuffer", "meshopt_decodeIndexBuffer",
                                      "meshopt_decodeIndexSequence"};
  // All three decoders have this signature.
  const auto decoder =
      library_->function<decltype(meshopt_decodeVertexBuffer)>(DECODERS[static_cast<std::size_t>(view.mode)]);
  std::vector<std::byte> out(view.count * view.byteStride);
  const auto* bytes = reinterpret_cast<const unsigned char*>(source.data());
  if (decoder(out.data(), view.count, view.byteStride, bytes, source.size()) != 0) {
    fail("E_MESHOPT", "the data is damaged or of another length than its count needs", view.where);
  }
  if (view.filter == Filter::kOctahedral) decodeOctahedral(out, view.byteStride);
  if (view.filter == Filter::kQuaternion) decodeQuaternion(out);
  if (view.filter == Filter::kExponential) decodeExponential(out);
  return out;
}

}  // namespace telar::asset
