#define TELAR_OIIO_PLUGIN
#include "oiio/plugin.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "oiio/srgb_profile.h"
#include "oiio/tiff_writer.h"

namespace telar::oiio {
namespace {

constexpr int CHANNELS_MAX = 64;  // OpenEXR makes line buffers for all of them

/// Ends a call early; only inside this library.
struct Stop {
  TelarOiioStatus status;
  std::string message;
};

[[noreturn]] void stop(TelarOiioStatus status, std::string message) { throw Stop{status, std::move(message)}; }

bool onProgress(void* opaque, float) {
  const auto& cancel = *static_cast<const TelarOiioCancel*>(opaque);
  return cancel.cancelled(cancel.user);
}

/// One plugin by its name; OpenImageIO must not try others on the same bytes. Its threads stay off: the caller has its
/// own, and a pool that outlives the call would hinder the end of the process. Debian's build prints hints to
/// developers on standard error unless it is told not to.
void settle() {
  OIIO::attribute("debug", 0);
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);
}

const char* pluginName(TelarOiioFormat format) { return format == TELAR_OIIO_PNG ? "png" : "openexr"; }

void describeIntegers(const TelarOiioWrite& job, OIIO::ImageSpec& spec) {
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", job.level);
  if (job.icc) {
    const std::vector<std::uint8_t> profile = srgbProfile();
    spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(profile.size())), profile.data());
  }
}

void describeFloats(const TelarOiioWrite& job, OIIO::ImageSpec& spec) {
  // x and y of red, green, blue and white: ITU-R BT.709-6, 1.3 and 1.4.
  static constexpr std::uint8_t NO_TIME = 0;
  static constexpr float REC_709[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), REC_709);
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("compression", job.level > 0 ? "zip:" + std::to_string(job.level) : "none");
  // OpenImageIO adds the present time where DateTime is absent, which would make no two files alike. As a number it is
  // present, and not a thing that EXR can hold: nothing is written.
  spec.attribute("DateTime", OIIO::TypeDesc::UINT8, &NO_TIME);
}

