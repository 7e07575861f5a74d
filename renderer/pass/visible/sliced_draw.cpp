#include "pass/visible/sliced_draw.h"

namespace telar::pass {
namespace {

// Vertices and set-up of a triangle against the shading of a fragment: on llvmpipe 131,000 triangles of two pixels each
// take as long as 1.5 million fragments in two triangles.
constexpr double FRAGMENTS_PER_PART = 8;

double workOf(const Extent& extent) { return static_cast<double>(extent.parts) * FRAGMENTS_PER_PART; }

}  // namespace

SlicedDraw::SlicedDraw(const gl::Context& context, gl::DrawCost& cost, const DrawItem& item, GpuScene& scene,
                       const glm::dmat4& worldToClip, const gl::Pacer::Rectangle& target, const VisibleDraws* visible)
    : context_(context),
      pacer_(context.pacer()),
      cost_(cost),
      item_(item),
      gpu_(scene.primitive(*item.primitive, item.instances())),
      extents_(scene.extents(*item.primitive)),
      estimate_(*item.primitive, worldToClip * item.node->world, target.width, target.height),
      layout_(*item.primitive),
      visible_(visible ? visible->of(item) : nullptr),
      visibleIndices_(visible ? visible->indices() : 0),
      target_(target) {}

void SlicedDraw::drawParts(std::size_t begin, std::size_t end, GLsizei instance) const {
  if (visible_) {
    constexpr std::size_t BYTES = sizeof(std::uint32_t);
    gpu_.drawOnly(context_.gl(), visibleIndices_, visible_->offset + begin * layout_.step * BYTES,
                  static_cast<GLsizei>((end - begin) * layout_.step));
    return;
  }
  gpu_.draw(context_.gl(), static_cast<GLint>(begin * layout_.step),
            static_cast<GLsizei>((end - begin) * layout_.step + layout_.more), instance, 1);
}

void SlicedDraw::run() {
  if (const Instances* instances = item_.instances()) {
    runInstances(*instances);
  } else {
    runParts(0);
  }
}

void SlicedDraw::runParts(GLsizei instance) {
  std::size_t begin = 0;
  double counted = 0;
  const auto drawTo = [&](std::size_t end) {
    if (end > begin) {
      pacer_.count(cost_, counted);
      drawParts(begin, end, instance);
    }
    begin = end;
    counted = 0;
  };
  const auto add = [&](std::size_t part) {
    const double fragments = estimate_.of(visible_ ? visible_->parts[part] : part) + FRAGMENTS_PER_PART;
    if (!pacer_.fits(cost_, counted + fragments)) {
      drawTo(part);
      pacer_.finish();
      if (!pacer_.fitsAlone(cost_, fragments)) {
        pacer_.draw(cost_, fragments, target_, [&] { drawParts(part, part + 1, instance); });
        begin = part + 1;
        return;
      }
    }
    counted += fragments;
  };
  std::size_t part = 0;
  const auto addBlock = [&](std::size_t parts, double fragments) {
    const std::size_t end = part + parts;
    const double most = static_cast<double>(parts) * FRAGMENTS_PER_PART + fragments;
    if (pacer_.fits(cost_, counted + most)) {
      counted += most;
      part = end;
    }
    for (; part < end; ++part) add(part);
  };
  if (visible_) {
    addBlock(visible_->parts.size(), visible_->fragments);
  } else {
    for (const Extent& block : extents_.blocks) addBlock(block.parts, estimate_.atMost(block));
  }
  drawTo(part);
}

void SlicedDraw::runInstances(const Instances& instances) {
  const auto count = static_cast<GLsizei>(instances.matrices.size());
  GLsizei begin = 0;
  double counted = 0;
  const auto drawTo = [&](GLsizei end) {
    if (end > begin) {
      pacer_.count(cost_, counted);
      gpu_.draw(context_.gl(), 0, gpu_.count, begin, end - begin);
    }
    begin = end;
    counted = 0;
  };
  for (GLsizei i = 0; i < count; ++i) {
    estimate_.moveTo(instances.matrices[static_cast<std::size_t>(i)]);
    const double work = workOf(extents_.all);
    double fragments = work + estimate_.atMost(extents_.all);
    if (!pacer_.fits(cost_, counted + fragments)) fragments = work + estimate_.all(cost_.fragments(pacer_.sliceMs()));
    if (!pacer_.fits(cost_, counted + fragments)) {
      drawTo(i);
      pacer_.finish();
      if (!pacer_.fitsAlone(cost_, fragments)) {
        runParts(i);
        begin = i + 1;
        continue;
      }
    }
    counted += fragments;
  }
  drawTo(count);
}

}  // namespace telar::pass
