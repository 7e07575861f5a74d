#pragma once
#include <cstdint>
#include <vector>

namespace telar::oiio {

/// An ICC v4 profile of sRGB (IEC 61966-2-1), the same bytes in every call. @throws std::bad_alloc
std::vector<std::uint8_t> srgbProfile();

}  // namespace telar::oiio
