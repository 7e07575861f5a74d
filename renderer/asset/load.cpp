#include "telar/load.h"

#include <new>

#include "asset/assemble.h"

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
  scene->warnings = warnings.take();
  return scene;
}

/// The limits bound what a file may ask for; a machine may still have less.
template <typename Load>
std::shared_ptr<const Scene> orOutOfMemory(const Load& run) {
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

}  // namespace telar
