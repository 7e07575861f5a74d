// .exr environments whose chunks do not hold what the header says. OpenEXR shows the memory behind a short chunk.
#include <malloc.h>

#include <utility>

#include "image/exr_files.h"

using namespace sample;

namespace {

constexpr int WIDTH = 64, HEIGHT = 48;
constexpr auto FULL = telar::EnvironmentRange::kFull;

std::string codeOfExr(const File& file) {
  useBuiltLibrary();
  return codeOf([&] { telar::readEnvironment(file, {}, {}, FULL); });
}

std::uint32_t number(const File& file, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, file.data() + at, 4);
  return value;
}

void set(File& file, std::size_t at, std::uint64_t value, std::size_t bytes = 4) {
  std::memcpy(file.data() + at, &value, bytes);
}

/// Where the value of an attribute begins.
std::size_t attribute(const File& file, const std::string& name, const std::string& type) {
  const std::string text(reinterpret_cast<const char*>(file.data()), file.size());
  const std::string label = name + '\0' + type + '\0';
  return text.find(label) + label.size() + 4;
}

/// Where the table of chunks begins, in a file of one part: the first entry is that of the chunk behind the table.
std::size_t table(const File& file, std::size_t entries) {
  for (std::size_t at = 8; at + 8 <= file.size(); ++at)
    if (number(file, at) == at + 8 * entries && number(file, at + 4) == 0) return at;
  throw std::runtime_error("no table");
}

File withWindow(File file, int corner, std::int32_t change) {
  const std::size_t at = attribute(file, "dataWindow", "box2i") + 4 * std::size_t(corner);
  set(file, at, number(file, at) + std::uint32_t(change));
  return file;
}

/// What readEnvironment() says where memory that nobody wrote holds `byte`.
std::pair<std::string, std::vector<float>> readOver(std::uint8_t byte, const File& file) {
  mallopt(M_PERTURB, byte ^ 0xff);
  std::vector<float> texels;
  const std::string code = codeOf([&] { texels = telar::readEnvironment(file, {}, {}, FULL).pixels; });
  mallopt(M_PERTURB, 0);
  return {code, texels};
}

bool isSame(const std::pair<std::string, std::vector<float>>& a, const std::pair<std::string, std::vector<float>>& b) {
  return a.first == b.first && a.second.size() == b.second.size() &&
         std::memcmp(a.second.data(), b.second.data(), a.second.size() * sizeof(float)) == 0;
}

/// Whether memory that is new, and memory that others have left, holds nothing that a texel shows. What was freed holds
/// the complement: below 0 or no number, which reads as 0, whenever what is new is above 0.
bool isOfTheFile(const File& file) {
  const auto dark = readOver(0, file);
  return isSame(dark, readOver(0x3c, file)) && isSame(dark, readOver(0xc3, file));
}

}  // namespace

TEST(Exr, EveryCompressionIsReadAsOpenImageIoReadsIt) {
  useBuiltLibrary();
  for (const ExrKind& kind : exrKinds()) {
    for (const auto& [width, height] : {std::pair{WIDTH, HEIGHT}, {61, 35}}) {
      const File file = exrFile(kind, width, height);
      const std::vector<float> expected = texelsByOpenImageIo(file);
      telar::ImageF image;
      ASSERT_EQ(codeOf([&] { image = telar::readEnvironment(file, {}, {}, FULL); }), "") << nameOf(kind);
      ASSERT_EQ(image.pixels.size() / 4, expected.size() / 3);
      // A 32-bit texel that a half can hold is cut to it, as three.js has it.
      const float cut = 0x1p-10f;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const float wanted = std::max(expected[i], 0.0f), got = image.pixels[i / 3 * 4 + i % 3];
        ASSERT_TRUE(got <= wanted && wanted - got <= wanted * cut + 0x1p-24f) << nameOf(kind) << " " << i;
      }
    }
  }
}

