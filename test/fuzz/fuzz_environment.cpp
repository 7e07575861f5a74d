// A .hdr environment, as readEnvironment() takes it. Whatever is no Error of telar ends the program.
#include <cstdint>
#include <span>
#include <string_view>

#include "telar/codec.h"
#include "telar/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // What begins otherwise is for OpenImageIO, which is built without the fuzzer.
  if (!std::string_view(reinterpret_cast<const char*>(data), size).starts_with("#?")) return 0;
  telar::Limits limits;
  limits.environmentPixels = 1 << 18;
  try {
    telar::readEnvironment(std::as_bytes(std::span(data, size)), limits, {});
  } catch (const telar::Error&) {
  }
  return 0;
}
