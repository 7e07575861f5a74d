#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "telar/codec.h"
#include "telar/motion.h"
#include "telar/shading.h"

namespace telar {

/// A quantity of the shading, in the order in which to look for the cause of a difference (shaders/debug_output.glsl).
enum class DebugOutput : std::uint8_t {
  kNone,
  kNormal,  ///< shading normal, view space
  kBaseColor,
  kAlpha,
  kMetallic,
  kPerceptualRoughness,  ///< floor and geometric roughness applied
  kF0,
  kNoV,
  kDfg,
  kRadiance,     ///< prefiltered environment along the reflection
  kIrradiance,   ///< ambient, hemisphere, environment
  kDirect,       ///< reflected light of punctual and area lights
  kIndirect,     ///< reflected light of everything else, after occlusion
  kTransmitted,  ///< light from behind, before the material's weight
  kLinear,       ///< before exposure and tone mapping
  kEncoded,      ///< as the picture has it
};

/// A resolved shot: the JSON that js/shot's resolveShot wrote, every default in it. C++ has no defaults of its own.
struct Shot {
  static constexpr int SAMPLES_OF_A_PASS = 4;  ///< the most that one pass over the model takes of a pixel

  int width = 0, height = 0;  ///< pixels

  struct Camera {
    bool perspective = true;
    glm::dvec3 position{0}, target{0}, up{0, 1, 0};  ///< world, metres
    double fovY = 0;                                 ///< degrees, vertical
    double height = 0;                               ///< metres, orthographic
    double near = 0, far = 0;
  } camera;

  /// Depth of field; what the lens does to the exposure is in `exposure`.
  struct Lens {
    double aperture = 0;       ///< f-number: focal length over the width of the opening
    double focusDistance = 0;  ///< metres along the view
  };
  std::optional<Lens> lens;  ///< none = all is sharp

  struct Environment {
    enum class Source { kNone, kStudio, kPath, kBytes } source = Source::kNone;
    std::string path;
    double intensity = 1;
    double rotation = 0;  ///< degrees about +Y, as scene.environmentRotation.y
  } environment;

  struct Light {
    enum class Type { kAmbient, kHemisphere, kDirectional, kPoint, kSpot, kRect, kDisk } type = Type::kAmbient;
    glm::vec3 color{1};        ///< linear Rec.709
    glm::vec3 groundColor{0};  ///< linear Rec.709, hemisphere
    double intensity = 1;
    glm::dvec3 position{0}, target{0};
    double range = 0;              ///< metres, 0 = infinite
    double angle = 0;              ///< outer half-angle, radians
    double penumbra = 0;           ///< 0..1
    double width = 0, height = 0;  ///< metres, rect
    double radius = 0;             ///< metres, disk
    bool castShadow = false;

    /// LightShadow of three.js 0.187, and its camera; read where castShadow is true.
    struct Shadow {
      int mapSize = 0;        ///< texels on a side
      double radius = 0;      ///< of the filter, texels
      double intensity = 0;   ///< part of the light that the shadow takes, 0..1
      double bias = 0;        ///< added to the depth 0..1 that is compared
      double normalBias = 0;  ///< metres along the normal to the point that is compared
      double near = 0, far = 0;
      double left = 0, right = 0, bottom = 0, top = 0;  ///< metres, directional
      double focus = 0;                                 ///< part of the cone's angle, spot
    } shadow;
  };
  std::vector<Light> lights;
  bool modelLights = true;

  struct Background {
    enum class Type { kTransparent, kColor, kEnvironment } type = Type::kTransparent;
    glm::vec3 color{0};  ///< linear Rec.709
    double blur = 0;     ///< 0..1, of the environment: scene.backgroundBlurriness of three.js
  } background;

  /// A level rectangle that shows nothing but shadows.
  struct Ground {
    double opacity = 0;      ///< of a full shadow
    glm::dvec3 position{0};  ///< its centre
    glm::dvec2 size{0};      ///< metres along x and z
  };
  std::optional<Ground> ground;

  ShadingModel shading = ShadingModel::kThree;
  ShadingTerms terms;          ///< of a principled shading
  std::string toneMapping;     ///< none linear reinhard cineon aces agx neutral
  double exposure = 1;         ///< factor on radiance, the lens's included
  int samples = 4;             ///< quality.samples: 1 or 4 in one pass, 16 to 1024 in several
  double noise = 0;            ///< standard error of a pixel, in 1/255, at which it takes no more of several passes
  bool linearResolve = false;  ///< samples are averaged before tone mapping and encoding
  int environmentSamples = 0;  ///< directions a pixel in which the environment is looked up; 0 = prefiltered maps

  /// Settings of the path tracer.
  struct Reference {
    enum class Transport : std::uint8_t {
      kGlobal,     ///< all light, over `bounces` reflections
      kOcclusion,  ///< light that arrives directly, less what surfaces hide
      kDirect,     ///< nothing hidden but by the shadows that the shot asks for: what the raster computes
    };
    int samples = 0;  ///< paths a pixel
    std::uint64_t seed = 0;
    Transport transport = Transport::kGlobal;
    int bounces = 0;
    int threads = 0;  ///< 0 = one for each core
  };
  std::optional<Reference> reference;  ///< set = the path tracer draws, not the raster
  std::string variant;                 ///< KHR_materials_variants name, empty = the file's own materials
  std::optional<Pose> pose;            ///< none = as the file stands
  OutputOptions output;
  /// Drawn in place of the colour; for a raw output of 32 bits. Key `debugOutput` of the JSON, which
  /// resolveShot does not write: for tests.
  DebugOutput debugOutput = DebugOutput::kNone;
};

/// @throws Error{E_SHOT} naming the path of a missing or wrong key (a resolved shot has them all).
Shot parseShot(std::string_view resolvedJson);

}  // namespace telar
