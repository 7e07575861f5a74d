#include "asset/container/container.h"

#include <algorithm>
#include <cstring>

#include "asset/check/pointer.h"
#include "asset/container/file_kind.h"

namespace telar::asset {
namespace {

constexpr std::string_view MAGIC = "glTF";
constexpr std::uint32_t CHUNK_JSON = 0x4e4f534a;
constexpr std::uint32_t CHUNK_BIN = 0x004e4942;
constexpr std::uint64_t HEADER_BYTES = 12;
constexpr std::uint64_t CHUNK_HEADER_BYTES = 8;
constexpr std::size_t TEXT_PROBE_BYTES = 256;
constexpr std::size_t KIND_PROBE_BYTES = 4096;  ///< comments may stand before what tells an OBJ file

[[noreturn]] void failAt(std::string_view code, const std::string& message, std::uint64_t offset) {
  throw Error(code, message).atOffset(offset);
}

std::uint32_t readU32(std::span<const std::byte> file, std::uint64_t offset) {
  const auto at = [&](std::uint64_t i) { return std::to_integer<std::uint32_t>(file[offset + i]); };
  return at(0) | at(1) << 8 | at(2) << 16 | at(3) << 24;
}

std::string_view asText(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Archives, images and programs all have control bytes near their start; JSON and other text have none.
bool looksLikeText(std::string_view text) {
  return std::none_of(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), TEXT_PROBE_BYTES)),
                      [](char c) {
                        const auto byte = static_cast<unsigned char>(c);
                        return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r' && c != '\f') || byte == 0x7f;
                      });
}

struct Chunk {
  std::uint32_t type = 0;
  std::uint64_t begin = 0, length = 0;  ///< of the chunk's data
};

Chunk readChunk(std::span<const std::byte> file, std::uint64_t offset) {
  if (file.size() - offset < CHUNK_HEADER_BYTES) failAt("E_GLB_CHUNK", "the GLB ends inside a chunk header", offset);
  Chunk chunk{readU32(file, offset + 4), offset + CHUNK_HEADER_BYTES, readU32(file, offset)};
  if (chunk.length > file.size() - chunk.begin) {
    failAt("E_GLB_CHUNK", "a GLB chunk is longer than the file; the file was cut or its lengths are wrong", offset);
  }
  if (chunk.length % 4 != 0) failAt("E_GLB_CHUNK", "the length of a GLB chunk is not a multiple of 4", offset);
  return chunk;
}

void checkHeader(std::span<const std::byte> file) {
  if (file.size() < HEADER_BYTES) failAt("E_GLB_HEADER", "the GLB ends inside its 12-byte header", file.size());
  const std::uint32_t version = readU32(file, 4);
  if (version != 2) failAt("E_GLB_VERSION", "GLB version is " + std::to_string(version) + ", expected 2", 4);
  const std::uint64_t length = readU32(file, 8);
  if (length < HEADER_BYTES + CHUNK_HEADER_BYTES || length < file.size()) {
    failAt("E_GLB_LENGTH", "the GLB header gives " + std::to_string(length) + " bytes, the file has another length", 8);
  }
}

Container openGlb(std::span<const std::byte> file, Warnings& warnings) {
  checkHeader(file);
  Container out;
  std::uint64_t offset = HEADER_BYTES;
  for (int i = 0; i == 0 || offset < file.size(); ++i) {
    const Chunk chunk = readChunk(file, offset);
    const auto data = file.subspan(chunk.begin, chunk.length);
    if (i == 0) {
      if (chunk.type != CHUNK_JSON) failAt("E_GLB_CHUNK", "the first GLB chunk is not JSON", offset);
      if (data.empty()) failAt("E_GLB_CHUNK", "the JSON chunk of the GLB is empty", offset);
      out.json = asText(data);
      out.jsonOffset = chunk.begin;
    } else if (i == 1 && chunk.type == CHUNK_BIN) {
      out.bin = data;
      out.hasBin = true;
    } else if (chunk.type == CHUNK_JSON || chunk.type == CHUNK_BIN) {
      failAt("E_GLB_CHUNK", "the GLB has a second JSON chunk or a misplaced BIN chunk", offset);
    } else {
      warnings.add("W_GLB_CHUNK", "an unknown GLB chunk was skipped");
    }
    offset = chunk.begin + chunk.length;
  }
  if (readU32(file, 8) > file.size()) {
    failAt("E_GLB_CHUNK", "the file ends before the length in the GLB header; it was cut", file.size());
  }
  return out;
}

std::string notGltf(std::string_view text, std::string_view otherwise) {
  const std::string_view kind = fileKind(text.substr(0, KIND_PROBE_BYTES));
  return "the file is neither GLB nor glTF JSON; it looks like " + std::string(kind.empty() ? otherwise : kind);
}

bool startsLikeJson(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && (text[begin] == '{' || text[begin] == '[');
}

Container openText(std::span<const std::byte> file) {
  const std::string_view text = asText(file);
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    failAt("E_JSON", "the text is UTF-16; glTF JSON must be UTF-8", 0);
  }
  if (!looksLikeText(text)) {
    failAt("E_NOT_GLTF", notGltf(text, "an archive, an image or another model format"), 0);
  }
  if (!startsLikeJson(text)) failAt("E_JSON", notGltf(text, "plain text"), 0);
  Container out;
  out.json = text;
  return out;
}

}  // namespace

Container openContainer(std::span<const std::byte> file, const Limits& limits, Warnings& warnings) {
  if (file.empty()) throw Error("E_EMPTY", "the file has no bytes").atOffset(0);
  checkLimit("L_FILE_BYTES", static_cast<double>(limits.fileBytes), static_cast<double>(file.size()));
  const auto head = asText(file.first(std::min(file.size(), MAGIC.size())));
  const Container out = MAGIC.starts_with(head) ? openGlb(file, warnings) : openText(file);
  checkLimit("L_JSON_BYTES", static_cast<double>(limits.jsonBytes), static_cast<double>(out.json.size()));
  return out;
}

}  // namespace telar::asset
