#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/disk_cache.h"
#include "core/known_files.h"
#include "ibl/atlas_prefilter.h"
#include "ibl/bright_directions.h"
#include "ibl/irradiance.h"
#include "ibl/prefilter.h"
#include "ibl/suns.h"
#include "telar/limits.h"
#include "telar/shot.h"

namespace telar::ibl {

/// The environment of a shot on the GPU, in the forms that a frame needs.
struct Environment {
  CubeMap prefiltered;  ///< size 0 until it is asked for, as the others
  Atlas atlas;          ///< in place of `prefiltered`, for a release of three.js that has one
  CubeMap background;
  OctahedralMap radiance;    ///< of the map, with mip levels; alpha = luminance of the part that `bright` samples
  OctahedralMap irradiance;  ///< / PI, of what `radiance` holds; made with it
  BrightDirections bright;   ///< made with `radiance`
  std::optional<Suns> suns;  ///< none until they are asked for; `prefiltered` does not have their light
  std::string source;        ///< where it came from: "gpu", "bundled", "disk", "prefiltered" or, as it is, "file"
  std::string sha256;        ///< of its file; empty for the bundled one
};

/// What a frame does with its environment.
struct EnvironmentUses {
  bool prefiltered = false;      ///< lights surfaces, or is a blurred background
  bool background = false;       ///< is a sharp background
  bool radiance = false;         ///< lights surfaces that sample it
  bool suns = false;             ///< the prefiltered map, which lacks them, lights surfaces
  bool smallSuns = false;        ///< so does one without its small lights (takeSuns())
  ThreeTerms three{};            ///< how the release of three.js makes `prefiltered` and `background`
  PrefilterSettings settings{};  ///< of `prefiltered`
  double turned = 0;             ///< degrees by which both are turned, in whole columns of the map
};

/// Degrees by which the texels of an environment are turned, where a release cannot turn what it looks up. Directions
/// of the environment are sampled without (EnvironmentUses::radiance).
inline double turnOfTexels(const ThreeTerms& three, double rotation) {
  return three.environmentRotation == ThreeTerms::THREE_ENVIRONMENT_ROTATION_COLUMNS ? rotation : 0;
}

/// Keeps the environments that were used last on the GPU, and prefiltered ones on disk by the SHA-256 of their file.
class EnvironmentCache {
 public:
  /// @param assetDirectory  holds studio.hdr and studio.pmrem
  EnvironmentCache(const gl::Context& context, std::filesystem::path assetDirectory, DiskCache disk, Limits limits);

  /// @param bytes  the file when the source is kBytes
  /// @throws Error{E_ENVIRONMENT_*, X_GL, X_CANCELLED}
  const Environment& get(const Shot::Environment& wanted, std::span<const std::byte> bytes, const EnvironmentUses& uses,
                         const CancelToken& cancel);

 private:
  struct Entry {
    std::string key;
    Environment environment;
  };
  /// The environment if it is here in all forms that are asked for, without a look into its file; else null.
  const Environment* known(const Shot::Environment& wanted, const EnvironmentUses& uses);
  /// Moves an entry to the end. @return null where there is none
  Entry* recent(const std::string& id);
  std::vector<std::byte> fileOf(const Shot::Environment& wanted) const;
  /// @param bundled  it is the file that ships beside the studio
  CubeMap prefiltered(const std::string& key, bool bundled, const PrefilterSettings& settings,
                      const std::function<ImageF&()>& map, std::string& source, const CancelToken& cancel);
  Atlas atlas(const std::string& key, const ThreeTerms& three, const std::function<ImageF&()>& map, std::string& source,
              const CancelToken& cancel);

  const gl::Context& context_;
  std::filesystem::path assets_;
  DiskCache disk_;
  Limits limits_;
  KnownFiles files_;
  std::vector<std::unique_ptr<Entry>> entries_;  // most recent last
};

}  // namespace telar::ibl
