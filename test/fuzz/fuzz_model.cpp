// A model, .glb or .gltf, as loadBytes() takes it: the container, the schema, Draco, meshopt and the images inside.
// Whatever is no Error of telar ends the program. The mutator changes the JSON of a .glb as JSON, or else bytes
// anywhere. With TELAR_FUZZ_BUFFERS it leaves the JSON of a .glb as it is, so that all goes to the decoders of its
// buffers.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "json_mutator.h"
#include "telar/error.h"
#include "telar/load.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

constexpr std::size_t HEADER = 20;  // of a .glb and its first chunk
constexpr std::uint32_t MAGIC = 0x46546c67;

std::uint32_t wordAt(const std::uint8_t* data) {
  std::uint32_t word = 0;
  std::memcpy(&word, data, sizeof word);
  return word;
}

/// Length of the JSON chunk of a .glb whose lengths hold.
std::optional<std::size_t> jsonLength(const std::uint8_t* data, std::size_t size) {
  if (size < HEADER || wordAt(data) != MAGIC) return {};
  const std::size_t length = wordAt(data + 12);
  if (length > size - HEADER) return {};
  return length;
}

/// Puts another JSON into a .glb. @return its new size, 0 where it does not fit
std::size_t replaceJson(std::uint8_t* data, std::size_t size, std::size_t most, std::size_t length, std::string json) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t rest = size - HEADER - length, total = HEADER + json.size() + rest;
  if (total > most) return 0;
  std::memmove(data + HEADER + json.size(), data + HEADER + length, rest);
  std::copy(json.begin(), json.end(), data + HEADER);
  const std::uint32_t words[2] = {static_cast<std::uint32_t>(total), static_cast<std::uint32_t>(json.size())};
  std::memcpy(data + 8, words, sizeof words);
  return total;
}

#ifdef TELAR_FUZZ_BUFFERS
/// Changes what lies behind the JSON and its chunk's header; what is cut off is 0, so that every length holds.
bool changeBuffers(std::uint8_t* data, std::size_t size, std::size_t json) {
  constexpr std::size_t CHUNK = 8;
  const std::size_t begin = HEADER + json + CHUNK;
  if (begin >= size) return false;
  const std::size_t left = LLVMFuzzerMutate(data + begin, size - begin, size - begin);
  std::fill(data + begin + left, data + size, std::uint8_t{0});
  return true;
}
#else
bool changeBuffers(std::uint8_t*, std::size_t, std::size_t) { return false; }
#endif

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  telar::fuzz::Random random(seed);
  const std::optional<std::size_t> length = jsonLength(data, size);
  if (length && changeBuffers(data, size, *length)) return size;
  if (!length || random() % 2) return LLVMFuzzerMutate(data, size, most);
  const std::string text(reinterpret_cast<const char*>(data) + HEADER, *length);
  std::string json = telar::fuzz::changed(text, most, random);
  const std::size_t total = json.empty() ? 0 : replaceJson(data, size, most, *length, std::move(json));
  return total ? total : LLVMFuzzerMutate(data, size, most);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Large models and pictures take time and find nothing more: a short file may name millions of vertices.
  telar::Limits limits;
  limits.vertices = limits.triangles = limits.imagePixels = 1 << 20;
  telar::LoadOptions options;
  options.tolerant = size % 2;
  // Of the others half wait for their images, and half are gone while these are decoded.
  options.decodesLater = true;
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto file = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
  options.owner = file;
  try {
    const auto scene = telar::loadBytes(*file, limits, {}, options);
    if (size % 4 == 0) waitForImages(*scene, {});
  } catch (const telar::Error&) {
  }
  return 0;
}
