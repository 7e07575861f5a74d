#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "telar/cancel.h"
#include "telar/limits.h"
#include "telar/scene.h"

namespace telar {

/// The files that a model names, wherever they lie.
class ExternalFiles {
 public:
  virtual ~ExternalFiles() = default;
  /// @param path  as the model names it: relative, percent-decoded, without ".."
  /// @param where JSON pointer of the uri
  /// @throws Error{E_URI_MISSING, E_URI_DENIED, L_FILE_BYTES, L_EXTERNAL_BYTES, L_EXTERNAL_FILES, X_CANCELLED, ...}
  virtual std::vector<std::byte> read(const std::string& path, const std::string& where, const CancelToken& cancel) = 0;
  /// Of all files so far.
  virtual std::uint64_t bytesRead() const = 0;
};

struct LoadOptions {
  /// A texture without a readable image, and an unknown extension that is required, are warnings: three.js draws
  /// without them.
  bool tolerant = false;
  /// In place of the model's folder: no file beside the model is opened. Null = by path its folder, from bytes none.
  ExternalFiles* files = nullptr;
  /// PNG, JPEG and WebP may be decoded beside the scene, once it is returned (waitForImages); not where `tolerant`.
  /// What is wrong with them is told then.
  bool decodesLater = false;
  /// Of the bytes that loadBytes() is given, which are needed until then; null = nothing is decoded later.
  std::shared_ptr<const void> owner;
};

/// Loads a .glb or .gltf by its magic bytes. External files are opened only beneath the model's folder: no absolute
/// path, no "..", no scheme, no symbolic link, regular files only.
/// @throws Error with a JSON pointer or a byte offset: kinds input, denied, unsupported, limit; X_CANCELLED.
std::shared_ptr<const Scene> loadPath(const std::filesystem::path& file, const Limits& limits,
                                      const CancelToken& cancel, const LoadOptions& options = {});

/// Same from memory; without options.files every external URI is denied (data: URIs are not external).
std::shared_ptr<const Scene> loadBytes(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                                       const LoadOptions& options = {});

/// SHA-256 of a model as 64 hex digits, without decoding it: of the file, and of the external parts that it names, by
/// their bytes. The same as loading gives in Scene::sha256.
/// @throws Error as loadPath() for a file that is no glTF document; X_CANCELLED
std::string hashModel(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel,
                      const LoadOptions& options = {});
std::string hashModel(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                      const LoadOptions& options = {});

/// SHA-256 of any file as 64 hex digits. @throws Error{E_FILE, L_FILE_BYTES, X_CANCELLED}
std::string hashFile(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel);
std::string hashFile(std::span<const std::byte> file);

/// Facts of a scene as one JSON object, for `telar inspect` and for resolveShot(shot, facts):
/// {bounds: {min, max} | null, outline: [[x, y, z], ...] (drawn vertices that lie farthest out, world space), size: [x,
/// y, z] metres, nodes, meshes, drawCalls, vertices, triangles, fileBytes, sha256,
///  materials: [{name, ...}], images: [{width, height}], lights: [...], variants: [...], extensionsUsed: [...],
///  cameras: [{name, node, projection, fovY?, aspectRatio?, height?, width?, near, far, position, target, up}]
///    (degrees, metres, world space; far null = infinite; target = the point on the view ray nearest to the centre;
///    those that the drawn scene places, in the file's order),
///  animations: [{name, duration}] (seconds, in the file's order), generator, copyright, warnings: [{code, message,
///  pointer?}]}
std::string describeScene(const Scene& scene, const CancelToken& cancel = {});

}  // namespace telar
