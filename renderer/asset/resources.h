#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "asset/document.h"
#include "asset/files.h"

namespace telar::asset {

/// The bytes of a document's buffers and images. Views into `bin` stay valid only as long as the file's bytes.
class Resources {
 public:
  /// @param folder nullptr when the model came as bytes: every external URI is then denied
  Resources(const Document& document, const Container& container, ModelFolder* folder, const CancelToken& cancel)
      : document_(document), container_(container), folder_(folder), cancel_(cancel) {}

  /// Gets every buffer's bytes, cut to its byteLength, and checks every buffer view against them.
  /// @throws Error{E_BUFFER, E_BUFFERVIEW, E_URI_*, L_*}
  void loadBuffers();

  std::span<const std::byte> view(int bufferView) const;

  /// Bytes at a data: URI or in an external file. @throws Error{E_URI_*, L_*}
  std::vector<std::byte> fetch(const std::string& uri, const std::string& where) const;

 private:
  std::span<const std::byte> bufferBytes(std::size_t index);
  void checkViews() const;

  const Document& document_;
  const Container& container_;
  ModelFolder* folder_;
  const CancelToken& cancel_;
  std::vector<std::vector<std::byte>> owned_;
  std::vector<std::span<const std::byte>> buffers_;
};

}  // namespace telar::asset
