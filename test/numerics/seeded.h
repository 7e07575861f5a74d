#pragma once
#include <cstdint>
#include <initializer_list>

namespace telar::numerics {

/// Random numbers of one point, from its number alone: a failing point is found again by it on every machine.
/// src: Steele, Lea & Flood 2014, "Fast Splittable Pseudorandom Number Generators", SplitMix64
class Seeded {
 public:
  explicit Seeded(std::uint64_t seed) : state_(seed * 0xd1342543de82ef95u + 0x2545f4914f6cdd1du) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// [0, 1)
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  std::uint64_t below(std::uint64_t count) { return bits() % count; }

  /// One of the edges with that chance, else between the lowest and the highest of [low, high].
  double edged(double low, double high, std::initializer_list<double> edges, double chanceOfEdge = 1.0 / 16) {
    if (chance(chanceOfEdge)) return edges.begin()[below(edges.size())];
    return between(low, high);
  }

 private:
  std::uint64_t state_;
};

}  // namespace telar::numerics
