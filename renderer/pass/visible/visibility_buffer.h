#pragma once
#include <array>
#include <vector>

#include "gl/program.h"
#include "pass/model/gpu_scene.h"
#include "pass/plan/draw_list.h"
#include "pass/target/frame_target.h"
#include "pass/visible/fragment_strips.h"
#include "telar/renderer.h"
#include "visibility/quad_varyings.h"

namespace telar::pass {

/// Shades what is seen alone, in dense rows: the GL runs the vertex stage and hands its outputs over, the processor
/// finds the triangle of each sample and mixes its varyings, the GL shades these fragments, and their colours are put
/// to the samples. llvmpipe shades blocks of 4 by 4 pixels for each triangle, and those of a garment have a few pixels.
/// src: Burns & Hunt 2013, "The Visibility Buffer: A Cache-Friendly Approach to Deferred Shading"
class VisibilityBuffer {
 public:
  using Use = RendererOptions::LeaveOut;
  VisibilityBuffer(const gl::Context& context, Use use) : context_(context), use_(use), strips_(context) {}

  /// Whether passes over a picture may be drawn so: with four samples, or with one sample.
  bool mayDraw(const FramePlan& plan, const Shot& shot, const FrameTarget& target) const;
  /// Whether the fragments of a plan's opaque draws read their varyings from this. mayDraw()
  static void use(FramePlan& plan, bool yes);
  /// Begins a picture. @param target  is bound
  void begin(const FramePlan& plan, const Shot& shot, const FrameTarget& target);
  /// Runs the vertex stage of a draw of the plan's opaque list. Its program, of a captured key, and its uniforms are
  /// set.
  void capture(const DrawItem& item, GpuScene& gpu);
  /// Looks at what was captured, once or more.
  /// @param part  of the picture that is asked for
  /// @return false = it has to be drawn triangle by triangle
  /// @throws Error{X_CANCELLED, X_TIMEOUT}
  bool find(const FramePlan& plan, const Shot& shot, const visibility::SampleOwners::Part& part,
            const CancelToken& cancel);
  /// How far apart the texels are that neighbouring fragments of a draw read, at least.
  /// @param draw  index in the plan's opaque list
  /// @param uv  first component of the texture coordinates in the draw's varyings
  /// @param size  of the texture
  /// @param few  texels below which it does not matter
  /// @return texels; infinity where nothing of the draw is seen, 0 where there are fewer
  float texelSteps(std::size_t draw, std::size_t uv, const glm::vec2& size, float few) const;
  /// Two by two pixels of a draw that are shaded.
  std::size_t quads(std::size_t draw) const { return quads_.all()[draw].size(); }
  /// Makes the fragments the target.
  void bind();
  /// Shades what is seen of a draw of the plan's opaque list. Its program and its uniforms are set.
  void draw(const DrawItem& item, const gl::Program& program, gl::DrawCost& cost, GLuint unit);
  /// Puts what they have shaded in front of a picture. @param behind  of the target
  void compose(telar::Frame& behind);

  /// Of this picture, once it is found: triangles of its first pass, fragments of all.
  struct Count {
    std::size_t triangles = 0, hidden = 0, fragments = 0;
  };
  const Count& count() const { return count_; }

  /// Gives back what a picture takes, at its end, however it ends.
  class Frame {
   public:
    explicit Frame(VisibilityBuffer& buffer) : buffer_(buffer) {}
    ~Frame() { buffer_.release(); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

   private:
    VisibilityBuffer& buffer_;
  };

 private:
  /// Vertices of one draw.
  struct Captured {
    std::size_t first = 0;  ///< float
    std::size_t varyings = 0;
  };
  /// Fragments of one draw, in blocks of four by four: llvmpipe shades these at once.
  struct Range {
    std::size_t firstBlock = 0, endBlock = 0;
    bool frontTurn = false;  ///< front faces run counter-clockwise in the window
    std::size_t facts = 0;   ///< factsOf() its key
  };

  std::size_t indexOf(const DrawItem& item) const { return static_cast<std::size_t>(&item - first_); }
  bool arrange(const FramePlan& plan);
  void fill(std::size_t strip, const visibility::FragmentTexels& out) const;
  void fillPlaces();
  void drawBlocks(std::size_t from, std::size_t to, gl::DrawCost& cost) const;
  /// A row of what is covered. @param at  its first pixel in places_    @param pixel  the same of the picture
  template <typename Pixel>
  void composeRow(std::size_t at, std::size_t count, const std::vector<Pixel>& shaded, Pixel* pixel) const;
  void release();
  std::size_t memory() const;
  /// Bytes that are kept from picture to picture: of the processor's memory, and of the GL's.
  static constexpr std::size_t KEPT = 64u << 20;

  const gl::Context& context_;
  Use use_;
  const DrawItem* first_ = nullptr;
  visibility::SampleGrid grid_;
  gl::Buffer outputs_;
  std::vector<float> vertices_;
  std::vector<Captured> captured_;  ///< by draw
  std::vector<visibility::PlacedMesh> meshes_;
  visibility::SampleOwners owners_;
  visibility::ShadingQuads quads_;
  std::vector<Range> ranges_;  ///< by draw
  std::size_t layers_ = 0;     ///< texels of a fragment
  FragmentStrips strips_;
  std::size_t rows_ = 0;                                            ///< of fragments
  std::size_t held_ = 0;                                            ///< rows of shaded_
  PixelType asked_ = PixelType::kRgba8, type_ = PixelType::kRgba8;  ///< of the target, of shaded_
  gl::Texture shaded_;
  gl::Framebuffer target_;
  std::vector<std::uint32_t> shadedBytes_;
  std::vector<glm::vec4> shadedFloats_;
  std::size_t surfaces_ = 0;  ///< most of a pixel
  /// Of each pixel that may be covered: texel, and in the lowest four bits the samples that have its colour; 0 = none
  std::array<std::vector<std::uint32_t>, visibility::SAMPLES> places_;
  gl::VertexArray noVertices_;
  Count count_;
};

}  // namespace telar::pass
