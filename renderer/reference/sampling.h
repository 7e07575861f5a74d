#pragma once
#include <glm/glm.hpp>

/// Directions drawn for a lobe, and how likely they are. Local frame: z is the normal; directions are unit and point
/// away from the surface; pdfs are per steradian.
namespace telar::reference {

/// Two axes that are square with a unit vector: columns x, y, z = n.
/// src: Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1)
glm::mat3 basisAbout(const glm::vec3& n);

glm::vec3 sampleCosine(const glm::vec2& u);
float pdfCosine(float cosine);

glm::vec3 sampleSphere(const glm::vec2& u);
constexpr float PDF_SPHERE = 0.079577472f;  ///< 1 / (4 pi)

/// Microfacet normal of a GGX surface among those that v sees.
/// @param v  z > 0      @param alpha  widths along x and y, each > 0
/// src: Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"
glm::vec3 sampleVisibleNormal(const glm::vec3& v, const glm::vec2& alpha, const glm::vec2& u);

/// How likely l is when it is v reflected about sampleVisibleNormal(v). Integrates to 1 over the sphere of l.
/// src: Heitz 2018, "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), eq. 17
float pdfReflection(const glm::vec3& v, const glm::vec3& l, const glm::vec2& alpha);

/// Weight of the first of two ways that drew one sample each.
/// src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.13, the power heuristic
inline float powerHeuristic(float own, float other) {
  const float a = own * own, b = other * other;
  return a + b > 0 ? a / (a + b) : 0.0f;
}

}  // namespace telar::reference
