#include "image/exr_files.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace sample {
namespace {

constexpr int TILE = 16;

OIIO::ImageSpec specOf(const ExrKind& kind, int width, int height) {
  OIIO::ImageSpec spec(width, height, 5, kind.isFloat ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::HALF);
  if (kind.isInteger) spec.format = OIIO::TypeDesc::UINT32;
  spec.channelnames = {"R", "G", "B", "A", "Z"};
  spec.channelformats.assign(5, spec.format);
  spec.channelformats[4] = OIIO::TypeDesc::FLOAT;
  spec.alpha_channel = 3;
  if (kind.isInteger) spec.channelnames[3] = "N", spec.alpha_channel = -1;
  spec.attribute("compression", kind.compression);
  if (kind.isDecreasing) spec.attribute("openexr:lineOrder", "decreasingY");
  if (kind.isTiled) spec.tile_width = spec.tile_height = TILE;
  if (kind.isMipmap) spec.attribute("textureformat", "Plain Texture");
  return spec;
}

std::vector<float> picture(const OIIO::ImageSpec& spec) {
  const int width = spec.width, height = spec.height;
  std::vector<float> texels;
  std::uint32_t noise = 1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      noise = noise * 1664525u + 1013904223u;
      const float grain = float(noise >> 24) / 256;
      // A flat half: what is coded as one value or one run.
      const float slope = x < width / 2 ? 0.5f : float(x) / float(width) * 20 + grain;
      texels.insert(texels.end(), {slope, float(y) / float(height), grain, x < 8 ? 1.0f : grain, float(x * y)});
    }
  }
  return texels;
}

void must(bool works, const std::string& what) {
  if (!works) throw std::runtime_error(what + ": " + OIIO::geterror());
}

File bytesOf(const std::vector<unsigned char>& bytes) {
  File file(bytes.size());
  if (!bytes.empty()) std::memcpy(file.data(), bytes.data(), bytes.size());
  return file;
}

/// Two parts of one form. OpenImageIO writes these to files alone.
File fileOfParts(const OIIO::ImageSpec& spec) {
  const std::string path = testing::TempDir() + "telar_parts_" + std::to_string(getpid()) + ".exr";
  const auto output = OIIO::ImageOutput::create("openexr");
  OIIO::ImageSpec parts[2] = {spec, spec};
  parts[0].attribute("oiio:subimagename", "sky");
  parts[1].attribute("oiio:subimagename", "rest");
  must(output->open(path, 2, parts), output->geterror());
  must(output->write_image(OIIO::TypeDesc::FLOAT, picture(spec).data()), output->geterror());
  must(output->open(path, parts[1], OIIO::ImageOutput::AppendSubimage), output->geterror());
  must(output->write_image(OIIO::TypeDesc::FLOAT, picture(spec).data()), output->geterror());
  must(output->close(), output->geterror());
  std::vector<unsigned char> bytes;
  std::ifstream stream(path, std::ios::binary);
  bytes.assign(std::istreambuf_iterator<char>(stream), {});
  std::filesystem::remove(path);
  return bytesOf(bytes);
}

}  // namespace

File exrFile(const ExrKind& kind, int width, int height) {
  OIIO::attribute("threads", 1);
  if (kind.isMultiPart) return fileOfParts(specOf(kind, width, height));
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  auto output = OIIO::ImageOutput::create("openexr");
  must(output && output->set_ioproxy(&memory), "no writer");
  for (int w = width, h = height, level = 0; level == 0 || (kind.isMipmap && (w > 0 || h > 0));
       w /= 2, h /= 2, ++level) {
    const OIIO::ImageSpec spec = specOf(kind, std::max(w, 1), std::max(h, 1));
    const auto mode = level == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendMIPLevel;
    must(output->open("memory.exr", spec, mode), output->geterror());
    must(output->write_image(OIIO::TypeDesc::FLOAT, picture(spec).data()), output->geterror());
  }
  must(output->close(), output->geterror());
  output.reset();  // the table of the levels is written now
  return bytesOf(bytes);
}

std::vector<ExrKind> exrKinds() {
  std::vector<ExrKind> kinds;
  for (const char* name : {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"}) {
    ExrKind kind{name};
    kinds.push_back(kind);
    kind.isDecreasing = true, kinds.push_back(kind), kind.isDecreasing = false;
    kind.isFloat = true, kinds.push_back(kind);
    kind.isMultiPart = true, kinds.push_back(kind), kind.isMultiPart = false;
    kind.isTiled = true, kinds.push_back(kind);
    kind.isMipmap = true, kinds.push_back(kind);
  }
  return kinds;
}

std::string nameOf(const ExrKind& kind) {
  return kind.compression + (kind.isFloat ? " 32" : " 16") + (kind.isTiled ? " tiled" : "") +
         (kind.isMipmap ? " levels" : "") + (kind.isMultiPart ? " parts" : "") +
         (kind.isDecreasing ? " decreasing" : "");
}

std::vector<float> texelsByOpenImageIo(const File& file) {
  OIIO::Filesystem::IOMemReader memory(const_cast<std::byte*>(file.data()), file.size());
  const auto input = OIIO::ImageInput::create("openexr");
  OIIO::ImageSpec spec;
  must(input && input->set_ioproxy(&memory) && input->open("memory.exr", spec), "no reader " + input->geterror());
  std::vector<float> texels(std::size_t(spec.width) * std::size_t(spec.height) * 3);
  must(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, texels.data()), input->geterror());
  return texels;
}

}  // namespace sample
