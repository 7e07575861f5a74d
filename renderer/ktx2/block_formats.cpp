#include "ktx2/block_formats.h"

#include <algorithm>
#include <iterator>

namespace telar::ktx2 {
namespace {

/// By the values of VkFormat. ETC2 without sRGB is not among them: KTX2Loader refuses it.
constexpr BlockLayout LAYOUTS[] = {{131, "BC1", BlockFormat::kBc1Rgb, 4, 8, true},
                                   {132, "BC1", BlockFormat::kBc1Rgb, 4, 8, true},
                                   {133, "BC1 with alpha", BlockFormat::kBc1Rgba, 4, 8, true},
                                   {134, "BC1 with alpha", BlockFormat::kBc1Rgba, 4, 8, true},
                                   {137, "BC3", BlockFormat::kBc3, 4, 16, true},
                                   {138, "BC3", BlockFormat::kBc3, 4, 16, true},
                                   {139, "BC4", BlockFormat::kBc4, 4, 8, false},
                                   {140, "BC4 signed", BlockFormat::kBc4Signed, 4, 8, false},
                                   {141, "BC5", BlockFormat::kBc5, 4, 16, false},
                                   {142, "BC5 signed", BlockFormat::kBc5Signed, 4, 16, false},
                                   {145, "BC7", BlockFormat::kBc7, 4, 16, true},
                                   {146, "BC7", BlockFormat::kBc7, 4, 16, true},
                                   {148, "ETC2 RGB", BlockFormat::kEtc2Rgb, 4, 8, true},
                                   {152, "ETC2 RGBA", BlockFormat::kEtc2Rgba, 4, 16, true},
                                   {153, "EAC R11", BlockFormat::kEacR, 4, 8, false},
                                   {154, "EAC R11 signed", BlockFormat::kEacRSigned, 4, 8, false},
                                   {155, "EAC RG11", BlockFormat::kEacRg, 4, 16, false},
                                   {156, "EAC RG11 signed", BlockFormat::kEacRgSigned, 4, 16, false},
                                   {157, "ASTC 4x4", BlockFormat::kAstc4x4, 4, 16, true},
                                   {158, "ASTC 4x4", BlockFormat::kAstc4x4, 4, 16, true},
                                   {165, "ASTC 6x6", BlockFormat::kAstc6x6, 6, 16, true},
                                   {166, "ASTC 6x6", BlockFormat::kAstc6x6, 6, 16, true}};

}  // namespace

const BlockLayout* blockLayoutOf(std::uint32_t vkFormat) {
  const auto* found = std::find_if(std::begin(LAYOUTS), std::end(LAYOUTS),
                                   [&](const BlockLayout& layout) { return layout.vkFormat == vkFormat; });
  return found == std::end(LAYOUTS) ? nullptr : found;
}

}  // namespace telar::ktx2
