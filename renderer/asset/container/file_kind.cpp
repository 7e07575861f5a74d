#include "asset/container/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace telar::asset {
namespace {

using namespace std::string_view_literals;

struct Magic {
  std::string_view begin;  ///< compared without case
  std::string_view kind;
};

constexpr std::array MAGICS{
    Magic{"<!doctype html"sv, "an HTML page, as a download that failed leaves"sv},
    Magic{"<html"sv, "an HTML page, as a download that failed leaves"sv},
    Magic{"<head"sv, "an HTML page, as a download that failed leaves"sv},
    Magic{"<body"sv, "an HTML page, as a download that failed leaves"sv},
    Magic{"<error>"sv, "an error page of a file store, as a download that failed leaves"sv},
    Magic{"version https://git-lfs"sv, "a Git LFS pointer: fetch the file itself with `git lfs pull`"sv},
    Magic{"<collada"sv, "a COLLADA model: export as GLB"sv},
    Magic{"<svg"sv, "an SVG image"sv},
    Magic{"<"sv, "an XML file"sv},
    Magic{"pk\x03\x04"sv, "a ZIP archive: unpack it, or export as GLB"sv},
    Magic{"\x1f\x8b"sv, "a gzip file: unpack it"sv},
    Magic{"\x28\xb5\x2f\xfd"sv, "a zstd file: unpack it"sv},
    Magic{"7z\xbc\xaf"sv, "a 7z archive: unpack it"sv},
    Magic{"rar!"sv, "a RAR archive: unpack it"sv},
    Magic{"\x89png"sv, "a PNG image"sv},
    Magic{"\xff\xd8\xff"sv, "a JPEG image"sv},
    Magic{"gif8"sv, "a GIF image"sv},
    Magic{"riff"sv, "a WebP image or another RIFF file"sv},
    Magic{"\xabktx 20"sv, "a KTX2 texture"sv},
    Magic{"#?radiance"sv, "a Radiance .hdr environment"sv},
    Magic{"#?rgbe"sv, "a Radiance .hdr environment"sv},
    Magic{"\x76\x2f\x31\x01"sv, "an OpenEXR image"sv},
    Magic{"%pdf"sv, "a PDF document"sv},
    Magic{"kaydara fbx"sv, "an FBX model: export as GLB"sv},
    Magic{"; fbx"sv, "an FBX model: export as GLB"sv},
    Magic{"blender"sv, "a Blender file: export as GLB"sv},
    Magic{"draco"sv, "a bare Draco mesh: export as GLB"sv},
    Magic{"mtllib"sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"v "sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"vn "sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"vt "sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"o "sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"g "sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"usemtl "sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"newmtl "sv, "the materials of a Wavefront OBJ model: export the model as GLB"sv},
    Magic{"ply\n"sv, "a PLY model: export as GLB"sv},
    Magic{"solid "sv, "an STL model: export as GLB"sv},
    Magic{"#usda"sv, "a USD model: export as GLB"sv},
    Magic{"pxr-usdc"sv, "a USD model: export as GLB"sv},
    Magic{"iso-10303-21"sv, "a STEP model: export as GLB"sv},
    Magic{"ogawa"sv, "an Alembic model: export as GLB"sv},
    Magic{"//maya ascii"sv, "a Maya scene: export as GLB"sv},
};

constexpr std::array USD_NAMES{".usd"sv, ".usda"sv, ".usdc"sv};

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool startsWith(std::string_view text, std::string_view begin) {
  return text.size() >= begin.size() &&
         std::equal(begin.begin(), begin.end(), text.begin(), [](char a, char b) { return lower(a) == lower(b); });
}

/// Text behind white space and a byte order mark.
std::string_view trimmed(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

/// Text behind its first `end`; empty where there is none.
std::string_view after(std::string_view text, std::string_view end) {
  const std::size_t found = text.find(end);
  return found == std::string_view::npos ? std::string_view() : text.substr(found + end.size());
}

/// Text behind what may stand before the words that tell a format: declarations and comments of XML, comment lines of
/// OBJ.
std::string_view skipped(std::string_view text) {
  if (startsWith(text, "<?xml")) return after(text, "?>");
  if (text.starts_with("<!--")) return after(text, "-->");
  if (text.starts_with("#")) return after(text, "\n");
  return text;
}

const Magic* magicOf(std::string_view text) {
  const auto found =
      std::find_if(MAGICS.begin(), MAGICS.end(), [&](const Magic& magic) { return startsWith(text, magic.begin); });
  return found == MAGICS.end() ? nullptr : &*found;
}

constexpr std::size_t ZIP_NAME_LENGTH_AT = 26, ZIP_NAME_AT = 30;

/// Name of the first file in a ZIP archive; USDZ must begin with its main USD file.
std::string_view firstNameInZip(std::string_view zip) {
  if (zip.size() < ZIP_NAME_AT) return {};
  const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(zip[at])); };
  return zip.substr(ZIP_NAME_AT, byte(ZIP_NAME_LENGTH_AT) | byte(ZIP_NAME_LENGTH_AT + 1) << 8);
}

bool isUsdz(std::string_view head) {
  const std::string_view name = firstNameInZip(head);
  return std::any_of(USD_NAMES.begin(), USD_NAMES.end(),
                     [&](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

std::string_view fileKind(std::string_view head) {
  if (startsWith(head, "pk\x03\x04") && isUsdz(head)) return "a USDZ model: export as GLB";
  for (std::string_view text = trimmed(head); !text.empty();) {
    const std::string_view rest = trimmed(skipped(text));
    const bool isWrapped = rest.size() < text.size() && !text.starts_with('#');
    // An XML declaration or a comment is named after what it stands before.
    if (const Magic* magic = isWrapped && !rest.empty() ? nullptr : magicOf(text)) return magic->kind;
    if (rest.size() == text.size()) break;
    text = rest;
  }
  return "";
}

}  // namespace telar::asset
