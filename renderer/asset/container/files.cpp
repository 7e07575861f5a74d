#include "asset/container/files.h"

#include <fcntl.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

// O_NONBLOCK: a FIFO must not hold the process. It has no effect on regular files.
constexpr int READ_FLAGS = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
constexpr std::size_t BLOCK_BYTES = std::size_t{1} << 20;

FileId idOf(const struct stat& facts) { return {facts.st_dev, facts.st_ino}; }

/// Reads to the end of the file, but not beyond `expected` bytes: a file that grows meanwhile is cut there.
/// False on a read error.
bool readAll(int fd, std::uint64_t expected, const CancelToken& cancel, std::vector<std::byte>& out) {
  out.resize(expected);
  std::size_t done = 0;
  while (done < out.size()) {
    cancel.check();
    const ssize_t got = ::read(fd, out.data() + done, std::min(BLOCK_BYTES, out.size() - done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  out.resize(done);
  return true;
}

[[noreturn]] void failToOpen(const std::string& path, const std::string& where) {
  const int reason = errno;
  if (reason == ELOOP || reason == EXDEV) {
    fail("E_URI_DENIED", "the file " + telar::quoted(path) + " is a symbolic link or leads out of the model's folder",
         where);
  }
  fail("E_URI_MISSING", "the file " + telar::quoted(path) + " is not beneath the model's folder or cannot be read",
       where);
}

}  // namespace

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

FileDescriptor::~FileDescriptor() {
  if (fd_ >= 0) ::close(fd_);
}

int FileDescriptor::release() { return std::exchange(fd_, -1); }

int walkBeneath(int folder, const std::string& path) {
  FileDescriptor held;
  int at = folder;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    std::string component = path.substr(begin, end - begin);
    if (component.empty()) component = ".";
    if (component == "..") return errno = EXDEV, -1;
    if (end == path.size()) return ::openat(at, component.c_str(), READ_FLAGS | O_NOFOLLOW);
    begin = end + 1;
    if (component == ".") continue;
    FileDescriptor next(::openat(at, component.c_str(), O_PATH | O_CLOEXEC | O_NOFOLLOW));
    struct stat facts {};
    if (!next || ::fstat(next.get(), &facts) != 0) return -1;
    if (S_ISLNK(facts.st_mode)) return errno = ELOOP, -1;
    if (!S_ISDIR(facts.st_mode)) return errno = ENOTDIR, -1;
    held = std::move(next);
    at = held.get();
  }
}

int openBeneath(int folder, const std::string& path) {
  struct open_how how {};
  how.flags = READ_FLAGS;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
  const long fd = ::syscall(SYS_openat2, folder, path.c_str(), &how, sizeof how);
  if (fd >= 0) return static_cast<int>(fd);
  // ENOSYS: kernel before 5.6; EPERM: a container's filter that does not know the call.
  return errno == ENOSYS || errno == EPERM ? walkBeneath(folder, path) : -1;
}

std::vector<std::byte> readModelFile(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel,
                                     FileId& id) {
  const FileDescriptor fd(::open(file.c_str(), READ_FLAGS));
  struct stat facts {};
  if (!fd || ::fstat(fd.get(), &facts) != 0) {
    throw Error("E_FILE", std::string("the model file ") +
                              (errno == ENOENT || errno == ENOTDIR ? "does not exist" : "cannot be opened") +
                              "; check the path and the permissions");
  }
  if (!S_ISREG(facts.st_mode)) throw Error("E_FILE", "the model is not a regular file");
  const auto size = static_cast<std::uint64_t>(facts.st_size);
  checkLimit("L_FILE_BYTES", static_cast<double>(limits.fileBytes), static_cast<double>(size));
  id = idOf(facts);
  std::vector<std::byte> out;
  if (!readAll(fd.get(), size, cancel, out)) throw Error("E_FILE", "the model file cannot be read to its end");
  return out;
}

ModelFolder::ModelFolder(const std::filesystem::path& model, FileId modelId, const Limits& limits)
    : limits_(limits), modelId_(modelId) {
  const auto parent = model.parent_path();
  folder_ = FileDescriptor(::open(parent.empty() ? "." : parent.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
}

std::vector<std::byte> ModelFolder::read(const std::string& path, const std::string& where, const CancelToken& cancel) {
  checkSum("L_EXTERNAL_FILES", static_cast<double>(limits_.externalFiles), static_cast<double>(++files_), where);
  const FileDescriptor fd(openBeneath(folder_.get(), path));
  struct stat facts {};
  if (!fd || ::fstat(fd.get(), &facts) != 0) failToOpen(path, where);
  if (S_ISDIR(facts.st_mode))
    fail("E_URI_MISSING", "the uri " + telar::quoted(path) + " names a folder, not a file", where);
  if (!S_ISREG(facts.st_mode)) fail("E_URI_DENIED", "the uri " + telar::quoted(path) + " names no regular file", where);
  if (idOf(facts) == modelId_) fail("E_URI_MISSING", "the uri names the model file itself", where);
  const auto size = static_cast<std::uint64_t>(facts.st_size);
  checkLimit("L_FILE_BYTES", static_cast<double>(limits_.fileBytes), static_cast<double>(size), where);
  checkSum("L_EXTERNAL_BYTES", static_cast<double>(limits_.externalBytes), static_cast<double>(bytes_ + size), where);
  std::vector<std::byte> out;
  if (!readAll(fd.get(), size, cancel, out)) failToOpen(path, where);
  bytes_ += out.size();
  return out;
}

}  // namespace telar::asset
