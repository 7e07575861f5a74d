#pragma once
#include <map>
#include <span>
#include <vector>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/model/gpu_scene.h"
#include "pass/plan/draw_list.h"
#include "telar/renderer.h"
#include "visibility/hidden_triangles.h"

namespace telar::pass {

/// Below this many triangles a look at what is hidden costs what it saves: on llvmpipe 0.1 ms.
constexpr std::size_t FEW_TRIANGLES = 256;
/// Above this many pixels what is kept of samples takes more than 64 MiB of memory.
constexpr std::int64_t MOST_PIXELS = 2048 * 2048;

/// Of all its instances; 0 for points and lines.
std::size_t trianglesOf(const DrawItem& item);
visibility::Faces facesOf(const DrawItem& item);
/// Of the bound target. @pre  the GL tells where samples are
visibility::SampleGrid gridOf(const gl::Functions& gl, const glm::ivec2& size);

/// What a draw shows of its primitive: the triangles that own a sample, or all of them, in the order of the draw.
struct VisibleParts {
  std::size_t offset = 0;            ///< bytes into the buffer of indices
  std::vector<std::uint32_t> parts;  ///< of the primitive, as they are drawn
  double fragments = 0;              ///< that they shade, at most
};

/// How many triangles a frame has and how many of them it leaves out.
struct TriangleCount {
  std::size_t all = 0, hidden = 0;
  double pixels = 0, hiddenPixels = 0;  ///< that the others shade and those would, about; 0 where it did not look
};

/// Leaves triangles out that are hidden at every sample, where the GL would shade them all the same: llvmpipe (to Mesa
/// 22.3 at least) tests the depth of each of four samples before it shades, and shades where none is left too. The
/// picture keeps its bytes. Draws of instances are drawn in full, and hide nothing. Triangles that have an order of their
/// own (DrawItem::farToNear) are drawn in it.
class VisibleDraws {
 public:
  using Use = RendererOptions::LeaveOut;
  VisibleDraws(const gl::Context& context, Use use) : context_(context), use_(use) {}

  /// Looks at the draws of a picture, with the camera as it is now, where that pays. The target with its samples is bound.
  /// Where a scene hides little, the next frames of it are drawn in full. @throws Error{X_CANCELLED, X_TIMEOUT}
  void find(const FramePlan& plan, GpuScene& scene, const glm::ivec2& size, int samples, const CancelToken& cancel);
  /// Gives back what the draws of a picture take, at its end, however it ends. count() stays.
  class Frame {
   public:
    explicit Frame(VisibleDraws& draws) : draws_(draws) {}
    ~Frame() { draws_.release(); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

   private:
    VisibleDraws& draws_;
  };
  /// Null = draw all of it.
  const VisibleParts* of(const DrawItem& item) const;
  GLuint indices() const { return indices_.get(); }
  /// Of the last frame; `hidden` is 0 where it did not look.
  const TriangleCount& count() const { return count_; }

 private:
  bool mayLook(const FramePlan& plan, const glm::ivec2& size, int samples) const;
  bool pays(GpuScene& scene) const;
  /// @param indices  of the triangles that are left, appended
  void leaveOut(const FramePlan& plan, GpuScene& scene, const glm::ivec2& size, std::vector<std::uint32_t>& indices,
                const CancelToken& cancel);
  /// A draw of these triangles, in this order. @param indices  theirs, appended
  void add(const DrawItem& item, std::vector<std::uint32_t> parts, double fragments,
           std::vector<std::uint32_t>& indices);
  void release();

  const gl::Context& context_;
  Use use_;
  visibility::HiddenTriangles hidden_;
  std::map<const DrawItem*, VisibleParts> draws_;
  gl::Buffer indices_;
  TriangleCount count_;
};

}  // namespace telar::pass
