// The text of every shading; types are in shading_declarations.inl.
#include "../light/reflected.glsl"

namespace three {
#include "../shading/three.glsl"
}  // namespace three
