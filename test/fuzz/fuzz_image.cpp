// An image file, PNG, JPEG, WebP or KTX2 by its magic bytes, as decodeImage() takes it. Whatever is no Error of telar
// ends the program.
#include <cstdint>
#include <span>

#include "telar/codec.h"
#include "telar/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  telar::Limits limits;
  // Large pictures take time and find nothing more.
  limits.imagePixels = 1 << 20;
  try {
    telar::decodeImage(std::as_bytes(std::span(data, size)), limits, {});
  } catch (const telar::Error&) {
  }
  return 0;
}
