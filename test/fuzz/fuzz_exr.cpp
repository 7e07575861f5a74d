// A .exr environment, as readEnvironment() takes it: what telar checks of it, then OpenImageIO. Whatever is no Error of
// telar ends the program.
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "telar/codec.h"
#include "telar/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (!std::string_view(reinterpret_cast<const char*>(data), size).starts_with("\x76\x2f\x31\x01")) return 0;
  setenv("TELAR_LIBRARY_DIR", TELAR_OIIO_FOLDER, 0);
  telar::Limits limits;
  limits.environmentPixels = 1 << 14;
  try {
    telar::readEnvironment(std::as_bytes(std::span(data, size)), limits, {});
  } catch (const telar::Error&) {
  }
  return 0;
}
