#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "brdf/terms.h"

namespace telar::test::shared_text_test {
namespace {

namespace fs = std::filesystem;

const fs::path SHADERS = TELAR_SOURCE_DIR "/shaders";

std::vector<fs::path> shaderFiles() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(SHADERS)) {
    const std::string extension = entry.path().extension();
    if (extension == ".glsl" || extension == ".vert" || extension == ".frag") files.push_back(entry.path());
  }
  return files;
}

std::string withoutComments(const std::string& text) { return std::regex_replace(text, std::regex("//[^\n]*"), ""); }

/// 1.0e-6 -> 1.0: the digits of an exponent are no integer literal.
std::string withoutExponents(const std::string& text) {
  return std::regex_replace(text, std::regex(R"((\d\.\d+)e-?\d+)"), "$1");
}

struct Rule {
  const char* what;
  const char* pattern;
};

// What GLSL ES 3.00 and C++ over GLM do not read alike.
const Rule FORBIDDEN[] = {
    {"block comment", R"(/\*)"},
    {"preprocessor", "#"},
    {"storage or parameter qualifier", R"(\b(uniform|in|out|inout|varying|attribute|flat|inline|static)\b)"},
    {"precision", R"(\b(precision|highp|mediump|lowp)\b)"},
    {"const other than a global float", R"((^|\n)[ \t]+const\b|\bconst\s+(?!float\b)\w+|\(\s*const\b|,\s*const\b)"},
    {"type outside of the subset", R"(\b(int|uint|bool|double|[iub]vec[234]|mat[24]\w*|sampler\w+)\b)"},
    {"array", R"(\[)"},
    {"swizzle", R"(\.[xyzw]{2,}\b|\.[rgba]+\b|\.[stpq]+\b)"},
    {"integer literal", R"((^|[^\w.])\d+(?![\w.]))"},
    {"literal with a suffix", R"(\b\d*\.\d*[fFlL]\b)"},
    {"literal without a digit on both sides of the point", R"((^|[^\w])\.\d|\d\.(?!\d))"},
};

TEST(SharedText, EveryShaderIsAscii) {
  for (const fs::path& file : shaderFiles()) {
    const std::string text = readFile(file);
    const auto odd =
        std::find_if(text.begin(), text.end(), [](unsigned char c) { return c > 126 || (c < 32 && c != '\n'); });
    EXPECT_EQ(odd, text.end()) << file.filename() << ": byte " << odd - text.begin();
  }
}

TEST(SharedText, TermsKeepToTheSubset) {
  for (const fs::path& file : shaderFiles()) {
    if (file.parent_path() != SHADERS / "brdf") continue;
    const std::string text = withoutExponents(withoutComments(readFile(file)));
    for (const Rule& rule : FORBIDDEN) {
      std::smatch match;
      EXPECT_FALSE(std::regex_search(text, match, std::regex(rule.pattern)))
          << file.filename() << ": " << rule.what << ": '" << match.str() << "'";
    }
  }
}

TEST(SharedText, TheRulesCatchWhatTheyForbid) {
  const std::pair<const char*, const char*> broken[] = {
      {"block comment", "/* x */"},
      {"preprocessor", "#if A"},
      {"storage or parameter qualifier", "void f(out float x)"},
      {"precision", "highp float x"},
      {"const other than a global float", "float f(const float x)"},
      {"const other than a global float", "  const float x = 1.0;"},
      {"const other than a global float", "const mat3 m = mat3(1.0);"},
      {"type outside of the subset", "ivec2 a;"},
      {"array", "float a[3]"},
      {"swizzle", "v.xy * w.r"},
      {"integer literal", "max(x, 2)"},
      {"literal with a suffix", "x * 1.0f"},
      {"literal without a digit on both sides of the point", "x * .5"},
      {"literal without a digit on both sides of the point", "x * 5."},
  };
  for (const auto& [what, text] : broken) {
    bool caught = false;
    for (const Rule& rule : FORBIDDEN) {
      if (std::string(rule.what) == what) caught |= std::regex_search(std::string(text), std::regex(rule.pattern));
    }
    EXPECT_TRUE(caught) << what << ": " << text;
  }
}

TEST(SharedText, EveryFileIsCompiledAndEveryFunctionIsInTheTable) {
  std::set<std::string> onDisk, compiled;
  for (const fs::path& file : shaderFiles()) {
    if (file.parent_path() == SHADERS / "brdf") onDisk.insert(file.filename());
  }
  for (const std::string& file : sharedFiles()) compiled.insert(file);
  EXPECT_EQ(onDisk, compiled);

  std::string expressions;
  for (const Term& term : terms()) expressions += term.expression + "\n";
  const std::string text = withoutComments(sharedText());
  const std::regex function(R"((?:^|\n)(?:float|vec[234]|mat3|Scattering) (\w+)\()");
  int functions = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), function), end; match != end; ++match, ++functions) {
    const std::string call = (*match)[1].str() + "(";
    EXPECT_NE(expressions.find(call), std::string::npos) << call << ") is not evaluated by any row of terms.cpp";
  }
  EXPECT_GT(functions, 40);
}

}  // namespace
}  // namespace telar::test::shared_text_test
