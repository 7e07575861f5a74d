#pragma once
#include <cstdint>

namespace telar {

/// What one input file may cost. Names in errors and in the JavaScript option `limits` are the L_* ones beside them.
struct Limits {
  std::uint64_t memoryBytes = 1536ull << 20;   ///< L_MEMORY_BYTES: of one model, its copies on the GPU included
  std::uint64_t fileBytes = 64ull << 20;       ///< L_FILE_BYTES: the model file, and each external file
  std::uint64_t externalBytes = 256ull << 20;  ///< L_EXTERNAL_BYTES: sum of the external files (path mode)
  std::uint64_t externalFiles = 256;           ///< L_EXTERNAL_FILES
  std::uint64_t jsonBytes = 16ull << 20;       ///< L_JSON_BYTES
  std::uint64_t jsonDepth = 64;                ///< L_JSON_DEPTH
  std::uint64_t jsonValues = 500'000;          ///< L_JSON_VALUES
  std::uint64_t nodes = 65'536;                ///< L_NODES
  std::uint64_t nodeDepth = 1024;              ///< L_NODE_DEPTH
  std::uint64_t drawCalls = 10'000;            ///< L_DRAW_CALLS: primitives over all visited nodes
  std::uint64_t vertices = 10'000'000;         ///< L_VERTICES: of primitives, morph targets, deformed copies
  std::uint64_t triangles = 20'000'000;       ///< L_TRIANGLES: and lines and points, sum over draws and their instances
  std::uint64_t buffers = 1024;               ///< L_BUFFERS
  std::uint64_t bufferViews = 65'536;         ///< L_BUFFER_VIEWS
  std::uint64_t meshoptBytes = 1ull << 30;    ///< L_MESHOPT_BYTES: sum of the decompressed buffer views
  std::uint64_t accessors = 65'536;           ///< L_ACCESSORS
  std::uint64_t materials = 4096;             ///< L_MATERIALS
  std::uint64_t textures = 4096;              ///< L_TEXTURES
  std::uint64_t images = 256;                 ///< L_IMAGES
  std::uint64_t imageDimension = 8192;        ///< L_IMAGE_DIMENSION: pixels on a side
  std::uint64_t imagePixels = 67'108'864;     ///< L_IMAGE_PIXELS: of one image
  std::uint64_t imageBytes = 1ull << 30;      ///< L_IMAGE_BYTES: decoded RGBA8, sum over images
  std::uint64_t imageScans = 64;              ///< L_IMAGE_SCANS: progressive JPEG scans
  std::uint64_t instances = 250'000;          ///< L_INSTANCES: sum over nodes
  std::uint64_t keyframeValues = 20'000'000;  ///< L_KEYFRAME_VALUES: times and numbers of all channels
  std::uint64_t morphTargets = 256;           ///< L_MORPH_TARGETS: of one primitive
  std::uint64_t lights = 64;                  ///< L_LIGHTS: the model's and the shot's
  std::uint64_t shadowTexels = 33'554'432;    ///< L_SHADOW_TEXELS: of all shadow maps of one render
  std::uint64_t textureUnits = 16;            ///< L_TEXTURE_UNITS: of one program with shadows, as in WebGL 2
  std::uint64_t environmentPixels = 8192ull * 4096;  ///< L_ENVIRONMENT_PIXELS: of a map, and at 2:1 by its longer side
  std::uint64_t programs = 64;                       ///< L_PROGRAMS: shader programs of one render
  std::uint64_t visibilityRays = 10'000'000'000;     ///< L_VISIBILITY_RAYS: of ambient visibility, over all vertices
  std::uint64_t fragments = 10'000'000'000;          ///< L_FRAGMENTS: of one pass over a picture, hidden ones too
};

}  // namespace telar
