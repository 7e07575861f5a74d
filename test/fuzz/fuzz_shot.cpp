// A resolved shot as parseShot() takes it. JavaScript writes it, so that a wrong one is a fault of telar's own: an
// Error, and never worse. Most changes are made to a shot that was taken: a complaint hides those that come after it.
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "json_mutator.h"
#include "telar/error.h"
#include "telar/shot.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

constexpr std::size_t GOOD_MOST = 256;
/// Shots that were taken, the oldest given up first.
std::vector<std::string>& good() {
  static std::vector<std::string> shots;
  return shots;
}

void keepGood(std::string_view shot) {
  static std::size_t next = 0;
  if (good().size() < GOOD_MOST)
    good().emplace_back(shot);
  else
    good()[next++ % GOOD_MOST] = shot;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  telar::fuzz::Random random(seed);
  std::string from(reinterpret_cast<const char*>(data), size);
  if (!good().empty() && telar::fuzz::below(random, 5) != 0) from = good()[telar::fuzz::below(random, good().size())];
  const std::string json = telar::fuzz::changed(from, most, random);
  if (json.empty()) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, json.data(), json.size());
  return json.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const telar::Shot shot = telar::parseShot(text);
    keepGood(text);
#ifdef TELAR_PLANTED
    static volatile char values[2];
    if (shot.width < 16) values[shot.width + 2] = 1;
#endif
  } catch (const telar::Error&) {
  }
  return 0;
}
