#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>

#include "core/read_file.h"
#include "core/sha256.h"
#include "expect_error.h"
#include "ibl/cubes.h"
#include "ibl/environment_cache.h"
#include "ibl/pmrem_file.h"
#include "ibl/prefilter.h"
#include "telar/codec.h"

namespace telar::ibl::pmrem_test {
namespace {

namespace fs = std::filesystem;

using test::gradient;
using test::half;
using test::level;

const std::string KEY(64, 'a');

TEST(Prefilter, TheRoughestLevelIsTheCosineMean) {
  const auto context = gl::Context::create(Backend::kAuto);
  const CubeMap cube = prefilterEquirect(*context, gradient(256), CancelToken());
  EXPECT_EQ(cube.faceSize, 256);
  EXPECT_EQ(maxLodOf(cube), 5);
  // The mean of 1 + 0.8 y under the cosine lobe about +Y is 1 + 0.8 * 2/3; texel centres stand 1/8 off the axis.
  const auto up = level(*context, cube, 5, GL_TEXTURE_CUBE_MAP_POSITIVE_Y);
  EXPECT_NEAR(half(up[(3 * 8 + 3) * 4]), 1 + 0.8 * 2 / 3 * 0.985, 0.004);
  const auto side = level(*context, cube, 5, GL_TEXTURE_CUBE_MAP_POSITIVE_X);
  EXPECT_NEAR((half(side[(3 * 8 + 3) * 4]) + half(side[(4 * 8 + 3) * 4])) / 2, 1.0, 0.004);
}

TEST(Prefilter, FaceSizeIsAQuarterOfTheWidth) {
  const auto context = gl::Context::create(Backend::kAuto);
  EXPECT_EQ(prefilterEquirect(*context, gradient(2048), CancelToken()).faceSize, 512);
}

TEST(Prefilter, SlicesChangeNoByteAndCanBeStopped) {
  const auto context = gl::Context::create(Backend::kAuto);
  const ImageF map = gradient(128);
  const auto allLevels = [&](double sliceMs) {
    context->pacer().begin(CancelToken(), sliceMs);
    const CubeMap cube = prefilterEquirect(*context, map, CancelToken());
    std::vector<std::vector<std::uint16_t>> levels;
    for (int lod = 0; lod < cube.levels; ++lod)
      levels.push_back(level(*context, cube, lod, GL_TEXTURE_CUBE_MAP_POSITIVE_X));
    return levels;
  };
  EXPECT_EQ(allLevels(1e-9), allLevels(std::numeric_limits<double>::infinity()));
  const CancelToken cancelled;
  cancelled.cancel();
  context->pacer().begin(cancelled, 50);
  EXPECT_ERROR(prefilterEquirect(*context, map, CancelToken()), "X_CANCELLED");
}

TEST(PmremFile, ComesBackBitForBit) {
  const auto context = gl::Context::create(Backend::kAuto);
  const CubeMap cube = prefilterEquirect(*context, gradient(128), CancelToken());
  const auto packed = packPmrem(*context, cube, "studio");
  const auto back = unpackPmrem(*context, packed, "studio");
  ASSERT_TRUE(back);
  for (int lod = 0; lod < cube.levels; ++lod) {
    for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face < GL_TEXTURE_CUBE_MAP_POSITIVE_X + 6; ++face) {
      EXPECT_EQ(level(*context, cube, lod, face), level(*context, *back, lod, face));
    }
  }
}

TEST(PmremFile, ADamagedFileIsNotAFile) {
  const auto context = gl::Context::create(Backend::kAuto);
  auto packed = packPmrem(*context, prefilterEquirect(*context, gradient(128), CancelToken()), KEY);
  EXPECT_FALSE(unpackPmrem(*context, std::span(packed).first(packed.size() / 2), KEY));
  EXPECT_FALSE(unpackPmrem(*context, std::span(packed).first(10), KEY));
  for (const std::size_t at :
       {std::size_t{0}, std::size_t{5}, std::size_t{9}, std::size_t{13}, std::size_t{16}, packed.size() - 1}) {
    auto damaged = packed;
    damaged[at] ^= std::byte{0x55};
    EXPECT_FALSE(unpackPmrem(*context, damaged, KEY)) << at;
  }
}

TEST(PmremFile, OfAnotherMapIsNotAFile) {
  const auto context = gl::Context::create(Backend::kAuto);
  const auto packed = packPmrem(*context, prefilterEquirect(*context, gradient(128), CancelToken()), KEY);
  EXPECT_TRUE(unpackPmrem(*context, packed, KEY));
  std::string other = KEY;
  other.back() = '1';
  EXPECT_FALSE(unpackPmrem(*context, packed, other));
  EXPECT_FALSE(unpackPmrem(*context, packed, "studio"));
  // Nor does it become one under another name: the digest holds the key too.
  auto renamed = packed;
  constexpr std::size_t KEY_AT = 16;
  std::memcpy(&renamed[KEY_AT], other.data(), other.size());
  EXPECT_FALSE(unpackPmrem(*context, renamed, other));
}

TEST(EnvironmentCache, TheBundledCubeIsThatOfTheBundledMap) {
  const std::filesystem::path assets = TELAR_SOURCE_DIR "/js/assets";
  const auto hdr = readFile(assets / "studio.hdr", 64u << 20), pmrem = readFile(assets / "studio.pmrem", 64u << 20);
  ASSERT_TRUE(hdr && pmrem) << "run `npm run assets`";
  const auto context = gl::Context::create(Backend::kEglSurfaceless);
  const CubeMap made = prefilterEquirect(*context, readEnvironment(*hdr, Limits{}, CancelToken()), CancelToken());
  const auto shipped = unpackPmrem(*context, *pmrem, "studio");
  ASSERT_TRUE(shipped) << "run `npm run assets`";
  ASSERT_EQ(made.faceSize, shipped->faceSize);
  // Another processor may round a trigonometric function differently; a stale file is far off.
  const auto a = level(*context, made, 3, GL_TEXTURE_CUBE_MAP_POSITIVE_Z),
             b = level(*context, *shipped, 3, GL_TEXTURE_CUBE_MAP_POSITIVE_Z);
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_NEAR(half(a[i]), half(b[i]), 0.002f * half(a[i]) + 1e-4f) << "run `npm run assets`";
}

TEST(EnvironmentCache, AFileThatCannotBeReadIsNamedWithTheCause) {
  const auto context = gl::Context::create(Backend::kEglSurfaceless);
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "telar-environment";
  std::filesystem::create_directories(folder / "folder.hdr");
  ASSERT_TRUE(writeFileAtomically(folder / "big.hdr", std::vector<std::byte>(100)));
  ASSERT_EQ(mkfifo((folder / "pipe.hdr").c_str(), 0600), 0);
  Limits limits;
  limits.fileBytes = 99;
  EnvironmentCache cache(*context, "", {"", 0}, limits);
  const auto said = [&](const char* name) {
    Shot::Environment wanted;
    wanted.source = Shot::Environment::Source::kPath;
    wanted.path = (folder / name).string();
    try {
      cache.get(wanted, {}, {.prefiltered = true}, {});
    } catch (const Error& error) {
      EXPECT_EQ(error.pointer, "/environment/map");
      EXPECT_EQ(std::string(error.what()).find(folder.string()), std::string::npos) << "names a server path";
      return error.code + ": " + error.what();
    }
    return std::string("nothing was thrown");
  };
  const std::string start = "E_ENVIRONMENT_MISSING: shot.environment.map: ";
  EXPECT_EQ(said("absent.hdr"), start + "\"absent.hdr\" does not exist; check the path and its spelling");
  EXPECT_EQ(said("absent/a.exr"), start + "\"a.exr\" does not exist; check the path and its spelling");
  EXPECT_EQ(said("folder.hdr"), start + "\"folder.hdr\" is a folder; give an .hdr or .exr file");
  EXPECT_EQ(said("pipe.hdr"), start + "\"pipe.hdr\" is not a regular file; give an .hdr or .exr file, or its bytes");
  EXPECT_TRUE(said("big.hdr").starts_with("L_FILE_BYTES: L_FILE_BYTES: 100 is over the limit of 99"));
  if (geteuid() != 0) {  // root may read everything
    std::filesystem::permissions(folder / "big.hdr", std::filesystem::perms::none);
    EXPECT_NE(said("big.hdr").find("\"big.hdr\" cannot be read; check its permissions"), std::string::npos);
  }
  std::filesystem::remove_all(folder);
}

/// A folder that goes with the test.
class EnvironmentDisk : public testing::Test {
 protected:
  EnvironmentDisk() { fs::create_directories(folder_); }
  ~EnvironmentDisk() override { fs::remove_all(folder_); }

