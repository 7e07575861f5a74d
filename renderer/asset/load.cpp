#include "telar/load.h"

#include <new>

#include "asset/scene/assemble.h"
#include "core/sha256.h"

namespace telar {
namespace {

using namespace asset;

std::shared_ptr<const Scene> load(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                                  const LoadOptions& options) {
  cancel.check();
  Warnings warnings;
  MemoryBudget memory(limits.memoryBytes);
  const Container container = openContainer(file, limits, warnings);
  const Document document = readDocument(container, limits, cancel, warnings, options.tolerant);
  Resources resources(document, container, options.files, cancel);
  resources.loadBuffers(limits, memory);
  const Accessors accessors(document, resources, cancel);
  accessors.check();
  Assembler assembler({document, resources, accessors, limits, cancel, warnings, memory, options.tolerant, file,
                       options.decodesLater ? options.owner : nullptr});
  auto scene = std::make_shared<Scene>(assembler.assemble());
  scene->memoryBytes = memory.kept();
  scene->fileBytes = file.size() + (options.files ? options.files->bytesRead() : 0);
  scene->sha256 = resources.sha256(file);
  scene->warnings = warnings.take();
  return scene;
}

std::string hash(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                 const LoadOptions& options) {
  Warnings unheard;
  const Container container = openContainer(file, limits, unheard);
  const Document document = readDocument(container, limits, cancel, unheard, options.tolerant);
  return Resources(document, container, options.files, cancel).sha256(file);
}

/// The limits bound what a file may ask for; a machine may still have less.
template <typename Load>
auto orOutOfMemory(const Load& run) {
  try {
    return run();
  } catch (const std::bad_alloc&) {
    throw Error("X_MEMORY", "there is not enough memory to load the model");
  }
}

/// Reads the model file, whose folder has its parts where the caller does not give them.
template <typename Use>
auto withFolder(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel, LoadOptions options,
                const Use& use) {
  return orOutOfMemory([&] {
    FileId id;
    const auto bytes = std::make_shared<const std::vector<std::byte>>(readModelFile(file, limits, cancel, id));
    ModelFolder folder(file, id, limits);
    if (!options.files) options.files = &folder;
    options.owner = bytes;
    return use(*bytes, limits, cancel, options);
  });
}

}  // namespace

std::shared_ptr<const Scene> loadPath(const std::filesystem::path& file, const Limits& limits,
                                      const CancelToken& cancel, const LoadOptions& options) {
  return withFolder(file, limits, cancel, options, load);
}

std::shared_ptr<const Scene> loadBytes(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                                       const LoadOptions& options) {
  return orOutOfMemory([&] { return load(file, limits, cancel, options); });
}

std::string hashModel(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel,
                      const LoadOptions& options) {
  return withFolder(file, limits, cancel, options, hash);
}

std::string hashModel(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                      const LoadOptions& options) {
  return orOutOfMemory([&] { return hash(file, limits, cancel, options); });
}

std::string hashFile(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel) {
  return orOutOfMemory([&] {
    FileId id;
    return sha256Hex(readModelFile(file, limits, cancel, id));
  });
}

std::string hashFile(std::span<const std::byte> file) { return sha256Hex(file); }

}  // namespace telar
