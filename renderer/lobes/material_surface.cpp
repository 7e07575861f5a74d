#include "lobes/material_surface.h"

#include "brdf/material_inputs.h"

namespace telar::lobes {
brdf_d::SurfaceInfo surfaceOf(const Material& material, const Shot& shot, const glm::dvec3& v) {
  const bool principled = isPrincipled(shot.shading);
  auto m = materialInputs<brdf_d::MaterialInputs>(material, glm::vec3(material.baseColorFactor), shot.three,
                                                  [](const TextureRef&, bool) { return glm::vec4(1); });
  if (!principled) m = brdf_d::withShadedRoughness(m, 0);
  brdf_d::Normals normals{};
  normals.geometric = normals.shading = normals.coat = {0, 0, 1};
  normals.frame = glm::dmat3(1);
  normals.upward = 1;
  brdf_d::SurfaceInfo s = brdf_d::baseSurface(m, normals, v);
  if (material.physical) s = brdf_d::withSpecular(s, m);
  s = brdf_d::withLayers(s, m, normals);
  if (shot.shading == ShadingModel::kFabric && material.fabric.weave) s = brdf_d::withWeave(s, m, normals);
  if (principled) s.terms = shot.terms;
  s.dfg = brdf_d::splitSum(shot.three, s.perceptualRoughness, s.NoV);
  s.coatDfg = brdf_d::splitSum(shot.three, s.clearcoatRoughness, s.clearcoatNoV);
  return s;
}

}  // namespace telar::lobes
