#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "telar/cancel.h"
#include "telar/limits.h"
#include "telar/load.h"

namespace telar::asset {

/// Owns a file descriptor.
class FileDescriptor {
 public:
  explicit FileDescriptor(int fd = -1) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor();
  int get() const { return fd_; }
  explicit operator bool() const { return fd_ >= 0; }
  int release();

 private:
  int fd_;
};

/// Which file on this machine, whatever its name.
struct FileId {
  std::uint64_t device = 0, inode = 0;
  bool operator==(const FileId&) const = default;
};

/// Reads the model file, which the caller named: links are followed, but it must be a regular file of limited size.
/// @throws Error{E_FILE, L_FILE_BYTES, X_CANCELLED}
std::vector<std::byte> readModelFile(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel,
                                     FileId& id);

/// The files that a model may name: regular files beneath its folder, no links, limited in number and size.
class ModelFolder : public ExternalFiles {
 public:
  ModelFolder(const std::filesystem::path& model, FileId modelId, const Limits& limits);

  /// @param path from relativePath()
  /// @throws Error{E_URI_DENIED, E_URI_MISSING, L_FILE_BYTES, L_EXTERNAL_BYTES, L_EXTERNAL_FILES, X_CANCELLED}
  std::vector<std::byte> read(const std::string& path, const std::string& where, const CancelToken& cancel) override;

  std::uint64_t bytesRead() const override { return bytes_; }

 private:
  const Limits& limits_;
  FileDescriptor folder_;
  FileId modelId_;
  std::uint64_t files_ = 0, bytes_ = 0;
};

/// Opens a path beneath an open folder for reading without following any symbolic link; -1 and errno where it cannot.
/// The kernel's openat2 does it in one step; `walkBeneath` does the same component by component where that is missing.
int openBeneath(int folder, const std::string& path);
int walkBeneath(int folder, const std::string& path);

}  // namespace telar::asset
