#include "pass/visible/visibility_buffer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "gl/incomplete.h"
#include "gl/nearest_texture.h"
#include "pass/plan/varyings.h"
#include "pass/visible/visible_draws.h"

namespace telar::pass {
namespace {

using visibility::ShadingQuad;

constexpr std::size_t WIDTH = FragmentStrips::WIDTH;
constexpr std::size_t BLOCK = 4;               ///< texels on a side
constexpr std::size_t QUADS = 4;               ///< in a block
constexpr std::size_t BLOCKS = WIDTH / BLOCK;  ///< side by side
constexpr std::size_t STRIP_BLOCKS = FragmentStrips::ROWS / BLOCK * BLOCKS;
/// Floats that transform feedback writes for a vertex, at most: what each GL has, less the place.
constexpr std::size_t MOST_VARYINGS = 60;
/// Bytes of the vertices' outputs, and of the colours, at most.
constexpr std::size_t MOST_BYTES = 96u << 20;
/// Of so many quads one is looked at first.
constexpr std::size_t FIRST_LOOK = 61;

/// First texel of a quad.
glm::uvec2 texelOf(std::size_t block, std::size_t quad) {
  return {(block % BLOCKS) * BLOCK + (quad & 1) * 2, (block / BLOCKS) * BLOCK + (quad >> 1) * 2};
}

bool isPlain(const DrawItem& item) {
  const shader::VariantKey& key = item.key;
  return item.visible && !item.instances() && item.primitive->topology == Topology::kTriangles && !item.blend &&
         !key.alphaMask && !key.alphaToCoverage && !key.transmission && !key.layers;
}

/// Depths of the ground in the window. What lies above its horizon has depths beyond those that are drawn.
visibility::Plane groundDepths(const FramePlan& plan, const Shot& shot) {
  const glm::dmat4 toClip = plan.camera.projection * plan.camera.view;
  const glm::dvec4 plane = glm::transpose(glm::inverse(toClip)) * glm::dvec4(0, 1, 0, -shot.ground->position.y);
  const glm::dvec2 scale = 2.0 / glm::dvec2(shot.width, shot.height);
  const double half = -0.5 / plane.z;
  return {static_cast<float>(half * plane.x * scale.x), static_cast<float>(half * plane.y * scale.y),
          static_cast<float>(half * (plane.w - plane.x - plane.y) + 0.5)};
}

using Texel = std::uint8_t __attribute__((vector_size(4)));

visibility::Lanes channelsOf(std::uint32_t texel) {
  Texel bytes;
  std::memcpy(&bytes, &texel, sizeof bytes);
  return __builtin_convertvector(__builtin_convertvector(bytes, visibility::Mask), visibility::Lanes);
}

glm::vec4 meanOf(const std::array<glm::vec4, visibility::SAMPLES>& samples) {
  glm::vec4 sum(0);
  for (const glm::vec4& sample : samples) sum += sample;
  return sum / static_cast<float>(visibility::SAMPLES);
}

/// Of bytes, in floats, as llvmpipe resolves them: of two bytes that are as near it takes the same one.
std::uint32_t meanOf(const std::array<std::uint32_t, visibility::SAMPLES>& samples) {
  constexpr float UNIT = 1.0f / 255, SHARE = 1.0f / visibility::SAMPLES;
  // 1.5 * 2^23: a float of so much and n has no digits after the point, and n in its lowest bits.
  constexpr float ROUNDS = 12582912;
  visibility::Lanes sum{};
  for (const std::uint32_t sample : samples) sum += channelsOf(sample) * visibility::lanesOf(UNIT);
  const visibility::Lanes mean =
      sum * visibility::lanesOf(SHARE) * visibility::lanesOf(255) + visibility::lanesOf(ROUNDS);
  visibility::Mask bits;
  std::memcpy(&bits, &mean, sizeof bits);
  const Texel texel = __builtin_convertvector(bits, Texel);
  std::uint32_t bytes;
  std::memcpy(&bytes, &texel, sizeof bytes);
  return bytes;
}

std::size_t outputsOf(const DrawItem& item) { return 4 + componentsOf(varyingsOf(item.key)); }

}  // namespace

bool VisibilityBuffer::mayDraw(const FramePlan& plan, const Shot& shot, const FrameTarget& target) const {
  const gl::Capabilities& can = context_.capabilities();
  const bool ofFour = target.samples() == visibility::SAMPLES && can.samplePlaces;
  if (use_ == Use::kNever || !(ofFour || target.samples() == 1)) return false;
  if (std::int64_t{shot.width} * shot.height > MOST_PIXELS) return false;
  if (!can.bufferTextures) return false;
  // llvmpipe chooses one filter of the tables of area lights for several quads at once, and dense rows put other quads
  // together.
  if (plan.frame.lights.area() > 0 && !shot.mergeQuads) return false;
  const DrawList& draws = plan.draws;
  if (draws.opaque.empty() || !draws.transmissive.empty() || !draws.blended.empty()) return false;
  std::size_t triangles = 0, floats = 0;
  for (const DrawItem& item : draws.opaque) {
    if (!isPlain(item) || outputsOf(item) > MOST_VARYINGS + 4) return false;
    triangles += trianglesOf(item);
    floats += item.primitive->positions.size() * outputsOf(item);
  }
  if (floats * sizeof(float) > MOST_BYTES) return false;
  return use_ == Use::kAlways || (can.shadesHidden && triangles >= FEW_TRIANGLES);
}

void VisibilityBuffer::use(FramePlan& plan, bool yes) {
  for (DrawItem& item : plan.draws.opaque) {
    item.key.visibilityBuffer = yes;
    item.key.uvOf = yes ? sharedUvs(*item.material, item.key) : std::vector<std::uint8_t>();
  }
}

void VisibilityBuffer::begin(const FramePlan& plan, const Shot& shot, const FrameTarget& target) {
  count_ = {};
  first_ = plan.draws.opaque.data();
  asked_ = target.type();
  grid_ = target.samples() == 1 ? visibility::SampleGrid::ofOneSample(shot.width, shot.height)
                                : gridOf(context_.gl(), {shot.width, shot.height});
  captured_.clear();
  std::size_t floats = 0;
  for (const DrawItem& item : plan.draws.opaque) {
    captured_.push_back({floats, componentsOf(varyingsOf(item.key))});
    floats += item.primitive->positions.size() * outputsOf(item);
  }
  vertices_.resize(floats + 3);  // vectors of four are read at the end of a vertex
}

void VisibilityBuffer::capture(const DrawItem& item, GpuScene& gpu) {
  const gl::Functions& gl = context_.gl();
  const Captured& captured = captured_[indexOf(item)];
  const std::size_t vertices = item.primitive->positions.size();
  const auto bytes = static_cast<GLsizeiptr>(vertices * (captured.varyings + 4) * sizeof(float));
  if (bytes == 0) return;
  if (!outputs_) outputs_ = gl::Buffer(gl);
  gl.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, outputs_.get());
  gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, outputs_.get());
  gl.BindVertexArray(gpu.primitive(*item.primitive, nullptr).vertexArray.get());
  gl.Enable(GL_RASTERIZER_DISCARD);
  gl.BeginTransformFeedback(GL_POINTS);
  gl.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(vertices));
  gl.EndTransformFeedback();
  gl.Disable(GL_RASTERIZER_DISCARD);
  const void* from = gl.MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
  if (from) std::memcpy(vertices_.data() + captured.first, from, static_cast<std::size_t>(bytes));
  gl.UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  context_.check("outputs of the vertex stage");
}

