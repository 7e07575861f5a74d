#include "asset/material/images.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <string>
#include <string_view>
#include <thread>

#include "asset/check/pointer.h"
#include "asset/material/image_decoder.h"
#include "core/on_threads.h"
#include "core/sha256.h"

namespace telar::asset {
namespace {

constexpr std::string_view KTX2 = "image/ktx2";

std::uint64_t texelBytesOf(const ImageHeader& header) {
  return std::uint64_t{header.width} * header.height * header.texelBytes;
}

/// Of the texels, and of the textures that they are uploaded to: all mip levels are a third as large as the first.
std::uint64_t bytesOf(const ImageHeader& header, ImageUse use) {
  const std::uint64_t texels = texelBytesOf(header);
  return texels + use.ways() * (texels + texels / 3);
}

/// More hold more scratch memory, and few models have more large images.
constexpr unsigned DECODERS_MAX = 4;
/// Beside a scene: one core is left to what goes on with it, and scenes of several pictures may be on their way.
constexpr unsigned LATER_DECODERS_MAX = 2;

/// A browser decodes KTX2 where a texture has it by KHR_texture_basisu, and there nothing else: it shows neither.
void checkSource(const std::string& mimeType, ImageUse use) {
  const bool isKtx2 = mimeType == KTX2;
  const auto refuse = [](const std::string& what) {
    throw Error("E_IMAGE_FORMAT", what + ", which browsers do not show; export the model again");
  };
  if (isKtx2 && use.otherwise) refuse("the image is KTX2, and a texture has it without KHR_texture_basisu");
  if (!isKtx2 && use.byBasisu) refuse("the image is " + mimeType + ", and a texture has it by KHR_texture_basisu");
}

/// A limit, a lack of memory and a resolver that failed are no property of the image.
bool isOfImage(const Error& error) { return error.code.starts_with("E_"); }

/// Calls work(i) for each i below `count`, on this thread and others. @param tolerant whether the rest is done after
/// one that is damaged; where it is not, all below the first that throws are done still. @return what each has thrown
template <class Work>
std::vector<std::exception_ptr> eachOnThreads(std::size_t count, bool tolerant, const Work& work) {
  std::vector<std::exception_ptr> thrown(count);
  std::atomic<bool> ended = false;
  onThreads(count, std::min(std::thread::hardware_concurrency(), DECODERS_MAX), [&](std::size_t i) {
    if (ended) return;
    try {
      work(i);
    } catch (const Error& error) {
      thrown[i] = std::current_exception();
      if (!tolerant || !isOfImage(error)) ended = true;
    } catch (...) {
      thrown[i] = std::current_exception();
      ended = true;
    }
  });
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
LoadedImages ImageLoader::load(std::vector<ImageUse> uses) const {
  LoadedImages out{
      std::make_shared<std::vector<Image8>>(uses.size()), nullptr, std::vector<bool>(uses.size(), false), {}};
  std::vector<Image8>& images = *out.images;
  std::vector<File> files(uses.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    from_.cancel.check();
    if (uses[i].ways() > 0) {
      tolerating(i, out.missing, [&] { files[i] = open(i, uses[i]); });
    } else if (canonical(static_cast<int>(i)) == static_cast<int>(i)) {
      probeUnused(i);
    }
  }
  out.first = firstOfSameBytes(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (out.first[i] == i) continue;
    uses[out.first[i]].add(uses[i]);
    uses[i] = {};
    files[i] = {};
  }
  std::vector<std::size_t> used;
  std::vector<ImageDecoder::File> later;
  const bool waits = mayWait(files);
  double bytes = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (uses[i].ways() == 0 || out.missing[i]) continue;
    charge(i, files[i].header, uses[i], bytes);
    if (!waits) {
      used.push_back(i);
      continue;
    }
    images[i].width = files[i].header.width;
    images[i].height = files[i].header.height;
    images[i].format = files[i].header.format;
    std::shared_ptr<const void> owner = ownerOf(files[i]);
    later.push_back({i, pointer("images", i), std::move(owner), files[i].bytes});
  }
  if (!later.empty()) {
    out.pending =
        std::make_shared<ImageDecoder>(out.images, std::move(later), from_.limits, from_.cancel,
                                       std::clamp(std::thread::hardware_concurrency(), 2u, LATER_DECODERS_MAX + 1) - 1);
    return out;
  }
  const auto thrown = eachOnThreads(used.size(), from_.tolerant, [&](std::size_t at) {
    File file = std::move(files[used[at]]);
    images[used[at]] = decodeImage(file.bytes, from_.limits, from_.cancel);
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

ImageLoader::File ImageLoader::open(std::size_t image, ImageUse use) const {
  const ImageSource& source = from_.document.images[image];
  const std::string where = pointer("images", image);
  File out;
  if (source.uri) {
    out.owned = from_.resources.fetch(*source.uri, where + "/uri");
    out.bytes = out.owned;
  } else {
    out.bytes = from_.resources.view(source.bufferView);
  }
  out.header = at(image, [&] {
    ImageHeader header = readImageHeader(out.bytes, from_.limits);
    checkSource(header.mimeType, use);
    return header;
  });
  // A URI need not give a type; an image in a buffer view must, and the right one.
  const bool embedded = source.bufferView >= 0;
  if (source.mimeType != out.header.mimeType && (embedded || !source.mimeType.empty())) {
    from_.warnings.add("W_IMAGE_MIME",
                       "the image is " + out.header.mimeType + ", its mimeType says " + telar::quoted(source.mimeType),
                       where + "/mimeType");
  }
  return out;
}

/// Files that are larger than their texels are not compared: what they take is bounded by nothing that was checked.
std::vector<std::size_t> ImageLoader::firstOfSameBytes(const std::vector<File>& files) const {
  constexpr std::uint64_t HEAD_BYTES = 4096;
  std::vector<std::size_t> first(files.size());
  std::map<std::size_t, std::vector<std::size_t>> bySize;
  for (std::size_t i = 0; i < files.size(); ++i) {
    first[i] = i;
    const auto& [owned, bytes, header] = files[i];
    if (!bytes.empty() && bytes.size() <= texelBytesOf(header) + HEAD_BYTES) bySize[bytes.size()].push_back(i);
  }
  for (const auto& [size, images] : bySize) {
    if (images.size() == 1) continue;
    std::map<std::string, std::size_t> byDigest;
    for (const std::size_t i : images) {
      from_.cancel.check();
      first[i] = byDigest.try_emplace(sha256Hex(files[i].bytes), i).first->second;
    }
  }
  return first;
}

/// Whether images may be decoded beside the scene: all but their pixels is known by their headers. One that is not so
/// is decoded now, and the others with it, so that of several that are damaged the first is told.
bool ImageLoader::mayWait(const std::vector<File>& files) const {
  return from_.fileOwner && !from_.tolerant &&
         std::ranges::none_of(files, [](const File& file) { return file.header.mimeType == KTX2; });
}

/// Keeps the bytes of an image: with the model's file, or on their own.
std::shared_ptr<const void> ImageLoader::ownerOf(File& file) const {
  const std::byte *begin = file.bytes.data(), *end = begin + file.bytes.size();
  if (begin >= from_.file.data() && end <= from_.file.data() + from_.file.size()) return from_.fileOwner;
  // What a URI gave is the image's own; a buffer beside the file goes with the loader.
  auto owned = std::make_shared<const std::vector<std::byte>>(file.owned.empty() ? std::vector<std::byte>(begin, end)
                                                                                 : std::move(file.owned));
  file.bytes = *owned;
  return owned;
}

void ImageLoader::charge(std::size_t image, const ImageHeader& header, ImageUse use, double& bytesSoFar) const {
  const std::string where = pointer("images", image);
  bytesSoFar += static_cast<double>(texelBytesOf(header));
  checkSum("L_IMAGE_BYTES", static_cast<double>(from_.limits.imageBytes), bytesSoFar, where);
  from_.memory.charge(bytesOf(header, use), where);
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
