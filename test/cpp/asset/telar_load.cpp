// telar_load FILE [--bytes]: loads one model and prints one JSON line, for test/robust.
// {ok: true, ms, cpuMs, scene} or {ok: false, ms, cpuMs, code, message, pointer?, offset?, limit?}; exit status 0, or 3
// on an error. cpuMs is processor time: what a busy machine does not change.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "telar/load.h"

namespace {

using nlohmann::json;

std::vector<char> readFile(const char* path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

json toJson(const telar::Error& error) {
  json out = {{"ok", false}, {"code", error.code}, {"message", error.what()}};
  if (error.pointer) out["pointer"] = *error.pointer;
  if (error.offset) out["offset"] = *error.offset;
  if (error.limit) {
    out["limit"] = {{"name", error.limit->name}, {"max", error.limit->max}, {"actual", error.limit->actual}};
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "usage: telar_load FILE [--bytes]\n"), 2;
  const bool fromBytes = argc > 2 && std::strcmp(argv[2], "--bytes") == 0;
  const auto file = fromBytes ? readFile(argv[1]) : std::vector<char>();
  json out;
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpuStart = std::clock();
  try {
    const telar::Limits limits;
    const telar::CancelToken cancel;
    const auto scene = fromBytes ? telar::loadBytes(std::as_bytes(std::span(file)), limits, cancel)
                                 : telar::loadPath(argv[1], limits, cancel);
    out = {{"ok", true}, {"scene", json::parse(telar::describeScene(*scene))}};
  } catch (const telar::Error& error) {
    out = toJson(error);
  }
  out["ms"] = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  out["cpuMs"] = 1000.0 * static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC;
  std::puts(out.dump().c_str());
  return out["ok"].get<bool>() ? 0 : 3;
}
