// Image files from the command line, for tests and benchmarks in JavaScript. Numbers are little-endian on stdout.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "telar/codec.h"

namespace {

constexpr const char* USAGE =
    "usage: image_tool decode FILE             width and height as uint32, then RGBA texels\n"
    "       image_tool levels FILE             coding, number of mip levels and texel type as uint32, then every "
    "level as decode does\n"
    "       image_tool environment FILE        width and height as uint32, then RGBA fp32 texels\n"
    "       image_tool encode OPTION=VALUE...  the encoded file; options: frame (a file of RGBA8 or RGBA fp32 "
    "pixels),\n"
    "                                          width, height, format, quality, bits, ppi, icc, effort;\n"
    "                                          repeat=N prints the median CPU milliseconds and the bytes instead\n";

using Options = std::map<std::string, std::string>;

std::vector<std::byte> readFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw telar::Error("E_FILE", "cannot open the file");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

template <class Image>
int writeImage(const Image& image) {
  std::fwrite(&image.width, 4, 1, stdout);
  std::fwrite(&image.height, 4, 1, stdout);
  std::fwrite(image.pixels.data(), sizeof image.pixels[0], image.pixels.size(), stdout);
  return 0;
}

int writeLevels(telar::Image8 image) {
  const std::uint32_t facts[] = {std::uint32_t(image.coding), std::uint32_t(1 + image.smallerLevels.size()),
                                 std::uint32_t(image.type)};
  std::fwrite(facts, sizeof facts, 1, stdout);
  writeImage(image);
  for (auto& pixels : image.smallerLevels) {
    image.width = std::max(1u, image.width / 2);
    image.height = std::max(1u, image.height / 2);
    image.pixels = std::move(pixels);
    writeImage(image);
  }
  return 0;
}

telar::OutputOptions::Format formatOf(const std::string& name) {
  using Format = telar::OutputOptions::Format;
  static const std::map<std::string, Format> FORMATS = {{"png", Format::kPng},   {"jpeg", Format::kJpeg},
                                                        {"webp", Format::kWebp}, {"tiff", Format::kTiff},
                                                        {"exr", Format::kExr},   {"raw", Format::kRaw}};
  return FORMATS.at(name);
}

int encode(Options options) {
  telar::OutputOptions output;
  output.format = formatOf(options["format"]);
  if (options.count("quality")) output.quality = std::stoi(options["quality"]);
  if (options.count("bits")) output.bitDepth = std::stoi(options["bits"]);
  if (options.count("ppi")) output.ppi = std::stod(options["ppi"]);
  if (options.count("effort")) output.effort = std::stoi(options["effort"]);
  output.icc = options["icc"] == "1";
  const telar::Frame frame{std::uint32_t(std::stoul(options["width"])), std::uint32_t(std::stoul(options["height"])),
                           telar::framePixelType(output), readFile(options["frame"])};
  if (!options.count("repeat")) {
    const std::vector<std::byte> file = telar::encode(frame, output, {});
    std::fwrite(file.data(), 1, file.size(), stdout);
    return 0;
  }
  std::vector<double> milliseconds;
  std::size_t bytes = 0;
  for (int i = std::stoi(options["repeat"]); i > 0; --i) {
    const std::clock_t start = std::clock();
    bytes = telar::encode(frame, output, {}).size();
    milliseconds.push_back(1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("%.3f %zu\n", milliseconds[milliseconds.size() / 2], bytes);
  return 0;
}

int run(int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  if (verb == "decode" && argc == 3) return writeImage(telar::decodeImage(readFile(argv[2]), {}, {}));
  if (verb == "levels" && argc == 3) return writeLevels(telar::decodeImage(readFile(argv[2]), {}, {}));
  if (verb == "environment" && argc == 3) return writeImage(telar::readEnvironment(readFile(argv[2]), {}, {}));
  if (verb == "encode") {
    Options options;
    for (int i = 2; i < argc; ++i) {
      const std::string text = argv[i];
      const std::size_t equals = text.find('=');
      options[text.substr(0, equals)] = equals == std::string::npos ? "" : text.substr(equals + 1);
    }
    return encode(options);
  }
  std::fputs(USAGE, stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  setenv("TELAR_LIBRARY_DIR", TELAR_OIIO_FOLDER, 0);
  try {
    return run(argc, argv);
  } catch (const telar::Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.code.c_str(), error.what());
    return 3;
  }
}
