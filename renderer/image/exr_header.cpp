#include "image/exr_header.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "image/environment_header.h"

namespace telar::image {
namespace {

constexpr std::size_t NAME_BYTES_MAX = 254;  // OpenEXR refuses longer ones
constexpr std::size_t CHANNELS_MAX = 64;
constexpr std::uint32_t TILED = 0x200, DEEP = 0x800, MULTI_PART = 0x1000;

/// Attributes that OpenEXR reads with a length of their own, whatever the file says.
struct FixedType {
  std::string_view name;
  std::size_t bytes;
};

constexpr FixedType FIXED_TYPES[] = {
    {"box2i", 16},
    {"box2f", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33f", 36},
    {"m33d", 72},
    {"m44f", 64},
    {"m44d", 128},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2i", 8},
    {"v2f", 8},
    {"v2d", 16},
    {"v3i", 12},
    {"v3f", 12},
    {"v3d", 24},
};

/// Types of the attributes that are read here: OpenEXR refuses others under these names.
struct KnownName {
  std::string_view name, type;
};

constexpr KnownName KNOWN_NAMES[] = {{"dataWindow", "box2i"},    {"compression", "compression"},
                                     {"lineOrder", "lineOrder"}, {"channels", "chlist"},
                                     {"tiles", "tiledesc"},      {"type", "string"}};

/// Bytes from the front to the back, each read once.
class Reader {
 public:
  Reader(Bytes file, std::size_t position) : file_(file), position_(position) {}

  std::size_t position() const { return position_; }

  /// Text up to its zero.
  std::string_view name() {
    const std::string_view text(reinterpret_cast<const char*>(file_.data()), file_.size());
    const std::size_t end = text.find('\0', position_);
    if (end == std::string_view::npos) throw damagedEnvironment(".exr header is cut", file_.size());
    if (end - position_ > NAME_BYTES_MAX)
      throw damagedEnvironment(".exr header has a name that is too long", position_);
    const std::string_view found = text.substr(position_, end - position_);
    position_ = end + 1;
    return found;
  }

  Bytes take(std::uint64_t count) {
    if (count > file_.size() - position_) throw damagedEnvironment(".exr header is cut", file_.size());
    const Bytes found = file_.subspan(position_, static_cast<std::size_t>(count));
    position_ += found.size();
    return found;
  }

  std::uint32_t number() { return le32(data(take(4))); }

 private:
  Bytes file_;
  std::size_t position_;
};

/// Attributes of a length that differs from file to file have to fill it to the last byte too.
bool isWhole(std::string_view type, Bytes value) {
  const auto* fixed = std::find_if(std::begin(FIXED_TYPES), std::end(FIXED_TYPES),
                                   [&](const FixedType& known) { return known.name == type; });
  if (fixed != std::end(FIXED_TYPES)) return value.size() == fixed->bytes;
  if (type == "floatvector") return value.size() % 4 == 0;
  if (type == "idmanifest") return value.size() >= 4;
  if (type == "preview")
    return value.size() >= 8 && std::uint64_t{le32(data(value))} * le32(data(value) + 4) == (value.size() - 8) / 4 &&
           value.size() % 4 == 0;
  if (type != "stringvector") return true;
  while (value.size() >= 4) {
    const std::size_t length = le32(data(value));
    if (length > value.size() - 4) return false;
    value = value.subspan(4 + length);
  }
  return value.empty();
}

std::vector<ExrChannel> channelsOf(Bytes value, std::size_t offset) {
  Reader reader(value, 0);
  std::vector<ExrChannel> channels;
  const auto damaged = [&] { return damagedEnvironment(".exr header has a damaged list of channels", offset); };
  for (std::string_view name = reader.name(); !name.empty(); name = reader.name()) {
    if (channels.size() == CHANNELS_MAX) throw unsupportedEnvironment("has more than 64 channels");
    const std::uint32_t type = reader.number();
    reader.take(4);  // "linear", and three bytes of nothing
    if (reader.number() != 1 || reader.number() != 1)
      throw unsupportedEnvironment("has a channel with fewer texels than the picture");
    if (type > 2) throw damaged();
    channels.push_back({std::string(name), static_cast<ExrType>(type)});
  }
  if (reader.position() != value.size() || channels.empty()) throw damaged();
  std::sort(channels.begin(), channels.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  const auto same = [](const auto& a, const auto& b) { return a.name == b.name; };
  if (std::adjacent_find(channels.begin(), channels.end(), same) != channels.end()) throw damaged();
  return channels;
}

/// One part; nothing behind the last.
class PartReader {
 public:
  PartReader(Reader& reader, std::uint32_t flags) : reader_(reader), flags_(flags) {}

  std::optional<ExrPart> read() {
    const std::size_t begin = reader_.position();
    std::string_view name = reader_.name();
    if (name.empty()) return std::nullopt;
    for (; !name.empty(); name = reader_.name()) attribute(name);
    if (!hasWindow_) throw damagedEnvironment(".exr file has no data window", begin);
    if (part_.channels.empty() || !hasCompression_) throw damagedEnvironment(".exr header lacks an attribute", begin);
    if (flags_ & MULTI_PART) {
      part_.isTiled = type_ == "tiledimage" || type_ == "deeptile";
      part_.isDeep = type_ == "deepscanline" || type_ == "deeptile";
      if (!part_.isTiled && !part_.isDeep && type_ != "scanlineimage")
        throw unsupportedEnvironment("has a part that is no picture");
    } else {
      part_.isTiled = (flags_ & TILED) != 0;
      part_.isDeep = (flags_ & DEEP) != 0;
    }
    if (part_.isTiled && part_.tiles.width == 0) throw damagedEnvironment(".exr header has no size of tiles", begin);
    return part_;
  }

 private:
  void attribute(std::string_view name) {
    const std::size_t offset = reader_.position();
    const std::string_view type = reader_.name();
    const Bytes value = reader_.take(reader_.number());
    const auto* known = std::find_if(std::begin(KNOWN_NAMES), std::end(KNOWN_NAMES),
                                     [&](const KnownName& one) { return one.name == name; });
    if (!isWhole(type, value) || (known != std::end(KNOWN_NAMES) && known->type != type))
      throw damagedEnvironment(".exr header has an attribute of a wrong type or length", offset);
    const std::uint8_t* bytes = data(value);
    if (name == "dataWindow") window(bytes, offset);
    if (name == "channels") part_.channels = channelsOf(value, offset);
    if (name == "lineOrder") part_.isDecreasing = bytes[0] == 1;
    if (name == "type") type_ = std::string_view(reinterpret_cast<const char*>(value.data()), value.size());
    if (name == "tiles") tiles(bytes, offset);
    if (name == "compression") {
      if (bytes[0] > static_cast<int>(ExrCompression::kDwab))
        throw unsupportedEnvironment("has a compression that OpenEXR 3.1 does not know");
      part_.compression = static_cast<ExrCompression>(bytes[0]);
      hasCompression_ = true;
    }
  }

  void window(const std::uint8_t* box, std::size_t offset) {
    const auto at = [&](int i) { return std::int64_t{static_cast<std::int32_t>(le32(box + 4 * i))}; };
    part_.width = at(2) - at(0) + 1;
    part_.height = at(3) - at(1) + 1;
    part_.top = static_cast<std::int32_t>(at(1));
    if (part_.width < 1 || part_.height < 1) throw damagedEnvironment(".exr file has an empty data window", offset);
    hasWindow_ = true;
  }

  void tiles(const std::uint8_t* value, std::size_t offset) {
    part_.tiles = {le32(value), le32(value + 4), static_cast<ExrTiles::Levels>(value[8] & 15), value[8] >> 4 == 1};
    if (part_.tiles.width == 0 || part_.tiles.height == 0 || (value[8] & 15) > 2 || value[8] >> 4 > 1)
      throw damagedEnvironment(".exr header has a damaged size of tiles", offset);
  }

  Reader& reader_;
  std::uint32_t flags_;
  ExrPart part_;
  std::string_view type_;
  bool hasWindow_ = false, hasCompression_ = false;
};

}  // namespace

ExrFile readExrHeader(Bytes file) {
  if (file.size() < 8) throw damagedEnvironment(".exr header is cut", file.size());
  const std::uint32_t flags = le32(data(file) + 4);
  ExrFile exr;
  exr.isMultiPart = (flags & MULTI_PART) != 0;
  Reader reader(file, 8);
  do {
    const std::optional<ExrPart> part = PartReader(reader, flags).read();
    if (!part) break;
    exr.parts.push_back(*part);
  } while (exr.isMultiPart);
  if (exr.parts.empty()) throw damagedEnvironment(".exr file has no data window", 8);
  exr.tables = reader.position();
  return exr;
}

}  // namespace telar::image
