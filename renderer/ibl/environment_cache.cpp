#include "ibl/environment_cache.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "core/read_file.h"
#include "core/sha256.h"
#include "ibl/pmrem_file.h"
#include "telar/codec.h"
#include "telar/error.h"

namespace telar::ibl {
namespace {

constexpr std::size_t ENTRIES_MAX = 4;  // about 4 MB of GPU memory each at face size 256
constexpr std::size_t STUDIO_FILE_MAX = 16u << 20;

/// Names settings that are not three.js's.
std::string nameOf(const PrefilterSettings& settings) {
  if (settings == PrefilterSettings()) return {};
  return " faces of " + std::to_string(settings.faceSize) + ", " + std::to_string(settings.samples) + " samples";
}

/// Entries of one map that releases of three.js show otherwise are not one. The newest has the key itself.
std::string entryId(const std::string& key, const EnvironmentUses& uses) {
  if (uses.smallSuns) {
    EnvironmentUses rest = uses;
    rest.smallSuns = false;
    return entryId(key, rest) + " without suns";
  }
  if (uses.settings != PrefilterSettings()) {
    EnvironmentUses rest = uses;
    rest.settings = {};
    return entryId(key, rest) + nameOf(uses.settings);
  }
  const ThreeTerms& three = uses.three;
  if (!hasAtlas(three) && three.backgroundCube == 0 && uses.turned == 0) return key;
  return key + " " + atlasName(three) + " " + std::to_string(three.backgroundCube) + " " + std::to_string(uses.turned);
}

/// Key on disk of a cube of a file. A cube without suns is another one, as is one of other settings.
std::string fileKey(const std::string& sha256, const EnvironmentUses& uses) {
  const std::string name = sha256 + (uses.smallSuns ? " without suns" : "") + nameOf(uses.settings);
  return name == sha256 ? sha256 : sha256Hex(std::as_bytes(std::span(name)));
}

/// Whether it has all forms that are asked for.
bool holds(const Environment& environment, const EnvironmentUses& uses) {
  const int light = hasAtlas(uses.three) ? environment.atlas.faceSize : environment.prefiltered.faceSize;
  return (!uses.suns || environment.suns) && (!uses.prefiltered || light > 0) &&
         (!uses.background || environment.background.faceSize > 0) && (!uses.radiance || environment.radiance.size > 0);
}

/// Columns moved as js/three/older_release.mjs moves them.
ImageF turned(const ImageF& map, double degrees) {
  const auto width = static_cast<std::ptrdiff_t>(map.width);
  const auto columns = static_cast<std::ptrdiff_t>(std::floor(degrees / 360 * static_cast<double>(width) + 0.5));
  const std::ptrdiff_t first = (columns % width + width) % width;
  ImageF out = map;
  for (auto row = out.pixels.begin(); row != out.pixels.end(); row += width * 4)
    std::rotate(row, row + first * 4, row + width * 4);
  return out;
}

/// What a GL holds is known only here; GL itself would say nothing of the map.
void checkSide(const char* texture, int most, std::uint32_t side) {
  if (side <= static_cast<std::uint32_t>(most)) return;
  throw Error("L_ENVIRONMENT_PIXELS", "L_ENVIRONMENT_PIXELS: the environment has a side of " + std::to_string(side) +
                                          " pixels, and the largest " + texture + " of this OpenGL " +
                                          std::to_string(most) + "; give a smaller map")
      .withLimit("L_ENVIRONMENT_PIXELS", most, side);
}

}  // namespace

EnvironmentCache::EnvironmentCache(const gl::Context& context, std::filesystem::path assetDirectory, DiskCache disk,
                                   Limits limits)
    : context_(context), assets_(std::move(assetDirectory)), disk_(std::move(disk)), limits_(limits) {}

std::vector<std::byte> EnvironmentCache::fileOf(const Shot::Environment& wanted) const {
  const bool studio = wanted.source == Shot::Environment::Source::kStudio;
  return studio ? readStudioFile(assets_, limits_) : readEnvironmentFile(wanted.path, limits_);
}

CubeMap EnvironmentCache::prefiltered(const std::string& key, bool bundled, const PrefilterSettings& settings,
                                      const std::function<ImageF&()>& map, std::string& source,
                                      const CancelToken& cancel) {
  if (const auto packed = bundled ? readFile(assets_ / "studio.pmrem", STUDIO_FILE_MAX)
                                  : disk_.read(DiskCache::Kind::kEnvironment, key)) {
    if (auto cube = unpackPmrem(context_, *packed, key)) {
      source = bundled ? "bundled" : "disk";
      return std::move(*cube);
    }
  }
  CubeMap cube = prefilterEquirect(context_, map(), cancel, settings);
  source = "prefiltered";
  if (!bundled && disk_.enabled()) disk_.write(DiskCache::Kind::kEnvironment, key, packPmrem(context_, cube, key));
  return cube;
}

Atlas EnvironmentCache::atlas(const std::string& key, const ThreeTerms& three, const std::function<ImageF&()>& map,
                              std::string& source, const CancelToken& cancel) {
  if (const auto packed = disk_.read(DiskCache::Kind::kEnvironment, key)) {
    if (auto atlas = unpackAtlas(context_, *packed, key)) {
      source = "disk";
      return std::move(*atlas);
    }
  }
  Atlas made = prefilterAtlas(context_, map(), three, cancel);
  source = "prefiltered";
  if (disk_.enabled()) disk_.write(DiskCache::Kind::kEnvironment, key, packPmrem(context_, made, key));
  return made;
}

EnvironmentCache::Entry* EnvironmentCache::recent(const std::string& id) {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) { return entry->key == id; });
  if (found == entries_.end()) return nullptr;
  std::rotate(found, found + 1, entries_.end());
  return entries_.back().get();
}

