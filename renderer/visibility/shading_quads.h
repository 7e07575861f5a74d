#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/sample_owners.h"

namespace telar::visibility {

/// Two by two pixels of one surface, which are shaded together: differences between them are the derivatives.
struct ShadingQuad {
  std::uint16_t x, y;     ///< of the lower left pixel, even
  std::uint16_t samples;  ///< that it shows: four bits a pixel, (0, 0) (1, 0) (0, 1) (1, 1) from the lowest
  /// Triangle that each pixel shows, its number that of its mesh.
  std::array<Owner, 4> owners;
};

/// What of a view is shaded: each triangle in the pixels in which it owns a sample, or each surface.
class ShadingQuads {
 public:
  struct Wanted {
    /// Triangles that share a vertex and face the same way are one surface where they show in the same two by two
    /// pixels. In a pixel it shows the triangle with most samples of it.
    /// src: Fatahalian et al. 2010, "Reducing Shading on GPUs using Quad-Fragment Merging"
    bool merge = false;
    std::span<const std::uint8_t> settled;  ///< pixels that are not asked for, the upper row first; empty = none
  };
  /// Another view in place of this one. @throws Error{X_CANCELLED, X_TIMEOUT}
  void find(const SampleOwners& owners, const Wanted& wanted, const CancelToken& cancel);

  /// By mesh; those of one triangle one after the other.
  const std::vector<std::vector<ShadingQuad>>& all() const { return sorted_; }
  /// Calls visit(quad, its index in all()[mesh]), in the order of the rows of the window: what lies side by side there is near in
  /// memory.
  template <class Visit>
  void forEach(std::size_t mesh, const Visit& visit) const {
    const Found& found = found_[mesh];
    for (std::size_t i = 0; i < found.quads.size(); ++i) visit(found.quads[i], found.places[i]);
  }
  /// Triangles that own a sample.
  std::size_t shown() const { return shown_; }
  std::size_t memory() const;

 private:
  /// What one triangle owns of two by two pixels.
  struct Part {
    Owner owner;  ///< of the view
    std::uint16_t samples;
    std::uint16_t surface;  ///< number of the first part of its surface
    SampleOwners::Triangle triangle;
    unsigned in(unsigned pixel) const { return (samples >> (4 * pixel)) & 15u; }
    Owner ofMesh() const { return triangle.number | (owner & COUNTER_CLOCKWISE); }
  };
  void add(const SampleOwners& owners, int x, int y, bool merge);
  static bool isSettled(const SampleOwners& owners, std::span<const std::uint8_t> settled, int x, int y);
  void join(const SampleOwners& owners);
  void emit(int x, int y);
  void show(Owner owner);
  /// Of a mesh, in the order of the rows.
  struct Found {
    std::vector<ShadingQuad> quads;
    std::vector<std::uint32_t> places;  ///< in the sorted ones
  };
  void sort(std::size_t mesh, std::size_t triangles);

  std::vector<Found> found_;
  std::vector<std::vector<ShadingQuad>> sorted_;
  std::vector<Part> parts_;
  std::vector<std::uint8_t> isShown_;  ///< by triangle of the view
  std::vector<std::uint32_t> ends_;    ///< of the triangles of a mesh in its quads
  std::size_t shown_ = 0;
};

}  // namespace telar::visibility
