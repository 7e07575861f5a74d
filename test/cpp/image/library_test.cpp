#include <cstdlib>
#include <fstream>

#include "image/sample_files.h"

using namespace sample;

namespace {

/// True when a file whose name holds `name` is mapped into this process.
bool isMapped(const std::string& name) {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.find(name) != std::string::npos) return true;
  }
  return false;
}

}  // namespace

// Each test runs in a process of its own, so that no other has loaded the library.
TEST(LibraryDeathTest, EverydayFormatsDoNotLoadOpenImageIO) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto run = [] {
    useBuiltLibrary();
    const auto frame = frame8(16, 16);
    for (const auto format : {telar::OutputOptions::Format::kPng, telar::OutputOptions::Format::kJpeg,
                              telar::OutputOptions::Format::kWebp}) {
      telar::decodeImage(encoded(frame, format), {}, {});
    }
    std::exit(isMapped("libOpenImageIO") || isMapped("libtelar_oiio") ? 1 : 0);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}

TEST(LibraryDeathTest, SaysTheCureWhenItIsMissing) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto run = [] {
    setenv("TELAR_LIBRARY_DIR", "/nonexistent", 1);
    try {
      encoded(frame8(4, 4), telar::OutputOptions::Format::kTiff);
    } catch (const telar::Error& error) {
      const std::string message = error.what();
      const bool good = error.code == "X_LIBRARY_MISSING" && message.find("apt-get install") != std::string::npos &&
                        message.find("nonexistent") == std::string::npos;
      std::exit(good ? 0 : 2);
    }
    std::exit(1);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(0), "");
}
