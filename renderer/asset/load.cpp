#include "telar/load.h"

#include <new>

#include "asset/assemble.h"
#include "core/sha256.h"

namespace telar {
namespace {

using namespace asset;

std::shared_ptr<const Scene> load(std::span<const std::byte> file, ModelFolder* folder, const Limits& limits,
                                  const CancelToken& cancel) {
  cancel.check();
  Warnings warnings;
  const Container container = openContainer(file, limits, warnings);
  const Document document = readDocument(container, limits, cancel, warnings);
  Resources resources(document, container, folder, cancel);
  resources.loadBuffers(limits);
  const Accessors accessors(document, resources, cancel);
  accessors.check();
  Assembler assembler({document, resources, accessors, limits, cancel, warnings});
  auto scene = std::make_shared<Scene>(assembler.assemble());
  scene->fileBytes = file.size() + (folder ? folder->bytesRead() : 0);
  scene->sha256 = resources.sha256(file);
  scene->warnings = warnings.take();
  return scene;
}

std::string hash(std::span<const std::byte> file, ModelFolder* folder, const Limits& limits,
                 const CancelToken& cancel) {
  Warnings unheard;
  const Container container = openContainer(file, limits, unheard);
  const Document document = readDocument(container, limits, cancel, unheard);
  return Resources(document, container, folder, cancel).sha256(file);
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

}  // namespace

std::shared_ptr<const Scene> loadPath(const std::filesystem::path& file, const Limits& limits,
                                      const CancelToken& cancel) {
  return orOutOfMemory([&] {
    FileId id;
    const auto bytes = readModelFile(file, limits, cancel, id);
    ModelFolder folder(file, id, limits);
    return load(bytes, &folder, limits, cancel);
  });
}

std::shared_ptr<const Scene> loadBytes(std::span<const std::byte> file, const Limits& limits,
                                       const CancelToken& cancel) {
  return orOutOfMemory([&] { return load(file, nullptr, limits, cancel); });
}

std::string hashModel(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel) {
  return orOutOfMemory([&] {
    FileId id;
    const auto bytes = readModelFile(file, limits, cancel, id);
    ModelFolder folder(file, id, limits);
    return hash(bytes, &folder, limits, cancel);
  });
}

std::string hashModel(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel) {
  return orOutOfMemory([&] { return hash(file, nullptr, limits, cancel); });
}

std::string hashFile(const std::filesystem::path& file, const Limits& limits, const CancelToken& cancel) {
  return orOutOfMemory([&] {
    FileId id;
    return sha256Hex(readModelFile(file, limits, cancel, id));
  });
}

std::string hashFile(std::span<const std::byte> file) { return sha256Hex(file); }

}  // namespace telar