bool VisibilityBuffer::find(const FramePlan& plan, const Shot& shot, const visibility::SampleOwners::Part& part,
                            const CancelToken& cancel) {
  meshes_.clear();
  for (const DrawItem& item : plan.draws.opaque) {
    const Captured& captured = captured_[indexOf(item)];
    meshes_.push_back({{vertices_.data() + captured.first, captured.varyings},
                       item.primitive->positions.size(),
                       item.primitive->indices,
                       facesOf(item),
                       !item.key.flatShaded});
  }
  if (!owners_.look(grid_, meshes_, part, cancel)) return false;
  if (plan.ground && !owners_.inFrontOf(groundDepths(plan, shot))) return false;
  quads_.find(owners_, {shot.mergeQuads, part.settled}, cancel);
  if (!arrange(plan)) return false;
  fillPlaces();
  if (!part.settled.empty()) return true;
  count_.triangles = owners_.triangles();
  count_.hidden = count_.triangles - quads_.shown();
  return true;
}

bool VisibilityBuffer::arrange(const FramePlan& plan) {
  const auto& all = quads_.all();
  ranges_.clear();
  std::size_t blocks = 0, layers = 0;
  for (std::size_t mesh = 0; mesh < all.size(); ++mesh) {
    const std::size_t count = (all[mesh].size() + QUADS - 1) / QUADS;
    const DrawItem& item = plan.draws.opaque[mesh];
    ranges_.push_back({blocks, blocks + count, item.mirrored == item.key.flipSided, factsOf(item.key)});
    blocks += count;
    count_.fragments += all[mesh].size() * 4;
    layers = std::max(layers, texelsOf(item.key));
  }
  const std::size_t rows = std::max<std::size_t>((blocks + BLOCKS - 1) / BLOCKS, 1) * BLOCK;
  if (rows > static_cast<std::size_t>(context_.capabilities().maxTextureSize) ||
      rows * WIDTH * sizeof(glm::vec4) > MOST_BYTES)
    return false;
  rows_ = rows;
  layers_ = layers;
  strips_.begin(layers);
  return true;
}

