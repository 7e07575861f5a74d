#pragma once
#include <glm/glm.hpp>

#include "brdf/shading.h"
#include "reference/geometry.h"
#include "reference/texture_read.h"

namespace telar::reference {

/// Rays of the pixels to the right and above, by which a surface knows how wide a pixel is.
struct Footprint {
  Ray right, above;
  glm::mat3 toView{1.0f};  ///< world to view directions
};

/// What a transmissive surface does to the light that comes through it.
struct Glass {
  float weight = 0;  ///< of what comes through, in place of the diffuse lobe, 0..1
  float ior = 1.5f, dispersion = 0;
  glm::vec3 thickness{0};  ///< metres by axis of the world; 0 = thin
  bool attenuates = false;
  glm::vec3 attenuationColor{1};  ///< of white light after attenuationDistance
  float attenuationDistance = 0;  ///< metres
};

/// A point of a surface with its material read.
struct Surface {
  glm::vec3 position{0};
  glm::vec3 geometricNormal{0};                     ///< unit, on the viewer's side
  brdf_f::SurfaceInfo info;                         ///< not set where the surface is unlit
  const brdf_f::ShadingVariant* shading = nullptr;  ///< of `info`; none where the surface is unlit
  Glass glass;
  glm::vec3 emitted{0};
  float distance = 0;          ///< along the ray that met it, metres
  float occlusion = 1;         ///< baked, of light from everywhere, 0..1
  bool hasVisibility = false;  ///< of its vertices, in `info`
  bool unlit = false;          ///< `emitted` is all there is
  int shells = 0;              ///< culled back sides that the ray passed closely before it
};

/// What the raster's shaders take from factors, textures and vertices, for a hit of a ray that is shown. World space.
/// @param footprint  camera rays only: adds the geometric roughness of three.js
/// @param three      the release of three.js, of the shading kThree
/// @param terms      of a principled shading, which takes roughness as authored; null for the others
/// @param baked      reads baked occlusion and ambient visibility; else nothing is hidden
Surface surfaceAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit, const Ray& ray,
                  const Footprint* footprint, const ThreeTerms& three, const ShadingTerms* terms = nullptr,
                  bool baked = true);

/// Asks the memory for what surfaceAt() will read of a hit. Each is to be there before the next one is asked for.
void prefetchTriangle(const PlacedMesh& mesh, const Hit& hit);
void prefetchVertices(const PlacedMesh& mesh, const Hit& hit);
void prefetchTexels(const Textures& textures, const PlacedMesh& mesh, const Hit& hit);

/// What decides whether a hit is seen, without the rest of the material.
struct Meeting {
  bool front = true;  ///< the side that the triangle's winding shows
  bool shown = true;  ///< false: a culled back side, or cut out by the alpha mask
  float alpha = 1;    ///< 1 where the material is not blended
};
/// @param direction  of the ray
Meeting meetingAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit, const glm::vec3& direction);

/// Share of light that comes through what transmits, in place of the diffuse lobe, 0..1.
float transmissionAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit);

/// Whether a ray ends at a hit: on a side that is shown, where the material is at least as opaque as `alpha`.
bool endsAt(const Textures& textures, const PlacedMesh& mesh, const Hit& hit, const glm::vec3& direction, float alpha);

}  // namespace telar::reference
