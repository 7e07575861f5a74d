#pragma once
#include <algorithm>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "telar/codec.h"
#include "telar/luminance.h"
#include "telar/motion.h"
#include "telar/part_query.h"
#include "telar/shading.h"
#include "telar/shot/camera.inc"
#include "telar/shot/debug_output.inc"
#include "telar/shot/environment.inc"
#include "telar/shot/environment_background.inc"
#include "telar/shot/flat.inc"
#include "telar/shot/ground.inc"
#include "telar/shot/layer.inc"
#include "telar/shot/lens.inc"
#include "telar/shot/light.inc"
#include "telar/shot/passes.inc"
#include "telar/shot/raster_quality.inc"
#include "telar/shot/reference_quality.inc"
#include "telar/shot/size.inc"
#include "telar/shot/values.inc"

namespace telar {

using shot::DebugOutput;
using shot::Layer;
using Style = shot::Values::Style;
using shot::ToneMapping;
using Projection = shot::Camera::Projection;
using Resolve = shot::RasterQuality::Resolve;

/// A resolved shot: the JSON that js/shot's resolveShot wrote, every default in it. C++ has no defaults of its own.
/// Keys of one kind are members of the structs of telar/shot/, which js/shot/table declares; here stand those that
/// may be of several kinds. Values are in their ranges: resolveShot has seen to that.
struct Shot : shot::Size, shot::Values, shot::RasterQuality {
  static constexpr int SAMPLES_OF_A_PASS = shot::SAMPLES_OF_A_PASS;

  using Camera = shot::Camera;
  using Lens = shot::Lens;
  using Light = shot::Light;
  using Ground = shot::Ground;
  using Reference = shot::ReferenceQuality;

  Camera camera;             ///< world, metres
  std::optional<Lens> lens;  ///< what it does to the exposure is in `exposure`; all is sharp without a focusDistance

  struct Environment : shot::Environment {
    enum class Source { kNone, kStudio, kPath, kBytes } source = Source::kNone;
    std::string path;
  } environment;

  std::vector<Light> lights;
  std::size_t suns = 0;  ///< of the lights, the last ones: small lights of the environment (pass::withSuns())

  struct Background : shot::EnvironmentBackground {
    enum class Type { kTransparent, kColor, kEnvironment } type = Type::kTransparent;
    glm::vec3 color{0};  ///< linear Rec.709
  } background;

  std::optional<Ground> ground;  ///< a level rectangle that shows nothing but shadows

  ShadingModel shading = ShadingModel::kThree;
  ShadingTerms terms;                  ///< of a principled shading
  ThreeTerms three;                    ///< of kThree
  std::optional<Reference> reference;  ///< set = the path tracer draws, not the raster
  bool isHigh = false;                 ///< quality "high" by its name: tracedInstead() says which of the two draws it
  std::optional<Pose> pose;            ///< none = as the file stands
  std::vector<Layer> layers;           ///< beside the colour
  /// A part that is drawn translucent.
  struct Ghost {
    PartQuery part;
    float opacity = 1;  ///< 0 = it is left out
  };
  std::vector<Ghost> ghost;
  /// Of Style::kFlat and Layer::kLine.
  struct Flat : shot::Flat {
    std::vector<PartQuery> stitched;  ///< whose seams are stitches
  } flat;
  OutputOptions output;
  /// Drawn in place of the colour; for a raw output of 32 bits. Key `debugOutput` of the JSON, which
  /// resolveShot does not write: `renderQuantity` does.
  DebugOutput debugOutput = DebugOutput::kNone;

  bool hasLayer(Layer layer) const { return std::find(layers.begin(), layers.end(), layer) != layers.end(); }

  /// Whether lines are all that it shows.
  bool isLinesAlone() const {
    return style == Style::kFlat &&
           std::all_of(layers.begin(), layers.end(), [](Layer layer) { return layer == Layer::kLine; });
  }
};

/// Whether it gives light anywhere.
inline bool shines(const Shot::Light& light) {
  return shines(light.color, light.intensity) ||
         (light.type == Shot::Light::Type::kHemisphere && shines(light.groundColor, light.intensity));
}

/// @throws Error{E_SHOT} naming the path of a missing or wrong key (a resolved shot has them all).
Shot parseShot(std::string_view resolvedJson);

}  // namespace telar