TEST(Exr, AWindowOfMoreTexelsThanTheChunksHoldIsRefused) {
  for (const ExrKind& kind : exrKinds()) {
    const File file = exrFile(kind, WIDTH, HEIGHT);
    for (const std::int32_t more : {1, 64, 937})
      for (const int corner : {2, 3})
        EXPECT_EQ(codeOfExr(withWindow(file, corner, more)), "E_ENVIRONMENT_CORRUPT")
            << nameOf(kind) << " " << corner << " " << more;
    EXPECT_EQ(codeOfExr(withWindow(file, 0, -64)), "E_ENVIRONMENT_CORRUPT") << nameOf(kind);
  }
}

TEST(Exr, EveryCutIsRefused) {
  for (const ExrKind& kind : exrKinds()) {
    const File file = exrFile(kind, 16, 16);
    const std::size_t step = kind.isMipmap ? file.size() / 3 : 7;  // smaller levels may be lost
    for (std::size_t n = 0; n < (kind.isMipmap || kind.isMultiPart ? file.size() / 3 : file.size()); n += step)
      ASSERT_NE(codeOfExr(cut(file, n)), "") << nameOf(kind) << " " << n << " of " << file.size();
  }
}

TEST(Exr, ChunksAreWhereTheTableSays) {
  const std::pair<const char*, std::size_t> chunks[] = {{"none", HEIGHT}, {"rle", HEIGHT}, {"zips", HEIGHT},
                                                        {"zip", 3},       {"piz", 2},      {"dwaa", 2}};
  for (const auto& [compression, entries] : chunks) {
    const File file = exrFile({compression}, WIDTH, HEIGHT);
    const std::size_t begin = table(file, entries);
    const auto with = [&](std::size_t entry, std::uint64_t value) {
      File other = file;
      set(other, begin + 8 * entry, value, 8);
      return codeOfExr(other);
    };
    EXPECT_EQ(codeOfExr(file), "");
    for (const std::uint64_t value :
         {std::uint64_t{0}, std::uint64_t{8}, std::uint64_t{file.size() - 4}, std::uint64_t{file.size()},
          std::uint64_t{1} << 40, ~std::uint64_t{0}, std::uint64_t{number(file, begin + 8)}})
      EXPECT_EQ(with(0, value), "E_ENVIRONMENT_CORRUPT") << compression << " " << value;
    File longer = file;
    set(longer, number(file, begin) + 4, 0x7fffffff);
    EXPECT_EQ(codeOfExr(longer), "E_ENVIRONMENT_CORRUPT") << compression;
    set(longer, number(file, begin) + 4, 0);
    EXPECT_EQ(codeOfExr(longer), "E_ENVIRONMENT_CORRUPT") << compression;
  }
}

// OpenEXR takes memory for a whole tile before it reads one: 4 GB for a file of 10 KB.
TEST(Exr, TilesFarLargerThanTheirMapAreRefusedBeforeTheyAreRead) {
  ExrKind kind{"b44"};
  kind.isTiled = true;
  File file = exrFile(kind, 16, 16);
  const std::size_t at = attribute(file, "tiles", "tiledesc");
  ASSERT_EQ(number(file, at + 4), 16u);
  for (const std::uint32_t height : {0xff0010u, 0xffffffffu}) {
    set(file, at + 4, height);
    try {
      telar::readEnvironment(file, {}, {}, FULL);
      FAIL() << height;
    } catch (const telar::Error& error) {
      EXPECT_NE(std::string(error.what()).find("tiles that are far larger than its map"), std::string::npos)
          << error.what();
    }
  }
}

// OpenEXR reads attributes of known types by lengths of its own: another header than the one that was checked.
TEST(Exr, AttributesHaveTheLengthOfTheirType) {
  File file = exrFile({"zip"}, WIDTH, HEIGHT);
  const std::size_t at = attribute(file, "screenWindowWidth", "float");
  EXPECT_EQ(number(file, at - 4), 4u);
  set(file, at - 4, 8);
  file.insert(file.begin() + std::ptrdiff_t(at) + 4, 4, std::byte{0});
  EXPECT_EQ(codeOfExr(file), "E_ENVIRONMENT_CORRUPT");
}

