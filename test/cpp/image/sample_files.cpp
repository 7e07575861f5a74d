#include "image/sample_files.h"

#include <zlib.h>

#include <cmath>
#include <cstdlib>

namespace sample {
namespace {

/// Numerical Recipes' linear congruential generator: noise that is the same everywhere.
struct Noise {
  std::uint32_t state = 1;
  std::uint8_t operator()() {
    state = state * 1664525u + 1013904223u;
    return std::uint8_t(state >> 24);
  }
};

}  // namespace

void useBuiltLibrary() { setenv("TELAR_LIBRARY_DIR", TELAR_OIIO_FOLDER, 1); }

telar::Frame frame8(std::uint32_t width, std::uint32_t height, bool opaque) {
  telar::Frame frame{width, height, telar::PixelType::kRgba8, {}};
  Noise noise;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const int alpha = opaque ? 255 : int((x + y) * 255 / (width + height));
      for (const int v : {int(x * 255 / width), int(y * 255 / height), noise() & 31, alpha}) {
        frame.pixels.push_back(std::byte(v));
      }
    }
  }
  return frame;
}

telar::Frame frame32(std::uint32_t width, std::uint32_t height) {
  std::vector<float> values;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const float alpha = float(x) / float(width);
      for (const float v : {alpha * 40, alpha * float(y), alpha * 0.001f, alpha}) values.push_back(v);
    }
  }
  telar::Frame frame{width, height, telar::PixelType::kRgbaF32, File(values.size() * 4)};
  std::memcpy(frame.pixels.data(), values.data(), frame.pixels.size());
  return frame;
}

File encoded(const telar::Frame& frame, telar::OutputOptions::Format format, int bitDepth, int quality) {
  telar::OutputOptions options;
  options.format = format;
  options.bitDepth = bitDepth;
  options.quality = quality;
  return telar::encode(frame, options, {});
}

File bytes(const std::string& text) {
  File file(text.size());
  if (!text.empty()) std::memcpy(file.data(), text.data(), text.size());
  return file;
}

File concat(std::initializer_list<File> parts) {
  File out;
  for (const File& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

File cut(const File& file, std::size_t size) { return File(file.begin(), file.begin() + std::ptrdiff_t(size)); }

File be32(std::uint32_t value) {
  File out;
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(std::byte(value >> shift));
  return out;
}

File pngChunk(const std::string& type, const File& data) {
  const File body = concat({bytes(type), data});
  const auto crc = std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
  return concat({be32(std::uint32_t(data.size())), body, be32(crc)});
}

File pngHeader(std::uint32_t width, std::uint32_t height, int depth, int colorType) {
  const File data = concat({be32(width), be32(height), {std::byte(depth), std::byte(colorType)}, File(3)});
  return concat({bytes("\x89PNG\r\n\x1a\n"), pngChunk("IHDR", data)});
}

File flatHdr(int width, int height, const std::vector<std::uint8_t>& rgbe) {
  const std::string head =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
  return concat({bytes(head), bytes(std::string(rgbe.begin(), rgbe.end()))});
}

std::string codeOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const telar::Error& error) {
    return error.code;
  }
  return "";
}

}  // namespace sample
