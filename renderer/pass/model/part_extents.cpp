#include "pass/model/part_extents.h"

#include <algorithm>
#include <cmath>

namespace telar::pass {

PartLayout::PartLayout(const Primitive& primitive) {
  const std::size_t count = primitive.indices.empty() ? primitive.positions.size() : primitive.indices.size();
  switch (primitive.topology) {
    case Topology::kTriangles:
      step = 3;
      break;
    case Topology::kLines:
      step = 2;
      break;
    case Topology::kLineStrip:
    case Topology::kLineLoop:
      more = 1;
      break;
    case Topology::kPoints:
      break;
  }
  parts = count / step;
  if (primitive.topology == Topology::kLineStrip && parts > 0) --parts;
}

PartExtents::PartExtents(const Primitive& primitive) {
  const PartLayout layout(primitive);
  blocks.reserve((layout.parts + BLOCK - 1) / BLOCK);
  for (std::size_t part = 0; part < layout.parts; ++part) {
    if (part % BLOCK == 0) blocks.emplace_back();
    Extent& block = blocks.back();
    ++block.parts;
    if (layout.corners() == 1) continue;
    const glm::dvec3 first(cornerOf(primitive, layout, part, 0));
    const glm::dvec3 a = glm::dvec3(cornerOf(primitive, layout, part, 1)) - first;
    if (layout.corners() == 2) {
      block.diameters += glm::length(a);
      continue;
    }
    const glm::dvec3 b = glm::dvec3(cornerOf(primitive, layout, part, 2)) - first;
    block.area += glm::length(glm::cross(a, b)) * 0.5;
    block.diameters += std::sqrt(std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(a - b, a - b)}));
  }
  for (const Extent& block : blocks) {
    all.parts += block.parts;
    all.area += block.area;
    all.diameters += block.diameters;
  }
}

}  // namespace telar::pass
