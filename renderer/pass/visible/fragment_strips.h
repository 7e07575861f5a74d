#pragma once
#include <array>
#include <functional>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "visibility/quad_varyings.h"

namespace telar::pass {

/// Varyings of the fragments of a pass, a strip of rows at a time: all at once would take about 100 bytes a fragment.
/// A few buffers take turns, so that the GL may shade one strip while the next is mixed. They are written where the
/// fragments read them, as textures of buffers: needs Capabilities::bufferTextures.
class FragmentStrips {
 public:
  static constexpr std::size_t WIDTH = 1024;  ///< fragments of a row
  static constexpr std::size_t ROWS = 16;     ///< of fragments in a strip

  explicit FragmentStrips(const gl::Context& context) : context_(context) {}

  /// Another pass. @param layers  texels of a fragment
  void begin(std::size_t layers);
  /// Binds a strip to the texture unit that is active.
  /// @param rows  of fragments that it has
  /// @param fill  writes its texels, from its first row on, where it is not known
  void bind(std::size_t strip, std::size_t rows, const std::function<void(const visibility::FragmentTexels&)>& fill);

  void release();

 private:
  static constexpr std::size_t TURNS = 4;

  struct Turn {
    gl::Buffer buffer;
    gl::Texture texture;
    std::size_t strip = 0;  ///< that it holds, from 1; 0 = none
  };
  void make(Turn& turn) const;

  const gl::Context& context_;
  std::size_t layers_ = 0;
  std::size_t held_ = 0;  ///< layers that the buffers have
  std::array<Turn, TURNS> turns_;
};

}  // namespace telar::pass
