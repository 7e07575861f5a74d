#include <algorithm>
#include <cmath>
#include <cstring>

#include "image/encoders.h"
#include "image/oiio_bridge.h"
#include "telar/layers.h"

namespace telar {
namespace {

using Options = shot::Output::LayerOutput;
using shot::Layer;

bool isNumber(Layer layer) { return layer == Layer::kPartId || layer == Layer::kMaterialId; }

std::string_view nameOf(Layer layer) { return namesOf(layer)[static_cast<std::size_t>(layer)]; }

/// IEC 61966-2-1.
float srgbOf(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

/// A value as a whole number of 0 to `most`.
class Coder {
 public:
  Coder(const LayerImage& image, float most) : layer_(image.layer), most_(most), range_(depthRange(image)) {}

  /// @param seen  whether the pixel shows anything
  float operator()(float value, bool seen) const {
    if (isNumber(layer_)) {
      if (value > most_)
        throw Error("X_OUTPUT", "layer " + std::string(nameOf(layer_)) + ": the number " +
                                    std::to_string(static_cast<int>(value)) + " does not fit into " +
                                    (most_ > 255 ? "16" : "8") + " bits: take format \"exr\"" +
                                    (most_ > 255 ? "" : ", or output.layers.bitDepth 16"));
      return value;
    }
    if (!seen) return 0;
    switch (layer_) {
      case Layer::kDepth: {
        const float span = range_.max - range_.min;
        return 1 + (span > 0 ? (value - range_.min) / span : 0) * (most_ - 1);
      }
      case Layer::kNormal:
        return std::clamp(value * 0.5f + 0.5f, 0.0f, 1.0f) * most_;
      case Layer::kAlbedo:
        return srgbOf(value) * most_;
      default:
        return std::clamp(value, 0.0f, 1.0f) * most_;
    }
  }

 private:
  Layer layer_;
  float most_;
  DepthRange range_;
};

std::vector<std::uint8_t> rowsOf(const LayerImage& image, int bitDepth) {
  const std::size_t bytes = bitDepth == 16 ? 2 : 1, channels = channelCount(image.layer);
  const Coder code(image, bitDepth == 16 ? 65535.0f : 255.0f);
  std::vector<std::uint8_t> rows(image.pixels.size() * bytes);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* pixel = &image.pixels[i - i % channels];
    const bool seen = std::any_of(pixel, pixel + channels, [](float value) { return value != 0; });
    const auto value = static_cast<std::uint32_t>(std::lround(code(image.pixels[i], seen)));
    if (bytes == 2) rows[2 * i] = static_cast<std::uint8_t>(value >> 8);
    rows[bytes * i + bytes - 1] = static_cast<std::uint8_t>(value);
  }
  return rows;
}

/// Numbers need all bits of a float; other values those that were asked for.
std::vector<image::Channel> channelsFor(Layer layer, int bitDepth, const std::string& prefix) {
  std::vector<image::Channel> channels;
  for (const std::string_view name : channelsOf(layer)) {
    if (!name.empty()) channels.push_back({prefix + std::string(name), isNumber(layer) ? 32 : bitDepth});
  }
  return channels;
}

}  // namespace

DepthRange depthRange(const LayerImage& depth) {
  DepthRange range;
  if (depth.layer != Layer::kDepth) return range;
  for (const float z : depth.pixels) {
    if (z == 0) continue;
    const bool first = range.min == 0 && range.max == 0;
    range = {first ? z : std::min(range.min, z), first ? z : std::max(range.max, z)};
  }
  return range;
}

std::vector<std::byte> encodeLayer(const Frame& frame, const LayerImage& layer, const OutputOptions& output,
                                   const CancelToken& cancel) {
  cancel.check();
  const Options& options = output.layers;
  switch (options.format) {
    case Options::Format::kPng:
      return image::encodePngRows(
          {frame.width, frame.height, options.bitDepth, static_cast<int>(channelCount(layer.layer)),
           layer.layer == Layer::kAlbedo, output.ppi, output.effort},
          rowsOf(layer, options.bitDepth), cancel);
    case Options::Format::kExr:
      return image::encodeChannels(frame.width, frame.height, layer.pixels,
                                   channelsFor(layer.layer, options.bitDepth, ""), output.effort, cancel);
    case Options::Format::kRaw:
      break;
  }
  std::vector<std::byte> bytes(layer.pixels.size() * sizeof(float));
  std::memcpy(bytes.data(), layer.pixels.data(), bytes.size());
  return bytes;
}

std::vector<std::byte> encodeTogether(const Frame& frame, const OutputOptions& output, const CancelToken& cancel) {
  if (frame.type != PixelType::kRgbaF32) throw Error("X_OUTPUT", "layers go into one file with a colour of floats");
  std::vector<image::Channel> channels;
  for (const char* name : {"R", "G", "B", "A"}) channels.push_back({name, output.bitDepth});
  for (const LayerImage& layer : frame.layers) {
    const auto own = channelsFor(layer.layer, output.layers.bitDepth, std::string(nameOf(layer.layer)) + ".");
    channels.insert(channels.end(), own.begin(), own.end());
  }
  const std::size_t count = std::size_t{frame.width} * frame.height;
  std::vector<float> pixels(count * channels.size());
  for (std::size_t i = 0; i < count; ++i) {
    float* to = &pixels[i * channels.size()];
    std::memcpy(to, &frame.pixels[i * 4 * sizeof(float)], 4 * sizeof(float));
    to += 4;
    for (const LayerImage& layer : frame.layers) {
      const std::size_t own = channelCount(layer.layer);
      to = std::copy_n(&layer.pixels[i * own], own, to);
    }
  }
  return image::encodeChannels(frame.width, frame.height, pixels, channels, output.effort, cancel);
}

}  // namespace telar
