#include "core/read_file.h"
#include "telar/codec.h"
#include "telar/error.h"

namespace telar {
namespace {

constexpr const char* MAP_POINTER = "/environment/map";

[[noreturn]] void failToRead(const std::filesystem::path& path, const Limits& limits) {
  std::error_code failure;
  const auto kind = std::filesystem::status(path, failure).type();
  const auto bytes = std::filesystem::file_size(path, failure);
  if (kind == std::filesystem::file_type::regular && !failure)
    checkLimit("L_FILE_BYTES", static_cast<double>(limits.fileBytes), static_cast<double>(bytes), MAP_POINTER);
  const char* cause = "cannot be read; check its permissions and those of its folder";
  if (kind == std::filesystem::file_type::not_found) cause = "does not exist; check the path and its spelling";
  if (kind == std::filesystem::file_type::directory) cause = "is a folder; give an .hdr or .exr file";
  const bool isOther = kind == std::filesystem::file_type::fifo || kind == std::filesystem::file_type::socket ||
                       kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::block;
  if (isOther) cause = "is not a regular file; give an .hdr or .exr file, or its bytes";
  throw Error("E_ENVIRONMENT_MISSING", "shot.environment.map: " + telar::quoted(path.filename().string()) + " " + cause)
      .at(MAP_POINTER);
}

}  // namespace

std::vector<std::byte> readEnvironmentFile(const std::filesystem::path& path, const Limits& limits) {
  auto file = readFile(path, limits.fileBytes);
  if (!file) failToRead(path, limits);
  return std::move(*file);
}

std::vector<std::byte> readStudioFile(const std::filesystem::path& assetDirectory, const Limits& limits) {
  auto file = readFile(assetDirectory / "studio.hdr", limits.fileBytes);
  if (!file) throw Error("X_INSTALL", "the bundled environment studio.hdr is missing; install telar again");
  return std::move(*file);
}

}  // namespace telar