  /// A map of one colour: `level` tells maps apart.
  static std::vector<std::byte> map(char level) {
    std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n";
    for (int i = 0; i < 32; ++i) file += {level, level, level, '\x80'};
    const auto bytes = std::as_bytes(std::span(file));
    return {bytes.begin(), bytes.end()};
  }

  /// Where a fresh process would have the cube of this map from.
  std::string sourceOf(const std::vector<std::byte>& bytes, std::uint64_t maxBytes = 64u << 20) const {
    Shot::Environment wanted;
    wanted.source = Shot::Environment::Source::kBytes;
    EnvironmentCache cache(*context_, "", {folder_, maxBytes}, Limits{});
    return cache.get(wanted, bytes, {.prefiltered = true}, CancelToken()).source;
  }

  fs::path pathOf(const std::vector<std::byte>& bytes) const { return folder_ / (sha256Hex(bytes) + ".pmrem"); }

  std::set<std::string> names() const {
    std::set<std::string> out;
    for (const auto& entry : fs::directory_iterator(folder_)) out.insert(entry.path().filename().string());
    return out;
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("telar-cache-" + std::to_string(getpid()));
  const std::unique_ptr<gl::Context> context_ = gl::Context::create(Backend::kAuto);
};

TEST_F(EnvironmentDisk, KeepsAPrefilteredCubeByContent) {
  const auto bytes = map('\x40');
  EXPECT_EQ(sourceOf(bytes), "prefiltered");
  EXPECT_EQ(sourceOf(bytes), "disk");
  Shot::Environment wanted;
  wanted.source = Shot::Environment::Source::kBytes;
  EnvironmentCache cache(*context_, "", {folder_, 64u << 20}, Limits{});
  EXPECT_EQ(cache.get(wanted, bytes, {.prefiltered = true, .background = true}, CancelToken()).source, "disk");
  EXPECT_EQ(cache.get(wanted, bytes, {.prefiltered = true}, CancelToken()).source, "gpu");
}

TEST_F(EnvironmentDisk, ACubeOfOtherSettingsIsAnotherOne) {
  const auto bytes = map('\x40');
  const auto sourceWith = [&](const PrefilterSettings& settings) {
    Shot::Environment wanted;
    wanted.source = Shot::Environment::Source::kBytes;
    EnvironmentCache cache(*context_, "", {folder_, 64u << 20}, Limits{});
    const Environment& made = cache.get(wanted, bytes, {.prefiltered = true, .settings = settings}, CancelToken());
    EXPECT_EQ(made.prefiltered.faceSize, settings.faceSize > 0 ? settings.faceSize : 256);
    const std::string source = made.source;
    EXPECT_NE(&cache.get(wanted, bytes, {.prefiltered = true, .settings = {128, 64}}, CancelToken()), &made);
    return source;
  };
  for (const PrefilterSettings& settings : {PrefilterSettings{}, {64, 256}, {0, 32}, {64, 32}}) {
    EXPECT_EQ(sourceWith(settings), "prefiltered") << settings.faceSize << ", " << settings.samples;
    EXPECT_EQ(sourceWith(settings), "disk") << settings.faceSize << ", " << settings.samples;
  }
  EXPECT_EQ(sourceOf(bytes), "disk") << "the usual one has the key of before";
}

TEST_F(EnvironmentDisk, TheStudioOfOtherSettingsIsKeptToo) {
  Shot::Environment wanted;
  wanted.source = Shot::Environment::Source::kStudio;
  const auto sourceWith = [&](const PrefilterSettings& settings) {
    EnvironmentCache cache(*context_, TELAR_SOURCE_DIR "/js/assets", {folder_, 64u << 20}, Limits{});
    return cache.get(wanted, {}, {.prefiltered = true, .settings = settings}, CancelToken()).source;
  };
  EXPECT_EQ(sourceWith({}), "bundled");
  EXPECT_EQ(sourceWith({64, 256}), "prefiltered");
  EXPECT_EQ(sourceWith({64, 256}), "disk");
}

TEST_F(EnvironmentDisk, AFileThatIsKnownHasTheFormsThatAreAskedForNext) {
  Shot::Environment wanted;
  wanted.source = Shot::Environment::Source::kPath;
  wanted.path = TELAR_SOURCE_DIR "/js/assets/studio.hdr";
  EnvironmentCache cache(*context_, "", {folder_, 64u << 20}, Limits{});
  const auto get = [&](const EnvironmentUses& uses) -> const Environment& { return cache.get(wanted, {}, uses, {}); };
  const Environment& first = get({.prefiltered = true});
  EXPECT_EQ(first.source, "prefiltered");
  const Environment& again = get({.prefiltered = true});
  EXPECT_EQ(&again, &first);
  EXPECT_EQ(again.source, "gpu");
  EXPECT_EQ(again.sha256, sha256Hex(*readFile(wanted.path, 64u << 20)));
  EXPECT_GT(get({.background = true}).background.faceSize, 0);
  EXPECT_TRUE(get({.prefiltered = true, .suns = true}).suns);
  EXPECT_NE(&get({.prefiltered = true, .smallSuns = true}), &first) << "this is another cube";
}

TEST_F(EnvironmentDisk, TheFileOfAnotherMapIsNotTaken) {
  const auto bright = map('\x40'), dark = map('\x04');
  EXPECT_EQ(sourceOf(bright), "prefiltered");
  fs::copy_file(pathOf(bright), pathOf(dark));
  EXPECT_EQ(sourceOf(dark), "prefiltered") << "the light of another map";
  EXPECT_EQ(sourceOf(dark), "disk") << "the right one took its place";
}

TEST_F(EnvironmentDisk, APipeInPlaceOfAFileHoldsNothingUp) {
  const auto bytes = map('\x40');
  ASSERT_EQ(mkfifo(pathOf(bytes).c_str(), 0600), 0);
  EXPECT_EQ(sourceOf(bytes), "prefiltered");
  EXPECT_EQ(sourceOf(bytes), "disk") << "the file took its place";
}

TEST_F(EnvironmentDisk, IsBoundedAndKeepsWhatWasUsedLast) {
  const auto a = map('\x11'), b = map('\x22'), c = map('\x33');
  sourceOf(a);
  const std::uint64_t room = 2 * fs::file_size(pathOf(a)) + fs::file_size(pathOf(a)) / 2;
  sourceOf(b, room);
  const auto longAgo = fs::file_time_type::clock::now() - std::chrono::hours(2);
  fs::last_write_time(pathOf(a), longAgo);
  fs::last_write_time(pathOf(b), longAgo + std::chrono::seconds(1));
  EXPECT_EQ(sourceOf(a, room), "disk") << "which makes it the one used last";
  EXPECT_EQ(sourceOf(c, room), "prefiltered");
  EXPECT_EQ(names(), (std::set{pathOf(a).filename().string(), pathOf(c).filename().string()}));
  EXPECT_EQ(sourceOf(map('\x44'), 1), "prefiltered");
  EXPECT_EQ(names().size(), 2u) << "what is larger than all the room is not kept";
}

TEST_F(EnvironmentDisk, WhatWasLeftHalfWrittenGoes) {
  const auto bytes = map('\x40');
  const std::string mine = pathOf(bytes).filename().string();
  const auto touch = [&](const std::string& name, std::chrono::minutes age) {
    ASSERT_TRUE(writeFileAtomically(folder_ / name, std::vector<std::byte>(3)));
    fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() - age);
  };
  touch(mine + ".17-4711", std::chrono::minutes(61));
  touch(mine + ".18-4711", std::chrono::minutes(1));
  touch("notes.txt", std::chrono::minutes(9000));
  touch("notes.pmrem.17-4711", std::chrono::minutes(9000));
  EXPECT_EQ(sourceOf(bytes), "prefiltered");
  EXPECT_EQ(names(), (std::set{mine, mine + ".18-4711", std::string("notes.pmrem.17-4711"), std::string("notes.txt")}));
}

}  // namespace
}  // namespace telar::ibl::pmrem_test
