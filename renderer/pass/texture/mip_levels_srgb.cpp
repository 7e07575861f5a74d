#include <algorithm>
#include <cstddef>

#include "pass/texture/mip_levels.h"

#if defined(__x86_64__)
#include <immintrin.h>
#define TELAR_AVX2 __attribute__((target("avx2,fma")))
#endif

// The curves of sRGB as Mesa 22.3's llvmpipe approximates them (gallivm/lp_bld_format_srgb.c): a polynomial into light,
// and powers 3/8 and 1/2 back, by the CPU's approximate reciprocal roots. Its compiler joins products and sums where
// the CPU can.
namespace telar::pass {

#if defined(__x86_64__)
namespace {

/// Two texels of RGBA.
using Eight = __m256;

TELAR_AVX2 inline Eight all(float value) { return _mm256_set1_ps(value); }

/// Alpha's places among eight.
constexpr int ALPHA = 0x88;

/// @param bytes two texels @return light and alpha, [0, 1]
TELAR_AVX2 inline Eight decode(__m128i bytes) {
  const Eight x = _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(bytes));
  const Eight squared = _mm256_mul_ps(x, x);
  const Eight even = _mm256_fmadd_ps(squared, all(0.6935f / (255.0f * 255.0f)), all(0.0023f));
  const Eight odd = _mm256_fmadd_ps(squared, all(0.3012f / (255.0f * 255.0f * 255.0f)), all(0.0030f / 255.0f));
  const Eight curve = _mm256_fmadd_ps(odd, x, even);
  const Eight line = _mm256_mul_ps(x, all(1.0f / (12.6f * 255.0f)));
  const Eight light = _mm256_blendv_ps(curve, line, _mm256_cmp_ps(x, all(15), _CMP_LE_OQ));
  return _mm256_blend_ps(light, _mm256_mul_ps(x, all(1.0f / 255.0f)), ALPHA);
}

/// @return bytes, as integers
TELAR_AVX2 inline __m256i encode(Eight mean) {
  const Eight x = _mm256_min_ps(_mm256_max_ps(mean, all(0)), all(1));
  const Eight root = _mm256_mul_ps(x, _mm256_rsqrt_ps(x));
  const Eight power = _mm256_rsqrt_ps(_mm256_rsqrt_ps(_mm256_mul_ps(root, x)));
  const auto ofPower = static_cast<float>(0.675f * 1.0622 * 255.0f),
             ofRoot = static_cast<float>(0.325f * 1.0622 * 255.0f);
  const Eight rest = _mm256_fmadd_ps(all(ofRoot), root, all(-0.0620f * 255.0f));
  const Eight curve = _mm256_add_ps(_mm256_mul_ps(all(ofPower), power), rest);
  const Eight line = _mm256_mul_ps(x, all(12.92f * 255.0f));
  const Eight bytes = _mm256_blendv_ps(curve, line, _mm256_cmp_ps(x, all(0.0031308f), _CMP_LE_OQ));
  return _mm256_cvtps_epi32(_mm256_blend_ps(bytes, _mm256_mul_ps(x, all(255)), ALPHA));
}

TELAR_AVX2 inline Eight between(Eight from, Eight to) {
  return _mm256_add_ps(from, _mm256_mul_ps(all(0.5f), _mm256_sub_ps(to, from)));
}

/// Two texels of the next level from the 2 x 4 that they cover.
TELAR_AVX2 inline void halveTwo(__m128i upper, __m128i lower, std::uint8_t* out) {
  // Left ones of both pairs in the lower half of the register, right ones in the upper.
  constexpr int LEFT_THEN_RIGHT = 0xd8;
  const __m128i above = _mm_shuffle_epi32(upper, LEFT_THEN_RIGHT), below = _mm_shuffle_epi32(lower, LEFT_THEN_RIGHT);
  const Eight top = between(decode(above), decode(_mm_srli_si128(above, 8)));
  const Eight bottom = between(decode(below), decode(_mm_srli_si128(below, 8)));
  const __m256i bytes = encode(between(top, bottom));
  const __m128i words = _mm_packs_epi32(_mm256_castsi256_si128(bytes), _mm256_extracti128_si256(bytes, 1));
  _mm_storel_epi64(reinterpret_cast<__m128i*>(out), _mm_packus_epi16(words, words));
}

/// Four texels of a row; what a row of one or two lacks is its last.
TELAR_AVX2 inline __m128i four(const std::uint8_t* row, std::uint32_t x, std::uint32_t width) {
  if (x + 4 <= width) return _mm_loadu_si128(reinterpret_cast<const __m128i*>(row + std::size_t{4} * x));
  alignas(16) std::uint8_t texels[16];
  for (std::uint32_t i = 0; i < 4; ++i) {
    std::copy_n(row + std::size_t{4} * std::min(x + i, width - 1), 4, texels + std::size_t{4} * i);
  }
  return _mm_load_si128(reinterpret_cast<const __m128i*>(texels));
}

TELAR_AVX2 void halveRows(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, MipLevel& half) {
  const std::size_t row = std::size_t{4} * width;
  for (std::uint32_t y = 0; y < half.height; ++y) {
    const std::uint8_t* upper = texels + std::size_t{2} * y * row;
    const std::uint8_t* lower = height > 1 ? upper + row : upper;
    std::uint8_t* out = &half.texels[std::size_t{4} * half.width * y];
    std::uint32_t x = 0;
    for (; x + 2 <= half.width && width >= 4; x += 2, out += 8) {
      const auto at = [x](const std::uint8_t* line) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(line + std::size_t{8} * x));
      };
      halveTwo(at(upper), at(lower), out);
    }
    for (; x < half.width; x += 2) {
      std::uint8_t two[8];
      halveTwo(four(upper, 2 * x, width), four(lower, 2 * x, width), two);
      std::copy_n(two, x + 2 <= half.width ? 8 : 4, out);
    }
  }
}

}  // namespace

bool canHalveSrgb() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

void halveSrgb(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, MipLevel& half) {
  half.resize(std::max(1u, width / 2), std::max(1u, height / 2));
  halveRows(texels, width, height, half);
}

#else

bool canHalveSrgb() { return false; }

void halveSrgb(const std::uint8_t*, std::uint32_t, std::uint32_t, MipLevel&) {}

#endif

}  // namespace telar::pass
