#include "pass/surface/flat_uniforms.h"

#include <gtest/gtest.h>

// Uniforms that reach the fragments as flat varyings; that the bytes of pictures stay is seen in
// visibility_buffer_test.cpp.

namespace telar::flat_uniforms_test {
namespace {

using pass::MOST_HANDED;
using pass::StageTexts;

const std::string VERTEX = "#version 300 es\nvoid main() {\n  gl_Position = vec4(1.0);\n}\n";

StageTexts of(const std::string& fragment) { return pass::withFlatUniforms({VERTEX, fragment}); }

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(FlatUniforms, AreHandedOnUnderTheirNames) {
  const StageTexts texts = of("uniform vec3 color;  // linear\nuniform mat3 turn;\nuniform int count;\n");
  EXPECT_EQ(texts.fragment, "flat in vec3 color;  // linear\nflat in mat3 turn;\nflat in int count;\n");
  EXPECT_TRUE(holds(texts.vertex, "\nuniform vec3 handedOn_color;\nflat out vec3 color;\n"));
  EXPECT_TRUE(
      holds(texts.vertex, "\n  color = handedOn_color;\n  turn = handedOn_turn;\n  count = handedOn_count;\n}"));
  EXPECT_EQ(texts.vertex.rfind("#version 300 es\n", 0), 0u);
}

TEST(FlatUniforms, LeaveSamplersArraysAndLargeMatrices) {
  const std::string fragment =
      "uniform sampler2D map;\nuniform highp sampler2D varyingMap;\nuniform vec3 lights[LIGHTS];\n"
      "uniform mat4 viewMatrix;\nvec4 uniform_;\n";
  EXPECT_EQ(of(fragment).fragment, fragment);
}

// Each side of an #if may declare it.
TEST(FlatUniforms, AreHandedOnOnce) {
  const StageTexts texts = of("#if A\nuniform float ior;\n#else\nuniform float ior;\n#endif\n");
  EXPECT_EQ(texts.fragment, "#if A\nflat in float ior;\n#else\nflat in float ior;\n#endif\n");
  const std::size_t first = texts.vertex.find("flat out float ior;");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(texts.vertex.find("flat out float ior;", first + 1), std::string::npos);
}

TEST(FlatUniforms, AreThoseThatThePreprocessorLeaves) {
  const StageTexts texts =
      of("#define A 1\n#define B 0\n#if B || !A\nuniform float none;\n#if A\nuniform float inside;\n#endif\n#else\n"
         "uniform float other;\n#endif\n#if A && !B\nuniform float both;\n#endif\n#if A > 0 || B\nuniform float "
         "compared;\n#endif\n");
  for (const char* name : {"none", "inside"}) EXPECT_FALSE(holds(texts.vertex, name)) << name;
  for (const char* name : {"other", "both", "compared"}) EXPECT_TRUE(holds(texts.vertex, name)) << name;
}

TEST(FlatUniforms, AreNoMoreThanVaryingsMayBe) {
  std::string fragment;
  for (int i = 0; i < MOST_HANDED; ++i) fragment += "uniform float f" + std::to_string(i) + ";\n";
  EXPECT_FALSE(holds(of(fragment).fragment, "uniform"));
  EXPECT_TRUE(holds(of(fragment + "uniform float last;\n").fragment, "\nuniform float last;\n"));
}

}  // namespace
}  // namespace telar::flat_uniforms_test