void VisibilityBuffer::fill(std::size_t strip, const visibility::FragmentTexels& out) const {
  const std::size_t begin = strip * STRIP_BLOCKS, end = begin + STRIP_BLOCKS;
  const auto firstRow = static_cast<unsigned>(strip * FragmentStrips::ROWS);
  const auto& all = quads_.all();
  for (std::size_t mesh = 0; mesh < all.size(); ++mesh) {
    const Range& range = ranges_[mesh];
    if (range.endBlock <= begin || range.firstBlock >= end) continue;
    const std::size_t facts = captured_[mesh].varyings;
    visibility::VaryingMixer mixer(meshes_[mesh], owners_.vertices(mesh), grid_.offset);
    const std::size_t first = (std::max(range.firstBlock, begin) - range.firstBlock) * QUADS;
    const std::size_t last = (std::min(range.endBlock, end) - range.firstBlock) * QUADS;
    for (std::size_t i = first; i < last; ++i) {
      // The last quad fills its block: what the GL shades at once rounds with its neighbours, and those of an earlier
      // picture may be anything.
      const ShadingQuad& quad = all[mesh][std::min(i, all[mesh].size() - 1)];
      const glm::uvec2 corner = texelOf(range.firstBlock + i / QUADS, i % QUADS) - glm::uvec2(0, firstRow);
      mixer.mix(quad, out, corner);
      if (range.facts == 0) continue;
      const bool isFront = ((quad.owners[0] & visibility::COUNTER_CLOCKWISE) != 0) == range.frontTurn;
      for (unsigned pixel = 0; pixel < 4; ++pixel) {
        const unsigned dx = pixel & 1, dy = pixel >> 1;
        const float told[FRAGMENT_FACTS] = {isFront ? 1.0f : 0.0f, static_cast<float>(quad.x + dx) + 0.5f,
                                            static_cast<float>(quad.y + dy) + 0.5f};
        for (std::size_t fact = 0; fact < range.facts; ++fact) {
          const std::size_t at = facts + fact;
          out.of({corner.x + dx, corner.y + dy}, at / 4)[at % 4] = told[fact];
        }
      }
    }
  }
}

float VisibilityBuffer::texelSteps(std::size_t draw, std::size_t uv, const glm::vec2& size, float few) const {
  visibility::VaryingSteps steps(meshes_[draw], owners_.vertices(draw), grid_.offset, uv);
  float least = std::numeric_limits<float>::infinity();
  const auto look = [&](std::size_t step) {
    const auto& quads = quads_.all()[draw];
    for (std::size_t i = 0; i < quads.size(); i += step) {
      const glm::vec2 texels = steps.of(quads[i]) * size;
      const float most = std::max(texels.x, texels.y);
      if (!(most >= few)) return false;  // nor where it is not a number
      least = std::min(least, most);
    }
    return true;
  };
  // Most draws that have fewer show it soon.
  return look(FIRST_LOOK) && look(1) ? least : 0;
}

