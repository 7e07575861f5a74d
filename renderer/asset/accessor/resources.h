#pragma once
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "asset/accessor/meshopt.h"
#include "asset/container/files.h"
#include "asset/document/document.h"
#include "core/memory_budget.h"

namespace telar::asset {

/// The bytes of a document's buffers and images. Views into `bin` stay valid only as long as the file's bytes.
class Resources {
 public:
  /// @param files nullptr when the model came as bytes alone: every external URI is then denied
  Resources(const Document& document, const Container& container, ExternalFiles* files, const CancelToken& cancel)
      : document_(document), container_(container), files_(files), cancel_(cancel) {}

  /// Gets every buffer's bytes, cut to its byteLength, checks every buffer view against them, and decompresses those of
  /// meshopt. A fallback buffer is only read where a view that is not compressed needs it.
  /// @throws Error{E_BUFFER, E_BUFFERVIEW, E_MESHOPT, E_URI_*, L_*, X_CANCELLED}
  void loadBuffers(const Limits& limits, MemoryBudget& memory);

  std::span<const std::byte> view(int bufferView) const;

  /// Bytes at a data: URI or in an external file. @throws Error{E_URI_*, L_*}
  std::vector<std::byte> fetch(const std::string& uri, const std::string& where) const;

  /// SHA-256 of a model: of its file, and of the external parts that its buffers and images name, in the document's
  /// order. Parts that nothing drawn uses are read for it; one that cannot be read counts as absent.
  /// @param file the bytes that the container lies in
  /// @throws Error{X_CANCELLED}
  std::string sha256(std::span<const std::byte> file) const;

 private:
  using MeshoptViews = std::vector<std::optional<MeshoptView>>;

  std::vector<bool> neededBuffers(const MeshoptViews& compressed) const;
  std::span<const std::byte> bufferBytes(std::size_t index, MemoryBudget& memory);
  std::string digestOf(const std::string& uri, const std::string& where) const;
  void openViews(const MeshoptViews& compressed, const Limits& limits, MemoryBudget& memory);

  const Document& document_;
  const Container& container_;
  ExternalFiles* files_;
  const CancelToken& cancel_;
  mutable std::map<std::string, std::string> digests_;  ///< SHA-256 of the external parts read so far, by URI
  std::vector<std::vector<std::byte>> owned_;
  std::vector<MemoryBudget::Loan> loans_;  ///< for owned_
  std::vector<std::span<const std::byte>> buffers_;
  std::vector<std::span<const std::byte>> views_;
};

}  // namespace telar::asset
