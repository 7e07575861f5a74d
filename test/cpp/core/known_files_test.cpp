#include "core/known_files.h"

#include <gtest/gtest.h>

#include <fstream>

namespace telar::known_files_test {
namespace {

constexpr std::int64_t SECOND = 1'000'000'000;

class KnownFilesTest : public testing::Test {
 protected:
  KnownFilesTest() : path_(std::filesystem::path(testing::TempDir()) / ("telar-known-" + std::to_string(stampNow()))) {
    write("some light");
  }
  ~KnownFilesTest() override { std::filesystem::remove(path_); }

  void write(const char* text) const { std::ofstream(path_) << text; }
  /// As if three seconds had passed since it was written.
  void remember() { files_.remember(path_, stampOf(path_), "hash", stampNow() + 3 * SECOND); }

  std::filesystem::path path_;
  KnownFiles files_;
};

TEST_F(KnownFilesTest, AFileIsKnownWhileItIsTheSame) {
  EXPECT_EQ(files_.sha256(path_), std::nullopt);
  remember();
  EXPECT_EQ(files_.sha256(path_), "hash");
}

TEST_F(KnownFilesTest, OneThatWasWrittenIsNot) {
  remember();
  const auto time = std::filesystem::last_write_time(path_);
  write("other ones");  // as many bytes
  std::filesystem::last_write_time(path_, time);
  EXPECT_EQ(files_.sha256(path_), std::nullopt);
}

TEST_F(KnownFilesTest, OneThatAnotherStandsInForIsNot) {
  remember();
  const std::filesystem::path other = path_.string() + "-other";
  std::ofstream(other) << "other ones";
  std::filesystem::rename(other, path_);
  EXPECT_EQ(files_.sha256(path_), std::nullopt);
}

TEST_F(KnownFilesTest, OneThatIsGoneIsNot) {
  remember();
  std::filesystem::remove(path_);
  EXPECT_EQ(files_.sha256(path_), std::nullopt);
  EXPECT_EQ(stampOf(path_), std::nullopt);
  EXPECT_EQ(stampOf(path_.parent_path()), std::nullopt);
}

TEST_F(KnownFilesTest, OneThatWasJustWrittenIsReadAgain) {
  files_.remember(path_, stampOf(path_), "hash");
  EXPECT_EQ(files_.sha256(path_), std::nullopt);
}

}  // namespace
}  // namespace telar::known_files_test