void VisibilityBuffer::fillPlaces() {
  const visibility::Pixels& covered = owners_.covered();
  const std::size_t width = owners_.width(), pixels = owners_.pixels();
  surfaces_ = 0;
  for (std::size_t mesh = 0; mesh < ranges_.size(); ++mesh) {
    quads_.forEach(mesh, [&](const ShadingQuad& quad, std::size_t index) {
      const glm::uvec2 corner = texelOf(ranges_[mesh].firstBlock + index / QUADS, index % QUADS);
      for (unsigned pixel = 0; pixel < 4; ++pixel) {
        const unsigned samples = (quad.samples >> (4 * pixel)) & 15u, dx = pixel & 1, dy = pixel >> 1;
        if (samples == 0) continue;
        const std::size_t at = (quad.y + dy - static_cast<std::size_t>(covered.fromY)) * width + quad.x + dx -
                               static_cast<std::size_t>(covered.fromX);
        std::size_t surface = 0;
        while (surface < surfaces_ && places_[surface][at] != 0) ++surface;
        if (surface == surfaces_) places_[surfaces_++].assign(pixels, 0);
        places_[surface][at] = static_cast<std::uint32_t>(((corner.y + dy) * WIDTH + corner.x + dx) << 4) | samples;
      }
    });
  }
}

void VisibilityBuffer::bind() {
  const gl::Functions& gl = context_.gl();
  if (rows_ > held_ || type_ != asked_) {
    held_ =
        std::min(std::max(rows_ + rows_ / 4, held_), static_cast<std::size_t>(context_.capabilities().maxTextureSize));
    type_ = asked_;
    gl.ActiveTexture(GL_TEXTURE0);
    shaded_ =
        gl::nearestTexture(gl, type_ == PixelType::kRgba8 ? GL_RGBA8 : GL_RGBA32F, WIDTH, static_cast<int>(held_));
    target_ = gl::Framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target_.get());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shaded_.get(), 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      gl::failIncomplete(gl, "shaded fragments");
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, target_.get());
}

void VisibilityBuffer::draw(const DrawItem& item, const gl::Program& program, gl::DrawCost& cost, GLuint unit) {
  const Range& range = ranges_[indexOf(item)];
  if (range.firstBlock == range.endBlock) return;
  const gl::Functions& gl = context_.gl();
  program.set("varyingMap", static_cast<int>(unit));
  program.set("varyingTexels", static_cast<int>(layers_));
  if (!noVertices_) noVertices_ = gl::VertexArray(gl);
  gl.BindVertexArray(noVertices_.get());
  for (std::size_t from = range.firstBlock; from < range.endBlock;) {
    const std::size_t strip = from / STRIP_BLOCKS, stripEnd = (strip + 1) * STRIP_BLOCKS;
    const std::size_t firstRow = strip * FragmentStrips::ROWS, to = std::min(range.endBlock, stripEnd);
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    strips_.bind(strip, std::min(rows_ - firstRow, FragmentStrips::ROWS),
                 [&](const visibility::FragmentTexels& out) { fill(strip, out); });
    program.set("varyingRow", static_cast<int>(firstRow));
    drawBlocks(from, to, cost);
    if (to == stripEnd) gl.Flush();
    from = to;
  }
}

