// OpenImageIO's own PNG writer at its default, for test/bench/encode.mjs to compare with.
// encode_oiio FRAME WIDTH HEIGHT FORMAT REPEAT prints the median CPU milliseconds and the bytes.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  std::ifstream in(argv[1], std::ios::binary);
  const std::string pixels{std::istreambuf_iterator<char>(in), {}};
  const std::string format = argv[4];
  OIIO::ImageSpec spec(std::atoi(argv[2]), std::atoi(argv[3]), 4, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  std::vector<double> milliseconds;
  std::vector<unsigned char> file;
  for (int i = std::atoi(argv[5]); i > 0; --i) {
    file.clear();
    const std::clock_t start = std::clock();
    OIIO::Filesystem::IOVecOutput memory(file);
    const auto output = OIIO::ImageOutput::create(format);
    if (!output || !output->set_ioproxy(&memory) || !output->open("memory." + format, spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) || !output->close()) {
      std::fprintf(stderr, "%s\n", OIIO::geterror().c_str());
      return 1;
    }
    milliseconds.push_back(1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  std::printf("%.3f %zu\n", milliseconds[milliseconds.size() / 2], file.size());
}
