// telar_load FILE [--bytes]: loads one model and prints one JSON line, for test/robust.
// {ok: true, ms, scene} or {ok: false, ms, code, message, pointer?, offset?}; exit status 0, or 3 on an error.
#include <chrono>
#include <cstdio>
#include <cstring>
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
  std::puts(out.dump().c_str());
  return out["ok"].get<bool>() ? 0 : 3;
}
