// The files that ended a fuzzer's target once, one test for each: what is no Error of telar fails it.
#include <gtest/gtest.h>

#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using Target = int(const std::uint8_t*, std::size_t);
extern "C" {
Target fuzz_model, fuzz_image, fuzz_environment, fuzz_exr, fuzz_shot;
/// Of libFuzzer, for the mutators, which nobody calls here.
std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) { return size; }
}

namespace {

const std::filesystem::path FOLDER = std::filesystem::path(TELAR_SOURCE_DIR) / "test/fuzz/regressions";

/// Folders by the function that reads their files, as test/fuzz/CMakeLists.txt has it.
const std::map<std::string, Target*> TARGETS = {
    {"model", fuzz_model}, {"draco", fuzz_model}, {"meshopt", fuzz_model},           {"image", fuzz_image},
    {"ktx2", fuzz_image},  {"shot", fuzz_shot},   {"environment", fuzz_environment}, {"exr", fuzz_exr}};
/// Read by test/js/sheet/fuzz.test.mjs.
constexpr const char* OF_JAVASCRIPT = "spec";

std::vector<std::uint8_t> bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What a target throws at some bytes, if anything.
std::optional<std::string> faultOf(Target* target, const std::vector<std::uint8_t>& bytes) {
  try {
    target(bytes.data(), bytes.size());
    return std::nullopt;
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(Regressions, WhatFuzzersFoundIsRefusedOrTaken) {
  std::size_t files = 0;
  for (const auto& folder : std::filesystem::directory_iterator(FOLDER)) {
    const std::string name = folder.path().filename();
    if (name == OF_JAVASCRIPT) continue;
    ASSERT_TRUE(TARGETS.contains(name)) << name << " is no target";
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
      EXPECT_EQ(faultOf(TARGETS.at(name), bytesOf(file.path())), std::nullopt) << file.path();
      ++files;
    }
  }
  EXPECT_GT(files, 0u);
}

TEST(Regressions, EachTargetReadsWhatIsNothing) {
  for (const auto& [name, target] : TARGETS) EXPECT_EQ(faultOf(target, {}), std::nullopt) << name;
}

TEST(Regressions, PlantedFaultsAreTold) {
  const auto planted = [](const std::uint8_t*, std::size_t) -> int { throw std::runtime_error("planted"); };
  EXPECT_EQ(faultOf(planted, {}), "planted");
}

}  // namespace
