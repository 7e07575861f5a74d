// view_tool FILE: the bytes of every buffer view of a model, one after the other, on stdout, as accessors read them:
// decompressed where they are compressed. For test/js/meshopt_bytes.test.mjs.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

#include "asset/accessor/resources.h"

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: view_tool FILE\n"), 2;
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> file{std::istreambuf_iterator<char>(in), {}};
  try {
    using namespace telar::asset;
    const telar::Limits limits;
    const telar::CancelToken cancel;
    Warnings warnings;
    const Container container = openContainer(std::as_bytes(std::span(file)), limits, warnings);
    const Document document = readDocument(container, limits, cancel, warnings);
    Resources resources(document, container, nullptr, cancel);
    telar::MemoryBudget memory(limits.memoryBytes);
    resources.loadBuffers(limits, memory);
    for (std::size_t i = 0; i < document.model.bufferViews.size(); ++i) {
      const auto bytes = resources.view(static_cast<int>(i));
      std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    }
  } catch (const telar::Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.code.c_str(), error.what());
    return 3;
  }
  return 0;
}
