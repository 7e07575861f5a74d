// telar_mutate FILE RUNS [FROM [TO]]: loads a model RUNS times, each time with a few other bytes changed between FROM
// and TO, and prints one JSON line: {runs, ok, codes: {code: count}, worstCpuMs, worstRun}. The same bytes at each
// start. Whatever is not an Error of telar ends the program.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "telar/load.h"

namespace {

/// xorshift64*: fast, and the same everywhere.
class Random {
 public:
  std::uint64_t below(std::uint64_t end) {
    state_ ^= state_ >> 12;
    state_ ^= state_ << 25;
    state_ ^= state_ >> 27;
    return (state_ * 0x2545f4914f6cdd1dull >> 32) % end;
  }

 private:
  std::uint64_t state_ = 88172645463325252ull;
};

void change(std::vector<char>& file, std::size_t from, std::size_t to, Random& random) {
  constexpr char VALUES[] = {0, 1, 0x7f, static_cast<char>(0x80), static_cast<char>(0xff)};
  for (std::uint64_t n = 1 + random.below(6); n > 0; --n) {
    char& byte = file[from + random.below(to - from)];
    switch (random.below(3)) {
      case 0:
        byte = static_cast<char>(byte ^ 1 << random.below(8));
        break;
      case 1:
        byte = VALUES[random.below(std::size(VALUES))];
        break;
      default:
        byte = static_cast<char>(random.below(256));
    }
  }
}

std::string codeOf(const std::vector<char>& file) {
  try {
    telar::loadBytes(std::as_bytes(std::span(file)), {}, {});
    return {};
  } catch (const telar::Error& error) {
    return error.code;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return std::fprintf(stderr, "usage: telar_mutate FILE RUNS [FROM [TO]]\n"), 2;
  std::ifstream in(argv[1], std::ios::binary);
  const std::vector<char> good{std::istreambuf_iterator<char>(in), {}};
  const long runs = std::atol(argv[2]);
  const std::size_t from = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 0;
  const std::size_t to = argc > 4 ? std::strtoull(argv[4], nullptr, 10) : good.size();
  if (from >= to || to > good.size()) return std::fprintf(stderr, "telar_mutate: no bytes to change\n"), 2;
  Random random;
  std::map<std::string, long> codes;
  double worstMs = 0;
  long ok = 0, worstRun = 0;
  for (long run = 0; run < runs; ++run) {
    std::vector<char> file = good;
    change(file, from, to, random);
    const std::clock_t start = std::clock();
    const std::string code = codeOf(file);
    const double ms = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (ms > worstMs) worstMs = ms, worstRun = run;
    code.empty() ? ++ok : ++codes[code];
  }
  const nlohmann::json out = {
      {"runs", runs}, {"ok", ok}, {"codes", codes}, {"worstCpuMs", worstMs}, {"worstRun", worstRun}};
  std::puts(out.dump().c_str());
  return 0;
}
