// Writes a small .exr file of every compression and kind, numbered, into a folder: what the fuzzer of "exr" starts from.
#include <fstream>

#include "image/exr_files.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  int number = 0;
  for (const sample::ExrKind& kind : sample::exrKinds()) {
    const sample::File file = sample::exrFile(kind, 24, 20);
    std::ofstream out(argv[1] + std::string("/") + std::to_string(number++) + ".exr", std::ios::binary);
    out.write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  }
}
