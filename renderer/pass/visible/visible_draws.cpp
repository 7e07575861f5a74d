#include "pass/visible/visible_draws.h"

#include <algorithm>
#include <iterator>

#include "pass/model/part_extents.h"
#include "pass/plan/fragment_estimate.h"

namespace telar::pass {
namespace {

using visibility::DrawnMesh;
using visibility::Faces;

/// The look takes as long as this part of the shading, about. A scene that hides less is looked at again only after
/// some frames, for another camera may see another side.
constexpr double LEAST_HIDDEN = 0.1;
constexpr int FRAMES_WITHOUT = 15;
std::int64_t pixelsOf(const glm::ivec2& size) { return std::int64_t{size.x} * size.y; }

bool isMesh(const DrawItem& item) {
  return item.visible && !item.instances() && item.primitive->topology == Topology::kTriangles;
}

/// Some of the triangles of a draw in its order. @param shown  in any order
std::vector<std::uint32_t> inOrder(const std::vector<std::uint32_t>& farToNear,
                                   const std::vector<std::uint32_t>& shown) {
  std::vector<bool> isShown(farToNear.size());
  for (const std::uint32_t part : shown) isShown[part] = true;
  std::vector<std::uint32_t> parts;
  parts.reserve(shown.size());
  std::copy_if(farToNear.begin(), farToNear.end(), std::back_inserter(parts),
               [&isShown](std::uint32_t part) { return isShown[part]; });
  return parts;
}

/// Whether all that it draws is opaque and has depth.
bool hides(const DrawItem& item) { return !item.blend && !item.key.alphaMask && !item.key.alphaToCoverage; }

}  // namespace

std::size_t trianglesOf(const DrawItem& item) {
  if (item.primitive->topology != Topology::kTriangles) return 0;
  const std::size_t copies = item.instances() ? item.instances()->matrices.size() : 1;
  return PartLayout(*item.primitive).parts * copies;
}

Faces facesOf(const DrawItem& item) {
  if (item.bothSides) return Faces::kBoth;
  return item.mirrored != item.key.flipSided ? Faces::kClockwise : Faces::kCounterClockwise;
}

visibility::SampleGrid gridOf(const gl::Functions& gl, const glm::ivec2& size) {
  visibility::SampleGrid grid{size.x, size.y};
  for (GLuint i = 0; i < visibility::SAMPLES; ++i) gl.GetMultisamplefv(GL_SAMPLE_POSITION, i, &grid.places[i].x);
  return grid;
}

namespace {

DrawnMesh meshOf(const DrawItem& item, const frame::Camera& camera) {
  return {item.primitive->positions,    item.primitive->indices, glm::mat4(camera.view * item.node->world),
          glm::mat4(camera.projection), facesOf(item),           hides(item)};
}

}  // namespace

bool VisibleDraws::mayLook(const FramePlan& plan, const glm::ivec2& size, int samples) const {
  return use_ != Use::kNever && samples == visibility::SAMPLES && context_.capabilities().samplePlaces &&
         pixelsOf(size) <= MOST_PIXELS && std::any_of(plan.draws.opaque.begin(), plan.draws.opaque.end(), isMesh);
}

bool VisibleDraws::pays(GpuScene& scene) const {
  if (use_ == Use::kAlways) return true;
  if (!context_.capabilities().shadesHidden || count_.all < FEW_TRIANGLES) return false;
  if (scene.framesWithoutLook == 0) return true;
  --scene.framesWithoutLook;
  return false;
}

void VisibleDraws::find(const FramePlan& plan, GpuScene& scene, const glm::ivec2& size, int samples,
                        const CancelToken& cancel) {
  draws_.clear();
  count_ = {};
  for (const auto* list : plan.draws.shown()) {
    for (const DrawItem& item : *list) count_.all += trianglesOf(item);
  }
  std::vector<std::uint32_t> indices;
  if (mayLook(plan, size, samples) && pays(scene)) leaveOut(plan, scene, size, indices, cancel);
  for (const DrawItem& item : plan.draws.blended) {
    if (!item.farToNear || draws_.contains(&item)) continue;
    const FragmentEstimate estimate(*item.primitive, plan.camera.projection * plan.camera.view * item.node->world,
                                    size.x, size.y);
    add(item, *item.farToNear, estimate.atMost(scene.extents(*item.primitive).all), indices);
  }
  if (draws_.empty()) return;
  const gl::Functions& gl = context_.gl();
  if (!indices_) indices_ = gl::Buffer(gl);
  gl.BindVertexArray(0);  // an index buffer binds to the vertex array of the moment
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                indices.data(), GL_STREAM_DRAW);
  context_.check("visible triangles");
}

void VisibleDraws::leaveOut(const FramePlan& plan, GpuScene& scene, const glm::ivec2& size,
                            std::vector<std::uint32_t>& indices, const CancelToken& cancel) {
  std::vector<const DrawItem*> items;
  std::vector<DrawnMesh> meshes;
  for (const auto* list : plan.draws.shown()) {
    for (const DrawItem& item : *list) {
      if (!isMesh(item)) continue;
      items.push_back(&item);
      meshes.push_back(meshOf(item, plan.camera));
      meshes.back().hides = meshes.back().hides && list == &plan.draws.opaque;
    }
  }
  hidden_.look(gridOf(context_.gl(), size), meshes, cancel);
  for (std::size_t i = 0; i < items.size(); ++i) {
    visibility::VisibleTriangles visible = hidden_.visible(i, cancel);
    count_.pixels += visible.pixels;
    count_.hiddenPixels += visible.hiddenPixels;
    count_.hidden += trianglesOf(*items[i]) - visible.parts.size();
    if (items[i]->farToNear) {
      add(*items[i], inOrder(*items[i]->farToNear, visible.parts), visible.pixels, indices);
      continue;
    }
    draws_[items[i]] = {indices.size() * sizeof(std::uint32_t), std::move(visible.parts), visible.pixels};
    indices.insert(indices.end(), visible.indices.begin(), visible.indices.end());
  }
  if (count_.hiddenPixels < LEAST_HIDDEN * (count_.pixels + count_.hiddenPixels))
    scene.framesWithoutLook = FRAMES_WITHOUT;
  hidden_.release();
}

void VisibleDraws::add(const DrawItem& item, std::vector<std::uint32_t> parts, double fragments,
                       std::vector<std::uint32_t>& indices) {
  const std::vector<std::uint32_t>& own = item.primitive->indices;
  const std::size_t offset = indices.size() * sizeof(std::uint32_t);
  for (const std::uint32_t part : parts) {
    for (std::uint32_t corner = 3 * part; corner < 3 * part + 3; ++corner)
      indices.push_back(own.empty() ? corner : own[corner]);
  }
  draws_[&item] = {offset, std::move(parts), fragments};
}

void VisibleDraws::release() {
  hidden_.release();
  if (draws_.empty()) return;
  draws_.clear();
  const gl::Functions& gl = context_.gl();
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 0, nullptr, GL_STREAM_DRAW);
}

const VisibleParts* VisibleDraws::of(const DrawItem& item) const {
  const auto found = draws_.find(&item);
  return found == draws_.end() ? nullptr : &found->second;
}

}  // namespace telar::pass
