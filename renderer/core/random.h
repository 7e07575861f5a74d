#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace telar {

/// Uniform numbers of one sample of one pixel: the same on every machine and for any number of threads. Independent
/// from pixel to pixel; the samples of a pixel fill each pair of draws evenly (Sobol's points, scrambled), so that the
/// mean of many has no bias and an error that falls at least as that of independent numbers. src: Burley 2020,
/// "Practical Hash-based Owen Scrambling", JCGT 9(4); draws are padded by pairs as in section 3
class Random {
 public:
  Random(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
      : state_(mixed(mixed(seed) + pixel)), reversedSample_(reversed(sample)) {}

  /// Sample `i` after this one of the same pixel.
  Random after(int i) const {
    Random later = *this;
    later.reversedSample_ = reversed(reversed(reversedSample_) + static_cast<std::uint32_t>(i));
    return later;
  }

  /// Point of Sobol's sequence, [0, 1)^2, in 24 bits, not scrambled.
  static glm::vec2 sobolPoint(std::uint32_t index) {
    const std::uint32_t reversedIndex = reversed(index);
    return {unit(reversedIndex), unit(sobol(reversedIndex))};
  }

  /// [0, 1)
  float uniform() {
    const Pair pair = next();
    return unit(scrambled(reversed(pair.reversedIndex), pair.seedX));
  }
  /// [0, 1)^2
  glm::vec2 uniform2() {
    const Pair pair = next();
    return {unit(scrambled(reversed(pair.reversedIndex), pair.seedX)),
            unit(scrambled(reversed(sobol(pair.reversedIndex)), pair.seedY))};
  }

 private:
  /// Where the sample stands in a pair of draws: every pair has an order of its own, so that pairs do not go together.
  struct Pair {
    std::uint32_t reversedIndex, seedX, seedY;
  };
  Pair next() {
    state_ += 0x9e3779b97f4a7c15ull;
    const std::uint64_t seeds = mixed(state_), order = mixed(seeds);
    return {hashed(reversedSample_ + static_cast<std::uint32_t>(order)), static_cast<std::uint32_t>(seeds),
            static_cast<std::uint32_t>(seeds >> 32)};
  }

  static float unit(std::uint32_t x) { return static_cast<float>(x >> 8) * 0x1p-24f; }

  /// src: Steele et al. 2014, "Fast Splittable Pseudorandom Number Generators", the finaliser of SplitMix64
  static std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
  }
  /// The bits from the last to the first.
  static std::uint32_t reversed(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
    x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
    return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
  }
  /// A bit is turned round or not by all the bits below it.
  static std::uint32_t hashed(std::uint32_t x) {
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    return x ^ (x * 0x8d22f6e6u);
  }
  /// Owen's scrambling, where a bit is turned round by those above it: of a number whose bits are reversed.
  static std::uint32_t scrambled(std::uint32_t reversedX, std::uint32_t seed) {
    return reversed(hashed(reversedX + seed));
  }
  /// Second dimension of Sobol's points; the first is the index reversed. Its matrix is Pascal's triangle modulo 2,
  /// which is a product of five: each adds to the bits of one half of a word, a half word and so on those of the other.
  static std::uint32_t sobol(std::uint32_t reversedIndex) {
    std::uint32_t x = reversedIndex;
    x ^= x << 16;
    x ^= (x & 0x00ff00ffu) << 8;
    x ^= (x & 0x0f0f0f0fu) << 4;
    x ^= (x & 0x33333333u) << 2;
    x ^= (x & 0x55555555u) << 1;
    return x;
  }

  std::uint64_t state_;
  std::uint32_t reversedSample_;
};

}  // namespace telar
