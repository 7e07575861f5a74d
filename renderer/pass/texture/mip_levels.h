#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>

#include "gl/context.h"
#include "telar/zeroed_bytes.h"

namespace telar::pass {

/// 8-bit RGBA texels, row by row.
struct MipLevel {
  std::uint32_t width = 0, height = 0;
  ZeroedBytes texels;

  /// What the texels are then is not defined.
  void resize(std::uint32_t newWidth, std::uint32_t newHeight) {
    width = newWidth;
    height = newHeight;
    texels.resize(std::size_t{4} * width * height);
  }
};

/// Whether the sides are powers of two, and not both 1: a GL meets the middle of two texels exactly.
bool halves(std::uint32_t width, std::uint32_t height);

/// The next smaller level, with the bytes of the generator of Mesa's llvmpipe. Linear texels are blended across and
/// then down in fixed point, each time rounded up. @param texels of a size that halves()
void halveLinear(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, MipLevel& half);
/// The same for texels in sRGB with linear alpha, which are blended in float, with llvmpipe's approximations of the
/// curves. Only where canHalveSrgb().
void halveSrgb(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, MipLevel& half);
/// The approximations rest on the CPU's own (AVX2, FMA), as llvmpipe's code does.
bool canHalveSrgb();

/// Makes mip levels, by the CPU where that gives the bytes of this context's GL: faster, and nothing to compile.
class MipMaker {
 public:
  using Halve = void (*)(const std::uint8_t*, std::uint32_t, std::uint32_t, MipLevel&);

  explicit MipMaker(const gl::Context& context);
  /// Fills all levels below level 0 of the bound texture, GL_RGBA8 or GL_SRGB8_ALPHA8.
  /// @param texels  level 0
  /// @param first  level of them that is level 0 of the texture, and filled too; above 0 where byCpu()
  void make(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, bool srgb, int first = 0);
  /// Whether this processor makes them.
  bool byCpu(std::uint32_t width, std::uint32_t height, bool srgb);
  /// Whether `halve` gives the bytes of this GL, on texels that meet every value of a byte.
  bool agrees(bool srgb, Halve halve) const;

 private:
  const gl::Context& context_;
  MipLevel made_, next_;
  std::optional<bool> linearAgrees_, srgbAgrees_;  ///< not known until a probe has told
};

}  // namespace telar::pass
