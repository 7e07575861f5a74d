#include "image/environment_header.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "image/exr_header.h"

namespace telar::image {
namespace {

constexpr std::size_t HDR_HEADER_MAX = 64 << 10;
constexpr std::uint32_t SIDE_MAX =
    1 << 20;  // keeps width * height far from overflow; the limit is L_ENVIRONMENT_PIXELS

/// Radiance picture format: text lines, an empty line, then "-Y height +X width". Lines end with LF, or with CR and LF,
/// as three.js reads them.
class HdrLines {
 public:
  explicit HdrLines(Bytes file) : text_(reinterpret_cast<const char*>(file.data()), file.size()) {}

  std::string_view next() {
    const std::size_t end = text_.substr(0, HDR_HEADER_MAX).find('\n', position_);
    if (end == std::string_view::npos)
      throw damagedEnvironment(".hdr header has no empty line and size line at its end", position_);
    std::string_view line = text_.substr(position_, end - position_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    position_ = end + 1;
    return line;
  }
  std::size_t position() const { return position_; }

 private:
  std::string_view text_;
  std::size_t position_ = 0;
};

/// Takes `label` and the number behind it off the front of `line`; 0 when they are not there.
std::uint32_t takeSide(std::string_view& line, std::string_view label) {
  if (!line.starts_with(label)) return 0;
  std::uint32_t value = 0;
  const char* end = line.data() + line.size();
  const auto [rest, error] = std::from_chars(line.data() + label.size(), end, value);
  if (error != std::errc()) return 0;
  line = std::string_view(rest, std::size_t(end - rest));
  return value;
}

EnvironmentHeader readHdr(Bytes file) {
  HdrLines lines(file);
  lines.next();
  bool known = false;
  for (std::string_view line = lines.next(); !line.empty(); line = lines.next()) {
    if (line.starts_with("FORMAT=")) known = line == "FORMAT=32-bit_rle_rgbe";
  }
  if (!known) throw unsupportedEnvironment("is a .hdr file that does not hold RGBE pixels");
  const std::size_t offset = lines.position();
  std::string_view size = lines.next();
  EnvironmentHeader header{EnvironmentFormat::kHdr};
  header.height = takeSide(size, "-Y ");
  header.width = takeSide(size, " +X ");
  if (!header.width || !header.height || !size.empty()) {
    throw damagedEnvironment(".hdr file has no size line \"-Y height +X width\"", offset);
  }
  header.pixels = lines.position();
  return header;
}

std::uint32_t clampedSide(std::int64_t side) {
  return static_cast<std::uint32_t>(std::min<std::int64_t>(side, SIDE_MAX + 1));
}

EnvironmentHeader readExr(Bytes file) {
  const ExrPart first = readExrHeader(file).parts.front();
  return {EnvironmentFormat::kExr, clampedSide(first.width), clampedSide(first.height)};
}

}  // namespace

Error unsupportedEnvironment(const std::string& what) {
  return Error("E_ENVIRONMENT_FORMAT", "the environment " + what + "; save it as an equirectangular .hdr or .exr map");
}

Error damagedEnvironment(const std::string& what, std::size_t offset) {
  return Error("E_ENVIRONMENT_CORRUPT", "the environment " + what + "; save it again").atOffset(offset);
}

EnvironmentHeader readEnvironmentHeader(Bytes file) {
  if (hasAt(file, 0, "#?")) return readHdr(file);
  if (hasAt(file, 0, "\x76\x2f\x31\x01")) return readExr(file);
  throw unsupportedEnvironment(file.empty() ? "is empty" : "is neither a .hdr nor an .exr file");
}

}  // namespace telar::image
