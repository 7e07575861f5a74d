#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "telar/ambient.h"
#include "telar/cancel.h"
#include "telar/codec.h"
#include "telar/picture_facts.h"
#include "telar/progress.h"
#include "telar/scene.h"
#include "telar/shot.h"

/// The interface of libtelar_reference.so, the only library of ours that links Embree; renderer/trace loads it. C++
/// objects cross it, so both sides must be of one build: telar_reference_layout() tells. Exceptions never
/// cross it.
namespace telar {

/// Statistics of one frame.
struct TraceFacts {
  int threads = 0;
  int samples = 0;  ///< paths of a pixel, at most
  std::uint64_t triangles = 0, rays = 0;
  Ending end{};
  double hierarchyMs = 0, traceMs = 0;
  std::optional<PictureFacts> picture{};  ///< none where the environment is the background: it covers every pixel
};

/// A telar::Error, field by field.
struct TraceFailure {
  std::string code, message;
  std::optional<std::string> pointer;
  std::optional<LimitFact> limit;
};

struct TraceJob {
  const Scene& scene;
  const Shot& shot;           ///< with `reference` set
  const ImageF* environment;  ///< linear Rec.709; null where the shot has none
  const Limits& limits;
  const CancelToken& cancel;
  const Progress& progress;
  Frame frame{};
  TraceFacts facts{};
  std::optional<TraceFailure> failure{};  ///< set: there is no frame
};

/// Ambient occlusion of points.
struct AmbientJob {
  const Scene& scene;
  const Shot& shot;  ///< its variant and its shading
  std::span<const SurfacePoint> points;
  int threads;  ///< at least 1; the same numbers with any
  const CancelToken& cancel;
  std::vector<float> open{};              ///< of each point, 0..1
  std::optional<TraceFailure> failure{};  ///< set: there are none
};

/// A mesh that is drawn more often has the ambient visibility of so many of its places.
constexpr int VISIBILITY_PLACES = 8;

/// Whether any light reaches or leaves the back of a surface.
inline bool seenFromBehind(const Material& material) {
  return material.doubleSided || material.fabric.diffuseTransmissionFactor > 0;
}

/// Ambient visibility of vertices.
struct VisibilityJob {
  using Sides = decltype(Primitive::visibility);
  const Scene& scene;
  const Shot& shot;  ///< its variant and its shading
  int rays;          ///< of each side of a vertex, at least 1
  int threads;       ///< at least 1; the same numbers with any
  const CancelToken& cancel;
  std::map<const Primitive*, Sides>
      sides{};                            ///< of drawn triangle meshes; the back is empty where nothing comes from it
  std::optional<TraceFailure> failure{};  ///< set: there are none
};

/// Equal in two libraries of one build. It changes with the layout of the types that cross.
constexpr std::uint64_t traceLayout() {
  std::uint64_t layout = 3;  // raise it for a change that keeps every size
  for (const std::size_t size : {sizeof(Scene), sizeof(Shot), sizeof(Shot::Light), sizeof(Material), sizeof(Primitive),
                                 sizeof(Node), sizeof(Image8), sizeof(Limits), sizeof(TraceJob), sizeof(Frame),
                                 sizeof(AmbientJob), sizeof(SurfacePoint), sizeof(VisibilityJob)}) {
    layout = layout * 1000003 + size;
  }
  return layout;
}

}  // namespace telar

extern "C" {

using TelarReferenceLayoutFunction = std::uint64_t();
using TelarReferenceVersionFunction = const char*();
using TelarReferenceDrawFunction = void(telar::TraceJob*);
using TelarReferenceAmbientFunction = void(telar::AmbientJob*);
using TelarReferenceVisibilityFunction = void(telar::VisibilityJob*);

#ifdef TELAR_REFERENCE_PLUGIN
#define TELAR_REFERENCE_EXPORT __attribute__((visibility("default")))
TELAR_REFERENCE_EXPORT TelarReferenceLayoutFunction telar_reference_layout;
/// "Embree 3.13.5"; the text lives as long as the library
TELAR_REFERENCE_EXPORT TelarReferenceVersionFunction telar_reference_version;
TELAR_REFERENCE_EXPORT TelarReferenceDrawFunction telar_reference_draw;
TELAR_REFERENCE_EXPORT TelarReferenceAmbientFunction telar_reference_ambient;
TELAR_REFERENCE_EXPORT TelarReferenceVisibilityFunction telar_reference_visibility;
#endif

}  // extern "C"
