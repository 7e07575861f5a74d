#include "asset/accessor/resources.h"

#include <set>

#include "asset/check/number.h"
#include "asset/check/pointer.h"
#include "asset/container/uri.h"
#include "core/sha256.h"

namespace telar::asset {
namespace {
/// In place of the digest of a part that cannot be read.
constexpr const char* ABSENT = "absent";

/// Whether an error tells nothing of the part: the job was ended, or the machine failed.
bool isOfMachine(const Error& error) { return error.code.starts_with("X_"); }
}  // namespace

/// A buffer without bytes is an error only where something reads it.
std::vector<bool> Resources::neededBuffers(const MeshoptViews& compressed) const {
  std::vector<bool> out;
  for (const BufferSource& buffer : document_.buffers) out.push_back(!buffer.fallback);
  for (std::size_t i = 0; i < compressed.size(); ++i) {
    const int buffer = compressed[i] ? compressed[i]->buffer : document_.model.bufferViews[i].buffer;
    out[static_cast<std::size_t>(buffer)] = true;
  }
  return out;
}

void Resources::loadBuffers(const Limits& limits, MemoryBudget& memory) {
  const auto& views = document_.model.bufferViews;
  MeshoptViews compressed;
  for (std::size_t i = 0; i < views.size(); ++i) compressed.push_back(readMeshoptView(views[i], i));
  const std::vector<bool> needed = neededBuffers(compressed);
  for (std::size_t i = 0; i < document_.buffers.size(); ++i) {
    const std::uint64_t wanted = document_.buffers[i].byteLength;
    const auto bytes = needed[i] ? bufferBytes(i, memory) : std::span<const std::byte>();
    if (needed[i] && bytes.size() < wanted) {
      fail("E_BUFFER", "the buffer has fewer bytes than its byteLength of " + std::to_string(wanted),
           pointer("buffers", i, "byteLength"));
    }
    buffers_.push_back(needed[i] ? bytes.first(wanted) : bytes);
  }
  openViews(compressed, limits, memory);
}

std::span<const std::byte> Resources::bufferBytes(std::size_t index, MemoryBudget& memory) {
  const BufferSource& source = document_.buffers[index];
  if (source.uri) {
    owned_.push_back(fetch(*source.uri, pointer("buffers", index, "uri")));
    loans_.push_back(memory.lend(owned_.back().size(), pointer("buffers", index)));
    return owned_.back();
  }
  if (index == 0 && container_.hasBin) return container_.bin;
  fail("E_BUFFER", "the buffer has no uri, and the file has no BIN chunk for it", pointer("buffers", index));
}

std::vector<std::byte> Resources::fetch(const std::string& uri, const std::string& where) const {
  if (isDataUri(uri)) return decodeDataUri(uri, where);
  if (!files_) {
    fail("E_URI_DENIED",
         "the model came as bytes, so the uri " + telar::quoted(uri) +
             " is not opened; embed the file, load the model by its path, or give the option resolve",
         where);
  }
  try {
    std::vector<std::byte> bytes = files_->read(relativePath(uri, where), where, cancel_);
    digests_.try_emplace(uri, sha256Hex(bytes));
    return bytes;
  } catch (const Error& error) {
    if (!isOfMachine(error)) digests_.try_emplace(uri, ABSENT);
    throw;
  }
}

std::string Resources::digestOf(const std::string& uri, const std::string& where) const {
  try {
    if (!digests_.contains(uri)) fetch(uri, where);
    return digests_.at(uri);
  } catch (const Error& error) {
    if (isOfMachine(error)) throw;
    return ABSENT;  // what needs it has failed already, or will
  }
}

std::string Resources::sha256(std::span<const std::byte> file) const {
  const std::string own = sha256Hex(file);
  Sha256 all;
  all.add(own);
  std::set<std::string> met;
  const auto add = [&](const auto& sources, const char* list) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const auto& uri = sources[i].uri;
      if (uri && !isDataUri(*uri) && met.insert(*uri).second) all.add(digestOf(*uri, pointer(list, i, "uri")));
    }
  };
  add(document_.buffers, "buffers");
  add(document_.images, "images");
  return met.empty() ? own : all.hex();
}

void Resources::openViews(const MeshoptViews& compressed, const Limits& limits, MemoryBudget& memory) {
  MeshoptDecoder decoder(limits);
  for (std::size_t i = 0; i < compressed.size(); ++i) {
    cancel_.check();
    const auto& view = document_.model.bufferViews[i];
    if (!fits(document_.buffers[static_cast<std::size_t>(view.buffer)].byteLength, view.byteOffset, 1, 0,
              view.byteLength)) {
      fail("E_BUFFERVIEW", "the buffer view reaches past the end of its buffer", pointer("bufferViews", i));
    }
    if (!compressed[i]) {
      views_.push_back(buffers_[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength));
      continue;
    }
    const auto& buffer = buffers_[static_cast<std::size_t>(compressed[i]->buffer)];
    if (!fits(buffer.size(), compressed[i]->byteOffset, 1, 0, compressed[i]->byteLength)) {
      fail("E_MESHOPT", "the compressed data reaches past the end of its buffer", compressed[i]->where);
    }
    loans_.emplace_back(memory.lend(view.byteLength, compressed[i]->where));
    owned_.push_back(
        decoder.decode(*compressed[i], buffer.subspan(compressed[i]->byteOffset, compressed[i]->byteLength)));
    views_.emplace_back(owned_.back());
  }
}

std::span<const std::byte> Resources::view(int bufferView) const {
  return views_[static_cast<std::size_t>(bufferView)];
}

}  // namespace telar::asset
