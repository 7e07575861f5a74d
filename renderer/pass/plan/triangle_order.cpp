#include "pass/plan/triangle_order.h"

#include <algorithm>
#include <numeric>

#include "pass/model/part_extents.h"

namespace telar::pass {
namespace {

constexpr std::size_t CHECKED = 65536;  ///< triangles between two looks at the token

/// Of a triangle's middle: how near it is, by the distance from the eye, or along the view where there is none.
std::vector<float> nearness(const DrawItem& item, const frame::Camera& camera, const CancelToken& cancel) {
  const PartLayout layout(*item.primitive);
  const glm::mat4 toView(camera.view * item.node->world);
  std::vector<float> near(layout.parts);
  for (std::size_t part = 0; part < layout.parts; ++part) {
    if (part % CHECKED == 0) cancel.check();
    glm::vec3 middle(0);
    for (std::size_t corner = 0; corner < layout.corners(); ++corner)
      middle += cornerOf(*item.primitive, layout, part, corner) / 3.0f;
    const glm::vec3 seen(toView * glm::vec4(middle, 1));
    near[part] = camera.orthographic ? seen.z : -glm::dot(seen, seen);
  }
  return near;
}

}  // namespace

void orderTriangles(FramePlan& plan, const CancelToken& cancel) {
  for (DrawItem& item : plan.draws.blended) {
    if (!item.ordered) continue;
    const std::vector<float> near = nearness(item, plan.camera, cancel);
    std::vector<std::uint32_t> parts(near.size());
    std::iota(parts.begin(), parts.end(), 0u);
    std::stable_sort(parts.begin(), parts.end(),
                     [&near](std::uint32_t a, std::uint32_t b) { return near[a] < near[b]; });
    item.farToNear = std::make_shared<const std::vector<std::uint32_t>>(std::move(parts));
  }
}

}  // namespace telar::pass
