#include "asset/material/images.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>

#include "asset/check/pointer.h"
#include "telar/codec.h"

namespace telar::asset {
namespace {

/// Of the texels, and of the textures that they are uploaded to: all mip levels are a third as large as the first.
std::uint64_t bytesOf(const ImageHeader& header, ImageUse use) {
  const std::uint64_t texels = std::uint64_t{header.width} * header.height * header.texelBytes;
  return texels + use.ways() * (texels + texels / 3);
}

/// More hold more scratch memory, and few models have more large images.
constexpr unsigned DECODERS_MAX = 4;

/// A limit, a lack of memory and a resolver that failed are no property of the image.
bool isOfImage(const Error& error) { return error.code.starts_with("E_"); }

/// Calls work(i) for each i below `count`, on this thread and others. @param tolerant whether the rest is done after
/// one that is damaged; where it is not, all below the first that throws are done still. @return what each has thrown
template <class Work>
std::vector<std::exception_ptr> eachOnThreads(std::size_t count, bool tolerant, const Work& work) {
  std::vector<std::exception_ptr> thrown(count);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> ended = false;
  const auto run = [&] {
    while (!ended) {
      const std::size_t i = next++;
      if (i >= count) return;
      try {
        work(i);
      } catch (const Error& error) {
        thrown[i] = std::current_exception();
        if (!tolerant || !isOfImage(error)) ended = true;
      } catch (...) {
        thrown[i] = std::current_exception();
        ended = true;
      }
    }
  };
  const std::size_t threads = std::min<std::size_t>({count, std::thread::hardware_concurrency(), DECODERS_MAX});
  std::vector<std::jthread> others;
  try {
    while (others.size() + 1 < threads) others.emplace_back(run);
  } catch (const std::system_error&) {
    // The machine has no thread to give: those that there are do it.
  }
  run();
  others.clear();
  return thrown;
}

}  // namespace

int ImageLoader::canonical(int image) const {
  const ImageSource& wanted = from_.document.images[static_cast<std::size_t>(image)];
  for (int i = 0; i < image; ++i) {
    const ImageSource& other = from_.document.images[static_cast<std::size_t>(i)];
    if (other.bufferView == wanted.bufferView && other.uri == wanted.uri) return i;
  }
  return image;
}

template <class Read>
auto ImageLoader::at(std::size_t image, const Read& read) {
  try {
    return read();
  } catch (Error& error) {
    if (!error.pointer) error.at(pointer("images", image));
    throw;
  }
}

/// Runs a step of an image that is used; of one that is not readable, missing is true where that is allowed.
template <class Step>
void ImageLoader::tolerating(std::size_t image, std::vector<bool>& missing, const Step& step) const {
  try {
    step();
  } catch (const Error& error) {
    if (!from_.tolerant || !isOfImage(error)) throw;
    missing[image] = true;
    from_.warnings.add("W_TEXTURE", "a texture is not drawn: " + std::string(error.what()) + " [" + error.code + "]",
                       error.pointer.value_or(pointer("images", image)));
  }
}

/// All headers come first: what the images take together is refused before one of them is decoded.
LoadedImages ImageLoader::load(const std::vector<ImageUse>& uses) const {
  LoadedImages out{std::vector<Image8>(uses.size()), std::vector<bool>(uses.size(), false)};
  std::vector<File> files(uses.size());
  double bytes = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    from_.cancel.check();
    if (uses[i].ways() > 0) {
      tolerating(i, out.missing, [&] { files[i] = open(i, uses[i], bytes); });
    } else if (canonical(static_cast<int>(i)) == static_cast<int>(i)) {
      probeUnused(i);
    }
  }
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (uses[i].ways() > 0 && !out.missing[i]) used.push_back(i);
  }
  const auto thrown = eachOnThreads(used.size(), from_.tolerant, [&](std::size_t at) {
    File file = std::move(files[used[at]]);
    out.images[used[at]] = decodeImage(file.bytes, from_.limits, from_.cancel);
  });
  for (std::size_t i = 0; i < used.size(); ++i) {
    tolerating(used[i], out.missing, [&] {
      at(used[i], [&] {
        if (thrown[i]) std::rethrow_exception(thrown[i]);
      });
    });
  }
  return out;
}

ImageLoader::File ImageLoader::open(std::size_t image, ImageUse use, double& bytesSoFar) const {
  const ImageSource& source = from_.document.images[image];
  const std::string where = pointer("images", image);
  File out;
  if (source.uri) {
    out.owned = from_.resources.fetch(*source.uri, where + "/uri");
    out.bytes = out.owned;
  } else {
    out.bytes = from_.resources.view(source.bufferView);
  }
  const ImageHeader header = at(image, [&] { return readImageHeader(out.bytes, from_.limits); });
  bytesSoFar += static_cast<double>(header.texelBytes) * header.width * header.height;
  checkSum("L_IMAGE_BYTES", static_cast<double>(from_.limits.imageBytes), bytesSoFar, where);
  from_.memory.charge(bytesOf(header, use), where);
  // A URI need not give a type; an image in a buffer view must, and the right one.
  const bool embedded = source.bufferView >= 0;
  if (source.mimeType != header.mimeType && (embedded || !source.mimeType.empty())) {
    from_.warnings.add("W_IMAGE_MIME",
                       "the image is " + header.mimeType + ", its mimeType says " + telar::quoted(source.mimeType),
                       where + "/mimeType");
  }
  return out;
}

void ImageLoader::probeUnused(std::size_t image) const {
  const ImageSource& source = from_.document.images[image];
  if (source.bufferView < 0) return;
  try {
    readImageHeader(from_.resources.view(source.bufferView), from_.limits);
  } catch (const Error& error) {
    from_.warnings.add("W_IMAGE", std::string("an image that no material uses is not readable: ") + error.code,
                       pointer("images", image));
  }
}

}  // namespace telar::asset
