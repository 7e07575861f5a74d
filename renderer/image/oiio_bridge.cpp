#include "image/oiio_bridge.h"

#include <new>
#include <string>

#include "core/own_library.h"
#include "image/effort.h"
#include "oiio/plugin.h"

namespace telar::image {
namespace {

/// The loaded library.
class Library : public OwnLibrary {
 public:
  Library()
      : OwnLibrary("libtelar_oiio.so", "OpenImageIO is needed for .exr and TIFF files and for ICC profiles",
                   "apt-get install libopenimageio2.4 liblcms2-2 libtiff6") {
    if (function<TelarOiioVersionFunction>("telar_oiio_version")() != TELAR_OIIO_VERSION) refuse();
  }
};

bool append(void* user, const void* bytes, std::size_t count) {
  auto& out = *static_cast<std::vector<std::byte>*>(user);
  try {
    const auto* begin = static_cast<const std::byte*>(bytes);
    out.insert(out.end(), begin, begin + count);
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

TelarOiioCancel cancelOf(const CancelToken& cancel) {
  return {&cancel, [](const void* user) { return static_cast<const CancelToken*>(user)->isOver(); }};
}

/// @param code of a FAILED result
void check(const TelarOiioResult& result, const char* code, const std::string& subject, const CancelToken& cancel) {
  switch (result.status) {
    case TELAR_OIIO_OK:
      return;
    case TELAR_OIIO_CANCELLED:
      cancel.check();
      break;
    case TELAR_OIIO_NO_MEMORY:
      throw std::bad_alloc();
    case TELAR_OIIO_UNSUPPORTED:
      throw Error("E_ENVIRONMENT_FORMAT", subject + " cannot be used: " + result.message);
    default:
      break;
  }
  throw Error(code, subject + " failed: " + quoted(result.message));
}

TelarOiioFormat formatOf(OutputOptions::Format format) {
  switch (format) {
    case OutputOptions::Format::kTiff:
      return TELAR_OIIO_TIFF;
    case OutputOptions::Format::kExr:
      return TELAR_OIIO_EXR;
    default:
      return TELAR_OIIO_PNG;
  }
}

int levelOf(TelarOiioFormat format, int effort) {
  const EffortLevels& levels = levelsOf(effort);
  return format == TELAR_OIIO_TIFF ? levels.tiff : format == TELAR_OIIO_EXR ? levels.exr : levels.zlib;
}

void writeInto(std::vector<std::byte>& file, const TelarOiioWrite& job, const CancelToken& cancel) {
  const TelarOiioSink sink = {&file, append};
  TelarOiioResult result;
  Library().function<TelarOiioWriteFunction>("telar_oiio_write")(&job, &sink, &result);
  check(result, "X_OUTPUT", "writing the image", cancel);
}

}  // namespace

std::vector<std::byte> encodeWithOiio(const Frame& frame, const OutputOptions& options, const CancelToken& cancel) {
  std::vector<std::byte> file;
  const TelarOiioFormat format = formatOf(options.format);
  const TelarOiioWrite job = {format,
                              frame.width,
                              frame.height,
                              frame.pixels.data(),
                              options.bitDepth,
                              options.ppi,
                              levelOf(format, options.effort),
                              options.icc,
                              cancelOf(cancel),
                              4,
                              nullptr,
                              nullptr};
  writeInto(file, job, cancel);
  return file;
}

std::vector<std::byte> encodeChannels(std::uint32_t width, std::uint32_t height, const std::vector<float>& pixels,
                                      const std::vector<Channel>& channels, int effort, const CancelToken& cancel) {
  std::vector<const char*> names;
  std::vector<int> bits;
  for (const Channel& channel : channels) names.push_back(channel.name.c_str()), bits.push_back(channel.bitDepth);
  std::vector<std::byte> file;
  writeInto(file,
            {TELAR_OIIO_EXR, width, height, pixels.data(), 32, 0, levelOf(TELAR_OIIO_EXR, effort), false,
             cancelOf(cancel), static_cast<std::uint32_t>(channels.size()), names.data(), bits.data()},
            cancel);
  return file;
}

std::vector<std::byte> srgbProfile() {
  std::vector<std::byte> profile;
  const TelarOiioSink sink = {&profile, append};
  TelarOiioResult result;
  Library().function<TelarOiioProfileFunction>("telar_oiio_srgb_profile")(&sink, &result);
  check(result, "X_OUTPUT", "making the ICC profile", {});
  return profile;
}

ImageF readExr(Bytes file, std::uint32_t width, std::uint32_t height, const CancelToken& cancel) {
  ImageF image{width, height, std::vector<float>(std::size_t{width} * height * 4)};
  const TelarOiioRead job = {file.data(), file.size(), width, height, image.pixels.data(), cancelOf(cancel)};
  TelarOiioResult result;
  Library().function<TelarOiioReadFunction>("telar_oiio_read")(&job, &result);
  check(result, "E_ENVIRONMENT_CORRUPT", "reading the environment", cancel);
  return image;
}

}  // namespace telar::image

namespace telar {

std::string failureOfImageFiles() {
  try {
    const image::Library library;
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace telar
