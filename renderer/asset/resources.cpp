#include "asset/resources.h"

#include "asset/number.h"
#include "asset/pointer.h"
#include "asset/uri.h"

namespace telar::asset {

void Resources::loadBuffers() {
  for (std::size_t i = 0; i < document_.buffers.size(); ++i) {
    const std::uint64_t wanted = document_.buffers[i].byteLength;
    const auto bytes = bufferBytes(i);
    if (bytes.size() < wanted) {
      fail("E_BUFFER", "the buffer has fewer bytes than its byteLength of " + std::to_string(wanted),
           pointer("buffers", i, "byteLength"));
    }
    buffers_.push_back(bytes.first(wanted));
  }
  checkViews();
}

std::span<const std::byte> Resources::bufferBytes(std::size_t index) {
  const BufferSource& source = document_.buffers[index];
  if (source.uri) {
    owned_.push_back(fetch(*source.uri, pointer("buffers", index, "uri")));
    return owned_.back();
  }
  if (index == 0 && container_.hasBin) return container_.bin;
  fail("E_BUFFER", "the buffer has no uri, and the file has no BIN chunk for it", pointer("buffers", index));
}

std::vector<std::byte> Resources::fetch(const std::string& uri, const std::string& where) const {
  if (isDataUri(uri)) return decodeDataUri(uri, where);
  if (!folder_) {
    fail("E_URI_DENIED",
         "the model came as bytes, so the uri " + telar::quoted(uri) +
             " is not opened; embed the file, or load the model by its path",
         where);
  }
  return folder_->read(relativePath(uri, where), where, cancel_);
}

void Resources::checkViews() const {
  const auto& views = document_.model.bufferViews;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const auto& view = views[i];
    if (!fits(buffers_[static_cast<std::size_t>(view.buffer)].size(), view.byteOffset, 1, 0, view.byteLength)) {
      fail("E_BUFFERVIEW", "the buffer view reaches past the end of its buffer", pointer("bufferViews", i));
    }
  }
}

std::span<const std::byte> Resources::view(int bufferView) const {
  const auto& view = document_.model.bufferViews[static_cast<std::size_t>(bufferView)];
  return buffers_[static_cast<std::size_t>(view.buffer)].subspan(view.byteOffset, view.byteLength);
}

}  // namespace telar::asset
