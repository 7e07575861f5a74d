#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "visibility/sample_owners.h"

namespace telar::visibility {

/// Two by two pixels of one triangle, which are shaded together: differences between them are the derivatives.
struct ShadingQuad {
  std::uint16_t x, y;      ///< of the lower left pixel, even
  std::uint16_t samples;   ///< that it shows: four bits a pixel, (0, 0) (1, 0) (0, 1) (1, 1) from the lowest
  bool counterClockwise;   ///< in the window
  std::uint32_t triangle;  ///< of its mesh
};

/// What of a view is shaded: each triangle in the pixels in which it owns a sample.
class ShadingQuads {
 public:
  /// Another view in place of this one. @throws Error{X_CANCELLED, X_TIMEOUT}
  void find(const SampleOwners& owners, const CancelToken& cancel);

  /// By mesh; those of one triangle one after the other.
  const std::vector<std::vector<ShadingQuad>>& all() const { return quads_; }
  /// Triangles that own a sample.
  std::size_t shown() const { return shown_; }
  std::size_t memory() const;

 private:
  void add(const SampleOwners& owners, int x, int y);
  void sort(std::vector<ShadingQuad>& quads, std::size_t triangles);
  void put(const SampleOwners& owners, Owner owner, int x, int y, std::uint16_t samples);

  std::vector<std::vector<ShadingQuad>> quads_;
  std::vector<std::uint32_t> ends_;  ///< of the triangles of a mesh in its quads
  std::vector<ShadingQuad> sorted_;
  std::size_t shown_ = 0;
};

}  // namespace telar::visibility
