#include "asset/file_kind.h"

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
    Magic{"version https://git-lfs"sv, "a Git LFS pointer: fetch the file itself with `git lfs pull`"sv},
    Magic{"<?xml"sv, "an XML file"sv},
    Magic{"<collada"sv, "a COLLADA model"sv},
    Magic{"pk\x03\x04"sv, "a ZIP archive (or USDZ): unpack it, or export as GLB"sv},
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
    Magic{"o "sv, "a Wavefront OBJ model: export as GLB"sv},
    Magic{"ply\n"sv, "a PLY model: export as GLB"sv},
    Magic{"solid "sv, "an STL model: export as GLB"sv},
    Magic{"#usda"sv, "a USD model: export as GLB"sv},
    Magic{"pxr-usdc"sv, "a USD model: export as GLB"sv},
};

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool startsWith(std::string_view text, std::string_view begin) {
  return text.size() >= begin.size() &&
         std::equal(begin.begin(), begin.end(), text.begin(), [](char a, char b) { return lower(a) == lower(b); });
}

/// Leading white space, byte order mark and comment lines of OBJ left out.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view SPACE = " \t\r\n";
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(SPACE), text.size()));
    if (!text.starts_with("# ")) return text;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
}

}  // namespace

std::string_view fileKind(std::string_view head) {
  const std::string_view text = trimmed(head);
  const auto found =
      std::find_if(MAGICS.begin(), MAGICS.end(), [&](const Magic& magic) { return startsWith(text, magic.begin); });
  return found == MAGICS.end() ? "" : found->kind;
}

}  // namespace telar::asset
