// Makes tangents for test/js/mesh/mikktspace.test.mjs. stdin: uint32 vertices, uint32 indices, then float32 positions
// (3), normals (3), uvs (2) of each vertex and the uint32 indices, little-endian. stdout: float32 tangent (4) of each
// corner.
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "mesh/mikk_tangents.h"

namespace {

template <class T>
std::vector<T> read(std::size_t count) {
  std::vector<T> values(count);
  if (std::fread(values.data(), sizeof(T), count, stdin) != count) throw std::runtime_error("input ends early");
  return values;
}

}  // namespace

int main() {
  try {
    const auto counts = read<std::uint32_t>(2);
    telar::Primitive primitive;
    primitive.positions = read<glm::vec3>(counts[0]);
    primitive.normals = read<glm::vec3>(counts[0]);
    primitive.uvs[0] = read<glm::vec2>(counts[0]);
    primitive.indices = read<std::uint32_t>(counts[1]);
    const telar::Primitive result = telar::withMikkTangents(primitive);
    const std::size_t corners = result.indices.empty() ? result.positions.size() : result.indices.size();
    for (std::size_t i = 0; i < corners; ++i) {
      const glm::vec4& tangent = result.tangents[result.indices.empty() ? i : result.indices[i]];
      std::fwrite(&tangent, sizeof(tangent), 1, stdout);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tangent_tool: %s\n", error.what());
    return 1;
  }
}