void VisibilityBuffer::drawBlocks(std::size_t from, std::size_t to, gl::DrawCost& cost) const {
  const gl::Functions& gl = context_.gl();
  // What is left of the first line of blocks, whole lines, the beginning of the last.
  while (from < to) {
    const std::size_t column = from % BLOCKS;
    const std::size_t lines = column == 0 ? (to - from) / BLOCKS : 0;
    const std::size_t blocks = lines > 0 ? BLOCKS : std::min(BLOCKS - column, to - from);
    const gl::Pacer::Rectangle part{static_cast<int>(column * BLOCK), static_cast<int>(from / BLOCKS * BLOCK),
                                    static_cast<int>(blocks * BLOCK),
                                    static_cast<int>(std::max<std::size_t>(lines, 1) * BLOCK)};
    gl.Viewport(part.x, part.y, part.width, part.height);
    context_.pacer().draw(cost, part.area(), part, [&] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
    from += lines > 0 ? lines * BLOCKS : blocks;
  }
}

void VisibilityBuffer::compose(telar::Frame& behind) {
  const std::size_t texels = rows_ * WIDTH;
  const gl::Functions& gl = context_.gl();
  bind();
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  if (type_ == PixelType::kRgba8) {
    shadedBytes_.resize(texels);
    gl.ReadPixels(0, 0, WIDTH, static_cast<GLsizei>(rows_), GL_RGBA, GL_UNSIGNED_BYTE, shadedBytes_.data());
  } else {
    shadedFloats_.resize(texels);
    gl.ReadPixels(0, 0, WIDTH, static_cast<GLsizei>(rows_), GL_RGBA, GL_FLOAT, shadedFloats_.data());
  }
  context_.check("readback of shaded fragments");
  if (surfaces_ == 0) return;
  const visibility::Pixels& covered = owners_.covered();
  const int right = std::min(covered.toX, static_cast<int>(behind.width) - 1);
  const int top = std::min(covered.toY, static_cast<int>(behind.height) - 1);
  for (int y = covered.fromY; y <= top; ++y) {
    const std::size_t at = static_cast<std::size_t>(y - covered.fromY) * owners_.width();
    const std::size_t row = behind.height - 1 - static_cast<std::size_t>(y);  // the GL's row 0 is the lowest one
    const std::size_t pixel = row * behind.width + static_cast<std::size_t>(covered.fromX);
    const auto count = static_cast<std::size_t>(std::max(right + 1 - covered.fromX, 0));
    if (type_ == PixelType::kRgba8) {
      composeRow(at, count, shadedBytes_, reinterpret_cast<std::uint32_t*>(behind.pixels.data()) + pixel);
    } else {
      composeRow(at, count, shadedFloats_, reinterpret_cast<glm::vec4*>(behind.pixels.data()) + pixel);
    }
  }
}

template <typename Pixel>
void VisibilityBuffer::composeRow(std::size_t at, std::size_t count, const std::vector<Pixel>& shaded,
                                  Pixel* pixel) const {
  for (const std::size_t end = at + count; at < end; ++at, ++pixel) {
    const std::uint32_t first = places_[0][at];
    if (first == 0) continue;
    if ((first & 15u) == 15u) {
      *pixel = shaded[first >> 4];
      continue;
    }
    std::array<Pixel, visibility::SAMPLES> samples;
    samples.fill(*pixel);
    for (std::size_t layer = 0; layer < surfaces_; ++layer) {
      const std::uint32_t place = places_[layer][at];
      if (place == 0) break;
      for (unsigned i = 0; i < visibility::SAMPLES; ++i) {
        if ((place >> i & 1u) != 0) samples[i] = shaded[place >> 4];
      }
    }
    *pixel = meanOf(samples);
  }
}

void VisibilityBuffer::release() {
  first_ = nullptr;
  count_ = {};
  meshes_.clear();
  outputs_.reset();
  if (memory() <= KEPT) return;
  owners_ = {};
  quads_ = {};
  vertices_ = {};
  strips_.release();
  shaded_.reset();
  target_.reset();
  held_ = 0;
  shadedBytes_ = {};
  shadedFloats_ = {};
  places_ = {};
}

std::size_t VisibilityBuffer::memory() const {
  std::size_t bytes = owners_.memory() + quads_.memory() + visibility::bytesOf(vertices_) +
                      visibility::bytesOf(shadedBytes_) + visibility::bytesOf(shadedFloats_);
  for (const auto& places : places_) bytes += visibility::bytesOf(places);
  return bytes;
}

}  // namespace telar::pass
