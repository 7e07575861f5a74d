#include "ibl/environment_cache.h"

#include <algorithm>

#include "ibl/pmrem_file.h"
#include "telar/codec.h"

namespace telar::ibl {
namespace {

constexpr std::size_t ENTRIES_MAX = 4;  // about 4 MB of GPU memory each at face size 256
constexpr std::size_t PMREM_FILE_MAX = 256u << 20;
constexpr const char* MAP_POINTER = "/environment/map";

/// Says why the caller's file could not be read, by its own name: where it lies on the server is nobody's business.
/// @throws Error{E_ENVIRONMENT_MISSING, L_FILE_BYTES}
[[noreturn]] void failToRead(const std::filesystem::path& path, const Limits& limits) {
  std::error_code failure;
  const auto kind = std::filesystem::status(path, failure).type();
  const auto bytes = std::filesystem::file_size(path, failure);
  if (kind == std::filesystem::file_type::regular && !failure)
    checkLimit("L_FILE_BYTES", static_cast<double>(limits.fileBytes), static_cast<double>(bytes), MAP_POINTER);
  const char* cause = "cannot be read; check its permissions and those of its folder";
  if (kind == std::filesystem::file_type::not_found) cause = "does not exist; check the path and its spelling";
  if (kind == std::filesystem::file_type::directory) cause = "is a folder; give an .hdr or .exr file";
  throw Error("E_ENVIRONMENT_MISSING", "shot.environment.map: " + telar::quoted(path.filename().string()) + " " + cause)
      .at(MAP_POINTER);
}

}  // namespace

EnvironmentCache::EnvironmentCache(const gl::Context& context, std::filesystem::path assetDirectory,
                                   std::filesystem::path cacheDirectory, Limits limits)
    : context_(context), assets_(std::move(assetDirectory)), cache_(std::move(cacheDirectory)), limits_(limits) {}

std::vector<std::byte> EnvironmentCache::fileOf(const Shot::Environment& wanted) const {
  const bool studio = wanted.source == Shot::Environment::Source::kStudio;
  auto file = readFile(studio ? assets_ / "studio.hdr" : std::filesystem::path(wanted.path), limits_.fileBytes);
  if (file) return std::move(*file);
  if (studio) throw Error("X_INSTALL", "the bundled environment studio.hdr is missing; install telar again");
  failToRead(wanted.path, limits_);
}

CubeMap EnvironmentCache::prefiltered(const std::string& key, bool studio, std::span<const std::byte> file,
                                      std::string& source, const CancelToken& cancel) {
  const auto path = studio ? assets_ / "studio.pmrem" : cache_ / (key + ".pmrem");
  if (studio || !cache_.empty()) {
    if (const auto packed = readFile(path, PMREM_FILE_MAX)) {
      if (auto cube = unpackPmrem(context_, *packed)) {
        source = studio ? "bundled" : "disk";
        return std::move(*cube);
      }
    }
  }
  const std::vector<std::byte> own = studio ? fileOf({Shot::Environment::Source::kStudio}) : std::vector<std::byte>();
  CubeMap cube = prefilterEquirect(
      context_, readEnvironment(studio ? std::span<const std::byte>(own) : file, limits_, cancel), cancel);
  source = "prefiltered";
  if (!studio && !cache_.empty()) writeFileAtomically(path, packPmrem(context_, cube));
  return cube;
}

const Environment& EnvironmentCache::get(const Shot::Environment& wanted, std::span<const std::byte> bytes,
                                         bool background, const CancelToken& cancel) {
  // The bundled environment is known by name: its file is read only when a background shows it.
  const bool studio = wanted.source == Shot::Environment::Source::kStudio;
  std::vector<std::byte> own;
  if (wanted.source == Shot::Environment::Source::kPath || (studio && background)) {
    own = fileOf(wanted);
    bytes = own;
  }
  const std::string key = studio ? "studio" : sha256Hex(bytes);

  auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry->key == key; });
  if (found == entries_.end()) {
    auto entry = std::make_unique<Entry>();
    entry->key = key;
    entry->environment.prefiltered = prefiltered(key, studio, bytes, entry->environment.source, cancel);
    if (entries_.size() >= ENTRIES_MAX) entries_.erase(entries_.begin());
    found = entries_.insert(entries_.end(), std::move(entry));
  } else {
    (*found)->environment.source = "gpu";
    std::rotate(found, found + 1, entries_.end());
    found = entries_.end() - 1;
  }
  Environment& environment = (*found)->environment;
  if (background && environment.background.faceSize == 0) {
    const ImageF map = readEnvironment(bytes, limits_, cancel);
    environment.background =
        equirectToCube(context_, uploadEquirect(context_.gl(), map), static_cast<int>(map.height), 1, false, cancel);
    context_.check("environment background");
  }
  return environment;
}

}  // namespace telar::ibl
