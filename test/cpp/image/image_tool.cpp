// Image files from the command line, for tests in JavaScript.
//   image_tool decode FILE     width and height as 32-bit integers, then RGBA8 texels, on stdout
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "telar/codec.h"

namespace {

std::vector<std::byte> readFile(const char* path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

int decode(const char* path) {
  const telar::Image8 image = telar::decodeImage(readFile(path), {}, {});
  std::fwrite(&image.width, 4, 1, stdout);
  std::fwrite(&image.height, 4, 1, stdout);
  std::fwrite(image.pixels.data(), 1, image.pixels.size(), stdout);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  try {
    if (verb == "decode" && argc == 3) return decode(argv[2]);
  } catch (const telar::Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.code.c_str(), error.what());
    return 3;
  }
  std::fprintf(stderr, "usage: image_tool decode FILE\n");
  return 2;
}
