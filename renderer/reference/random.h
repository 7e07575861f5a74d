#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace telar::reference {

/// Independent uniform numbers of one sample of one pixel: the same on every machine and for any number of threads.
/// src: O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms", PCG-XSH-RR 64/32
class Random {
 public:
  Random(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample) {
    // A stream a pixel; samples are far apart within it.
    increment_ = (mixed(seed ^ (static_cast<std::uint64_t>(pixel) << 32 | sample)) << 1) | 1;
    state_ = mixed(increment_ + seed);
    next();
  }

  /// [0, 1)
  float uniform() { return static_cast<float>(next() >> 8) * 0x1p-24f; }
  glm::vec2 uniform2() {
    const float x = uniform();
    return {x, uniform()};
  }

 private:
  /// src: Steele et al. 2014, "Fast Splittable Pseudorandom Number Generators", the finaliser of SplitMix64
  static std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
  }
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ull + increment_;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto turn = static_cast<std::uint32_t>(old >> 59);
    return (shifted >> turn) | (shifted << ((32 - turn) & 31));
  }

  std::uint64_t state_ = 0, increment_ = 1;
};

}  // namespace telar::reference
