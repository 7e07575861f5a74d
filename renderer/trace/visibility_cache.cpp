#include "trace/visibility_cache.h"

#include <array>
#include <cstdint>
#include <cstring>

#include "core/sealed_file.h"
#include "core/sha256.h"

namespace telar::trace {
namespace {

/// What a file begins with.
using Magic = std::array<char, 8>;
constexpr Magic MAGIC = {'t', 'e', 'l', 'a', 'r', 'A', 'V', '1'};

/// Before the floats of each primitive.
struct Part {
  std::int32_t mesh;
  std::uint32_t primitive;
  std::array<std::uint32_t, 2> vertices;  ///< of front and back
};

std::span<const std::byte> floatsOf(const std::vector<glm::vec4>& stream) { return std::as_bytes(std::span(stream)); }

/// Takes what is at the front of a file.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool isAtEnd() const { return bytes_.empty(); }

  template <typename T>
  bool read(T* out, std::size_t count) {
    if (count > bytes_.size() / sizeof(T)) return false;
    if (count > 0) std::memcpy(out, bytes_.data(), count * sizeof(T));
    bytes_ = bytes_.subspan(count * sizeof(T));
    return true;
  }

  bool read(std::vector<glm::vec4>& out, std::size_t count) {
    if (count > bytes_.size() / sizeof(glm::vec4)) return false;
    out.resize(count);
    return read(out.data(), count);
  }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace

std::string visibilityKey(const Scene& model, int rays, std::string_view version) {
  Sha256 digest;
  digest.add(version);
  digest.add(" ambient visibility " + std::to_string(rays) + " " + model.sha256);
  // A file with parts that are missing is drawn without them where the caller allows it.
  for (const Warning& warning : model.warnings) digest.add("\n" + warning.code + " " + warning.pointer);
  return digest.hex();
}

std::vector<std::byte> packVisibility(const FoundVisibility& found, std::string_view key) {
  std::vector<std::byte> file(sizeof(Magic) + SEAL_BYTES);
  const auto add = [&file](std::span<const std::byte> bytes) { file.insert(file.end(), bytes.begin(), bytes.end()); };
  for (const auto& [place, sides] : found) {
    const Part part{place.first,
                    static_cast<std::uint32_t>(place.second),
                    {static_cast<std::uint32_t>(sides[0].size()), static_cast<std::uint32_t>(sides[1].size())}};
    add(std::as_bytes(std::span(&part, 1)));
    for (const auto& side : sides) add(floatsOf(side));
  }
  std::memcpy(file.data(), MAGIC.data(), sizeof MAGIC);
  seal(file, sizeof MAGIC, key);
  return file;
}

std::optional<FoundVisibility> unpackVisibility(std::span<const std::byte> file, std::string_view key) {
  if (!isSealed(file, sizeof MAGIC, key) || std::memcmp(file.data(), MAGIC.data(), sizeof MAGIC) != 0)
    return std::nullopt;
  Reader reader(file.subspan(sizeof MAGIC + SEAL_BYTES));
  FoundVisibility found;
  while (!reader.isAtEnd()) {
    Part part{};
    if (!reader.read(&part, 1)) return std::nullopt;
    const auto [front, back] = part.vertices;
    if (back != 0 && back != front) return std::nullopt;
    VisibilityJob::Sides& sides = found[{part.mesh, part.primitive}];
    if (!reader.read(sides[0], front) || !reader.read(sides[1], back)) return std::nullopt;
  }
  return found;
}

}  // namespace telar::trace
