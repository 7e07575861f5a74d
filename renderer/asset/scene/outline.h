#pragma once
#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "telar/cancel.h"
#include "telar/scene.h"

namespace telar::asset {

/// Collects points one by one and keeps those that lie farthest in each of 98 fixed directions: what a camera needs to
/// frame a model itself and not its box. The directions are those of js/shot/outline.mjs, which does the same for a
/// model in the browser.
class Outline {
 public:
  Outline();
  void add(const glm::dvec3& point);
  /// Without repeats; empty when nothing was added.
  std::vector<glm::dvec3> points() const;

 private:
  static constexpr std::size_t AXES = 49;  ///< one of each opposite pair
  /// Of two axes each: most points lie between what is known of all axes, which is seen of two at a time.
  using Two = double __attribute__((vector_size(16)));
  static constexpr std::size_t PAIRS = (AXES + 1) / 2;
  using Along = std::array<Two, PAIRS>;
  void widen(const glm::dvec3& point, const Along& along);

  Along x_{}, y_{}, z_{};  ///< of the axes; the one beyond the last is 0
  Along low_{}, high_{};
  std::array<glm::dvec3, AXES> lowest_{}, highest_{};
};

/// Of the drawn vertices in world space. Empty for a scene that draws nothing.
std::vector<glm::dvec3> outlineOf(const Scene& scene, const CancelToken& cancel);

}  // namespace telar::asset