// The counts that a chunk of DWA begins with are believed by OpenEXR.
TEST(Exr, CountsOfDwaAreThoseOfTheChunk) {
  useBuiltLibrary();
  for (const char* compression : {"dwaa", "dwab"}) {
    const File file = exrFile({compression}, WIDTH, HEIGHT);
    const std::size_t begin = table(file, compression[3] == 'a' ? 2 : 1);
    const std::size_t chunk = number(file, begin) + 8;
    ASSERT_EQ(number(file, chunk), 2u);
    for (std::size_t count = 0; count < 11; ++count) {
      const std::uint64_t now = number(file, chunk + 8 * count);
      for (const std::uint64_t value : {now - 1, now + 1, now + (1 << 20), std::uint64_t{0}}) {
        if (value == now) continue;
        File other = file;
        set(other, chunk + 8 * count, value, 8);
        EXPECT_EQ(codeOfExr(other), "E_ENVIRONMENT_CORRUPT") << compression << " " << count << " " << value;
        EXPECT_TRUE(isOfTheFile(other)) << compression << " " << count << " " << value;
      }
    }
  }
}

// What a chunk of DWA says to lack is not taken from the memory that would hold it.
TEST(Exr, DwaWithoutItsPartsIsRefused) {
  useBuiltLibrary();
  File plain = exrFile({.compression = "dwab", .isInteger = true}, WIDTH, HEIGHT);
  set(plain, number(plain, table(plain, 1)) + 8 + 8 * 2, 0, 8);
  EXPECT_EQ(codeOfExr(plain), "E_ENVIRONMENT_CORRUPT");

  File cosines = exrFile({"dwab"}, WIDTH, HEIGHT);
  const std::size_t begin = number(cosines, table(cosines, 1)), counts = begin + 8, rules = counts + 8 * 11;
  const std::size_t coefficients = rules + (number(cosines, rules) & 0xffff) + number(cosines, counts + 8 * 2);
  const std::uint32_t bytes = number(cosines, counts + 8 * 3);
  cosines.erase(cosines.begin() + std::ptrdiff_t(coefficients), cosines.begin() + std::ptrdiff_t(coefficients + bytes));
  set(cosines, counts + 8 * 3, 0, 8);
  set(cosines, begin + 4, number(cosines, begin + 4) - bytes);
  EXPECT_EQ(codeOfExr(cosines), "E_ENVIRONMENT_CORRUPT");
}

TEST(Exr, NoTexelIsOfMemoryThatIsNotOfTheFile) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's memory does not heed mallopt";
#endif
  useBuiltLibrary();
  std::uint32_t state = 7;
  const auto random = [&](std::size_t below) {
    state = state * 1664525u + 1013904223u;
    return std::size_t((std::uint64_t{state} * below) >> 32);
  };
  std::size_t taken = 0;
  for (const ExrKind& kind : exrKinds()) {
    const File file = exrFile(kind, 24, 20);
    for (int run = 0; run < 6; ++run) {
      File other = file;
      for (std::size_t changes = 1 + random(3); changes > 0; --changes) {
        const std::size_t at = random(2) ? random(file.size()) : random(std::min<std::size_t>(file.size(), 700));
        other[at] = std::byte(random(3) == 0 ? 0 : random(256));
      }
      if (run % 3 == 0) other = withWindow(file, int(2 + random(2)), std::int32_t(1 + random(40)));
      ASSERT_TRUE(isOfTheFile(other)) << nameOf(kind) << " " << run;
      taken += readOver(0, other).first.empty();
    }
  }
  EXPECT_GT(taken, 10u) << "files that are still taken are the ones that matter";
}
