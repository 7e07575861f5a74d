#include "oiio/srgb_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <memory>
#include <new>

namespace telar::oiio {
namespace {

// ICC.1:2010, 7.2.8: creation date and time, six big-endian 16-bit numbers.
constexpr std::size_t DATE_OFFSET = 24;
constexpr std::uint8_t DATE[12] = {0x07, 0xe8, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};  // 2024-01-01 00:00:00

}  // namespace

std::vector<std::uint8_t> srgbProfile() {
  const std::unique_ptr<void, decltype(&cmsCloseProfile)> profile(cmsCreate_sRGBProfile(), cmsCloseProfile);
  cmsUInt32Number size = 0;
  if (!profile || !cmsSaveProfileToMem(profile.get(), nullptr, &size)) throw std::bad_alloc();
  std::vector<std::uint8_t> bytes(size);
  if (!cmsSaveProfileToMem(profile.get(), bytes.data(), &size)) throw std::bad_alloc();
  // lcms2 writes the present time, which would make no two files alike.
  std::copy(std::begin(DATE), std::end(DATE), bytes.begin() + DATE_OFFSET);
  return bytes;
}

}  // namespace telar::oiio
