#pragma once
#include "gl/functions.h"
#include "pass/plan/draw_list.h"

namespace telar::pass {

/// What the picture is cleared with: transparent where the shot has no background colour. A colour is never tone
/// mapped: three.js clears with it.
glm::vec4 clearColor(const Shot& shot, bool linear);

/// Of the transmission target, premultiplied: in three.js 0.187 the linear background, half covered with white where
/// there is none.
glm::vec4 clearColorBehind(const Shot& shot, const ThreeTerms& three);

/// Whether glass is seen through to what lies behind a coloured background, as in releases whose buffer behind glass
/// has no background.
bool piercesColor(const FramePlan& plan, const Shot& shot);

/// Whether a pass draws a background on the whole picture. A colour behind an average is composed at the end. Without
/// perspective the environment's cube covers a part of the picture, as in three.js.
bool fillsBackground(const FramePlan& plan, const Shot& shot);

/// What is behind all that is drawn.
struct Behind {
  bool opaque;      ///< its alpha is not drawn: until the picture is read, alpha is the coverage of what is in front
  glm::vec4 color;  ///< that the target is cleared with
};

/// A colour behind an average is composed at the end; backgrounds have no debug output.
Behind behindOf(const FramePlan& plan, const Shot& shot);

/// Clears all of the target that is bound.
void clearTarget(const gl::Functions& gl, const glm::vec4& color);
/// Whether draws write alpha.
void writeAlpha(const gl::Functions& gl, bool write);

}  // namespace telar::pass
