// Included in a namespace where Real is the scalar type and `float` stands for it.
#include "../material/surface_types.glsl"

Reflected nothingReflected();

/// As three.js 0.187.
namespace three {
Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 compensation, vec3 l, vec3 lightColor);
Scattering dielectricScattering(SurfaceInfo s);
Reflected addDome(Reflected sum, SurfaceInfo s, Scattering dielectric, vec3 irradiance);
vec3 composedRadiance(SurfaceInfo s, vec3 diffuse, Reflected direct, Reflected indirect, vec3 emitted);
}  // namespace three