OIIO::ImageSpec describe(const TelarOiioWrite& job) {
  const bool floats = job.format == TELAR_OIIO_EXR;
  const auto stored = floats ? (job.bitDepth == 16 ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT)
                             : (job.bitDepth == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8);
  OIIO::ImageSpec spec(int(job.width), int(job.height), int(job.channels), stored);
  spec.alpha_channel = job.names ? -1 : 3;
  if (job.names) spec.channelnames.assign(job.names, job.names + job.channels);
  for (std::uint32_t i = 0; job.bitDepths && i < job.channels; ++i)
    spec.channelformats.emplace_back(job.bitDepths[i] == 16 ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  for (std::uint32_t i = 0; job.names && i < job.channels; ++i) {
    if (std::string_view(job.names[i]) == "A") spec.alpha_channel = int(i);
  }
  if (floats)
    describeFloats(job, spec);
  else
    describeIntegers(job, spec);
  if (job.ppi > 0) {
    spec.attribute("XResolution", float(job.ppi));
    spec.attribute("YResolution", float(job.ppi));
    spec.attribute("ResolutionUnit", "in");
  }
  return spec;
}

std::vector<unsigned char> tiffOf(const TelarOiioWrite& job) {
  TiffFile file = writeTiff(job);
  if (file.cancelled) stop(TELAR_OIIO_CANCELLED, {});
  if (!file.failure.empty()) stop(TELAR_OIIO_FAILED, "tiff: " + file.failure);
  return std::move(file.bytes);
}

std::vector<unsigned char> fileOf(const TelarOiioWrite& job) {
  const std::string name = pluginName(job.format);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(name);
  if (!output) stop(TELAR_OIIO_FAILED, "OpenImageIO has no writer for " + name + ": " + OIIO::geterror());
  if (!output->supports("ioproxy") || !output->set_ioproxy(&memory)) {
    stop(TELAR_OIIO_FAILED, "OpenImageIO cannot write " + name + " to memory");
  }
  const auto given = job.format == TELAR_OIIO_EXR ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  auto cancel = job.cancel;
  const bool written =
      output->open("memory." + name, describe(job)) &&
      output->write_image(given, job.pixels, OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride, onProgress, &cancel);
  if (cancel.cancelled(cancel.user)) stop(TELAR_OIIO_CANCELLED, {});
  if (!written || !output->close()) stop(TELAR_OIIO_FAILED, name + ": " + output->geterror());
  return bytes;
}

void write(const TelarOiioWrite& job, const TelarOiioSink& sink) {
  settle();
  const std::vector<unsigned char> bytes = job.format == TELAR_OIIO_TIFF ? tiffOf(job) : fileOf(job);
  if (!sink.append(sink.user, bytes.data(), bytes.size())) throw std::bad_alloc();
}

/// First of the three neighbouring channels R, G, B, or the channel Y alone.
struct Channels {
  int first;
  int count;
};

Channels findChannels(const OIIO::ImageSpec& spec) {
  const auto& names = spec.channelnames;
  if (spec.deep) stop(TELAR_OIIO_UNSUPPORTED, "it is a deep image");
  if (spec.nchannels > CHANNELS_MAX) stop(TELAR_OIIO_UNSUPPORTED, "it has more than 64 channels");
  const auto red = std::find(names.begin(), names.end(), "R");
  if (names.end() - red >= 3 && red[1] == "G" && red[2] == "B") return {int(red - names.begin()), 3};
  const bool chroma = std::find(names.begin(), names.end(), "RY") != names.end();
  const auto grey = std::find(names.begin(), names.end(), "Y");
  if (grey != names.end() && !chroma) return {int(grey - names.begin()), 1};
  stop(TELAR_OIIO_UNSUPPORTED, "it has no channels R, G and B");
}

void read(const TelarOiioRead& job) {
  settle();
  const std::string name = pluginName(TELAR_OIIO_EXR);
  OIIO::Filesystem::IOMemReader memory(job.file, job.fileBytes);
  const auto input = OIIO::ImageInput::create(name);
  if (!input) stop(TELAR_OIIO_FAILED, "OpenImageIO has no reader for " + name + ": " + OIIO::geterror());
  OIIO::ImageSpec spec;
  if (!input->set_ioproxy(&memory) || !input->open("memory." + name, spec)) {
    stop(TELAR_OIIO_FAILED, input->geterror());
  }
  if (spec.width != int(job.width) || spec.height != int(job.height) || spec.depth != 1) {
    stop(TELAR_OIIO_FAILED, "the header contradicts itself");
  }
  const Channels channels = findChannels(spec);
  auto cancel = job.cancel;
  const OIIO::stride_t pixelBytes = 4 * sizeof(float);
  const bool complete =
      input->read_image(0, 0, channels.first, channels.first + channels.count, OIIO::TypeDesc::FLOAT, job.rgba,
                        pixelBytes, OIIO::AutoStride, OIIO::AutoStride, onProgress, &cancel);
  if (cancel.cancelled(cancel.user)) stop(TELAR_OIIO_CANCELLED, {});
  if (!complete || input->has_error()) stop(TELAR_OIIO_FAILED, input->geterror());
  if (channels.count == 1) {
    const std::size_t count = std::size_t{job.width} * job.height;
    for (std::size_t i = 0; i < count; ++i) job.rgba[i * 4 + 1] = job.rgba[i * 4 + 2] = job.rgba[i * 4];
  }
}

void report(TelarOiioResult& result, TelarOiioStatus status, const char* message) {
  result.status = status;
  std::snprintf(result.message, sizeof result.message, "%s", message);
}

/// Runs `work` and turns whatever it throws into a result.
template <class Work>
void guard(TelarOiioResult& result, const Work& work) noexcept {
  report(result, TELAR_OIIO_OK, "");
  try {
    work();
  } catch (const Stop& stopped) {
    report(result, stopped.status, stopped.message.c_str());
  } catch (const std::bad_alloc&) {
    report(result, TELAR_OIIO_NO_MEMORY, "");
  } catch (const std::exception& error) {
    report(result, TELAR_OIIO_FAILED, error.what());
  } catch (...) {
    report(result, TELAR_OIIO_FAILED, "unknown failure");
  }
}

}  // namespace
}  // namespace telar::oiio

std::uint32_t telar_oiio_version() { return TELAR_OIIO_VERSION; }

void telar_oiio_write(const TelarOiioWrite* job, const TelarOiioSink* sink, TelarOiioResult* result) {
  telar::oiio::guard(*result, [&] { telar::oiio::write(*job, *sink); });
}

void telar_oiio_read(const TelarOiioRead* job, TelarOiioResult* result) {
  telar::oiio::guard(*result, [&] { telar::oiio::read(*job); });
}

void telar_oiio_srgb_profile(const TelarOiioSink* sink, TelarOiioResult* result) {
  telar::oiio::guard(*result, [&] {
    const std::vector<std::uint8_t> profile = telar::oiio::srgbProfile();
    if (!sink->append(sink->user, profile.data(), profile.size())) throw std::bad_alloc();
  });
}
