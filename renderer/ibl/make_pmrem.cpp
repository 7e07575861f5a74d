// telar_make_pmrem IN.hdr OUT.pmrem: prefilters the studio to the file that ships beside it.
#include <cstdio>

#include "core/disk_cache.h"
#include "core/read_file.h"
#include "ibl/pmrem_file.h"
#include "ibl/prefilter.h"
#include "telar/codec.h"

namespace {

int run(const char* in, const char* out) {
  constexpr std::size_t FILE_MAX = 64u << 20;
  const auto file = telar::readFile(in, FILE_MAX);
  if (!file) throw telar::Error("E_ENVIRONMENT_MISSING", "the environment cannot be read");
  const telar::CancelToken cancel;
  // Always on Mesa's rasteriser, so that the file does not depend on the machine's GPU.
  const auto context = telar::gl::Context::create(telar::Backend::kEglSurfaceless);
  const auto cube =
      telar::ibl::prefilterEquirect(*context, telar::readEnvironment(*file, telar::Limits{}, cancel), cancel);
  const auto packed = telar::ibl::packPmrem(*context, cube, "studio");
  if (!telar::writeFileAtomically(out, packed)) throw telar::Error("X_OUTPUT", "the file cannot be written");
  std::printf("%s: %d px, %d levels, %zu bytes\n", out, cube.faceSize, cube.levels, packed.size());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: telar_make_pmrem IN.hdr OUT.pmrem\n", stderr), 2;
  try {
    return run(argv[1], argv[2]);
  } catch (const telar::Error& error) {
    std::fprintf(stderr, "%s: %s\n", error.code.c_str(), error.what());
    return 3;
  }
}
