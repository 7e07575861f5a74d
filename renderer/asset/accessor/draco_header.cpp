#include <string_view>

#include "asset/accessor/draco_mesh.h"
#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

constexpr unsigned METADATA_DEPTH_MAX = 8;
constexpr std::uint32_t POINT_CLOUD = 0;
constexpr std::uint32_t TRIANGULAR_MESH = 1;
constexpr std::uint32_t METHOD_SEQUENTIAL = 0;
constexpr std::uint32_t METHOD_EDGEBREAKER = 1;
constexpr std::uint32_t FLAG_METADATA = 0x8000;

/// Reads little-endian fields and LEB128 numbers; past the end is E_DRACO.
class Reader {
 public:
  Reader(std::span<const std::byte> data, const std::string& where) : data_(data), where_(where) {}

  [[noreturn]] void refuse(const char* why) const { fail("E_DRACO", std::string("the Draco data ") + why, where_); }

  std::uint32_t u8() {
    need(1);
    return std::to_integer<std::uint32_t>(data_[at_++]);
  }
  std::uint32_t u16() {
    const std::uint32_t low = u8();
    return low | u8() << 8;
  }
  std::uint64_t varint() {
    std::uint64_t out = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint64_t byte = u8();
      out |= (byte & 0x7f) << shift;
      if (byte < 0x80) return out;
    }
    refuse("has a number that is too long");
  }
  void skip(std::uint64_t bytes) {
    need(bytes);
    at_ += bytes;
  }
  std::uint64_t left() const { return data_.size() - at_; }

 private:
  void need(std::uint64_t bytes) const {
    if (bytes > left()) refuse("is cut");
  }
  std::span<const std::byte> data_;
  const std::string& where_;
  std::uint64_t at_ = 0;
};

// libdraco reads nested metadata by recursion, so its depth is bounded here.
void skipMetadata(Reader& reader, unsigned depth) {
  if (depth > METADATA_DEPTH_MAX) reader.refuse("nests its metadata too deep");
  const std::uint64_t entries = reader.varint();
  if (entries > reader.left()) reader.refuse("is cut");
  for (std::uint64_t i = 0; i < entries; ++i) {
    reader.skip(reader.u8());
    reader.skip(reader.varint());
  }
  const std::uint64_t children = reader.varint();
  if (children > reader.left()) reader.refuse("is cut");
  for (std::uint64_t i = 0; i < children; ++i) {
    reader.skip(reader.u8());
    skipMetadata(reader, depth + 1);
  }
}

void skipGeometryMetadata(Reader& reader) {
  const std::uint64_t attributes = reader.varint();
  if (attributes > reader.left()) reader.refuse("is cut");
  for (std::uint64_t i = 0; i < attributes; ++i) {
    reader.varint();  // attribute's unique id
    skipMetadata(reader, 0);
  }
  skipMetadata(reader, 0);
}

}  // namespace

DracoCounts readDracoCounts(std::span<const std::byte> data, const std::string& where) {
  Reader reader(data, where);
  for (const char c : std::string_view("DRACO")) {
    if (reader.u8() != static_cast<unsigned char>(c)) reader.refuse("does not start with its magic bytes");
  }
  const std::uint32_t major = reader.u8(), minor = reader.u8();
  const std::uint32_t type = reader.u8();
  // Points have been of version 2.3 since their k-d tree changed; glTF says nothing of them.
  if (major != 2 || (minor != 2 && !(minor == 3 && type == POINT_CLOUD))) {
    reader.refuse("is not bitstream version 2.2, the one that glTF allows");
  }
  if (type != TRIANGULAR_MESH && type != POINT_CLOUD) reader.refuse("holds neither triangles nor points");
  const std::uint32_t method = reader.u8();
  // The second one is edgebreaker for triangles, a k-d tree for points.
  if (method != METHOD_SEQUENTIAL && method != METHOD_EDGEBREAKER) reader.refuse("has an unknown encoding method");
  if (reader.u16() & FLAG_METADATA) skipGeometryMetadata(reader);
  DracoCounts counts;
  counts.sequential = method == METHOD_SEQUENTIAL;
  if (type == POINT_CLOUD) {
    counts.points = true;
    counts.vertices = reader.u16();
    counts.vertices |= std::uint64_t{reader.u16()} << 16;
    return counts;
  }
  if (method == METHOD_EDGEBREAKER) {
    reader.u8();  // traversal type
    counts.vertices = reader.varint();
    counts.faces = reader.varint();
  } else {
    counts.faces = reader.varint();
    counts.vertices = reader.varint();
  }
  return counts;
}

}  // namespace telar::asset