const Environment* EnvironmentCache::known(const Shot::Environment& wanted, const EnvironmentUses& uses) {
  const auto sha256 = files_.sha256(wanted.path);
  Entry* const entry = sha256 ? recent(entryId(*sha256, uses)) : nullptr;
  if (!entry || !holds(entry->environment, uses)) return nullptr;
  entry->environment.source = "gpu";
  return &entry->environment;
}

const Environment& EnvironmentCache::get(const Shot::Environment& wanted, std::span<const std::byte> bytes,
                                         const EnvironmentUses& uses, const CancelToken& cancel) {
  const bool studio = wanted.source == Shot::Environment::Source::kStudio;
  std::vector<std::byte> own;
  const bool path = wanted.source == Shot::Environment::Source::kPath;
  std::optional<FileStamp> stamp;
  if (path) {
    if (const Environment* environment = known(wanted, uses)) return *environment;
    stamp = stampOf(wanted.path);
    own = fileOf(wanted);
    bytes = own;
  }
  // The bundled environment is known by name: its file is read only for a cube that is not there yet.
  const std::string key = studio ? "studio" : sha256Hex(bytes);
  if (path) files_.remember(wanted.path, stamp, key);
  const std::string id = entryId(key, uses);
  Entry* entry = recent(id);
  if (entry) {
    entry->environment.source = "gpu";
  } else {
    if (entries_.size() >= ENTRIES_MAX) entries_.erase(entries_.begin());
    entry = entries_.emplace_back(std::make_unique<Entry>()).get();
    entry->key = id;
    entry->environment.source = "file";
    if (!studio) entry->environment.sha256 = key;
  }
  const auto shaOfFile = [&] {
    if (studio) bytes = own = fileOf(wanted);
    return studio ? sha256Hex(bytes) : key;
  };
  std::optional<ImageF> decoded;
  Suns taken;
  const auto map = [&]() -> ImageF& {
    if (decoded) return *decoded;
    if (studio) bytes = own = fileOf(wanted);
    decoded = readEnvironment(bytes, limits_, cancel, EnvironmentRange::kFull);
    const int most = context_.capabilities().maxTextureSize;
    checkSide("texture", most, std::max(decoded->width, decoded->height));
    if (uses.smallSuns) taken = takeSuns(*decoded);
    return *decoded;
  };
  const auto suns = [&] {
    const ImageF& whole = map();
    return uses.smallSuns ? taken : sunsOf(whole);
  };
  std::optional<ImageF> moved;
  const auto shownMap = [&]() -> ImageF& {
    if (uses.turned == 0) return map();
    if (!moved) moved = turned(map(), uses.turned);
    return *moved;
  };
  Environment& environment = entry->environment;
  // Also where a cube was found on disk: the file is read for them once, some milliseconds a megapixel. The studio has
  // none.
  if (uses.suns && !environment.suns) environment.suns = studio ? Suns() : suns();
  if (uses.prefiltered && hasAtlas(uses.three)) {
    if (environment.atlas.faceSize == 0) {
      const std::string name =
          fileKey(shaOfFile(), uses) + " " + atlasName(uses.three) + " " + std::to_string(uses.turned);
      const std::string atlasKey = sha256Hex(std::as_bytes(std::span(name)));
      environment.atlas = atlas(atlasKey, uses.three, shownMap, environment.source, cancel);
    }
  } else if (uses.prefiltered && environment.prefiltered.faceSize == 0) {
    const bool bundled = studio && uses.settings == PrefilterSettings();
    environment.prefiltered = uses.turned == 0 ? prefiltered(fileKey(bundled ? key : shaOfFile(), uses), bundled,
                                                             uses.settings, map, environment.source, cancel)
                                               : prefilterEquirect(context_, shownMap(), cancel, uses.settings);
  }
  if (uses.background && environment.background.faceSize == 0) {
    // Face size = height of the map, or half of it, as three.js does.
    const bool half = uses.three.backgroundCube == ThreeTerms::THREE_BACKGROUND_CUBE_HALF;
    GLint most = 0;
    context_.gl().GetIntegerv(GL_MAX_CUBE_MAP_TEXTURE_SIZE, &most);
    checkSide("cube texture", most, half ? shownMap().height / 2 : shownMap().height);
    const auto rows = static_cast<int>(shownMap().height);
    environment.background = equirectToCube(context_, uploadEquirect(context_.gl(), shownMap()),
                                            half ? std::max(rows / 2, 1) : rows, 1, false, cancel);
    context_.check("environment background");
  }
  if (uses.radiance && environment.radiance.size == 0) {
    environment.bright = BrightDirections(map());  // takes its part out of the map: after the background
    environment.irradiance = irradianceMap(context_, map(), cancel);
    environment.radiance = radianceMap(context_, map(), cancel);
  }
  return environment;
}

}  // namespace telar::ibl
