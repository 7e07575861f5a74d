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
  /// By axis, which are looked at two at a time: most points lie between what is known of all. The one beyond the last
  /// is 0.
  using Along = std::array<double, AXES + 1>;
  void widen(const glm::dvec3& point, const Along& along);

  Along x_{}, y_{}, z_{}, low_{}, high_{};
  std::array<glm::dvec3, AXES> lowest_{}, highest_{};
};

/// Of the drawn vertices in world space. Empty for a scene that draws nothing.
std::vector<glm::dvec3> outlineOf(const Scene& scene, const CancelToken& cancel);

}  // namespace telar::asset
