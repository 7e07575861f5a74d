// A resolved shot as parseShot() takes it. JavaScript writes it, so that a wrong one is a fault of telar's own: an
// Error, and never worse.
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "json_mutator.h"
#include "telar/error.h"
#include "telar/shot.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  telar::fuzz::Random random(seed);
  const std::string json = telar::fuzz::changed(std::string(reinterpret_cast<const char*>(data), size), most, random);
  if (json.empty()) return LLVMFuzzerMutate(data, size, most);
  std::memcpy(data, json.data(), json.size());
  return json.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const telar::Shot shot = telar::parseShot(std::string_view(reinterpret_cast<const char*>(data), size));
#ifdef TELAR_PLANTED
    static volatile char values[2];
    if (shot.width < 16) values[shot.width + 2] = 1;
#endif
  } catch (const telar::Error&) {
  }
  return 0;
}
