// telar_draw MODEL SHOT.json OUT.raw [--env FILE] [--backend NAME] [--all-features] [--repeat N]
// Draws one resolved shot without Node: OUT.raw gets the frame's bytes, stdout the frame's info as JSON.
#include <time.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "telar/load.h"
#include "telar/renderer.h"

namespace {

std::vector<std::byte> readAll(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  return {bytes, bytes + text.size()};
}

double cpuMs() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) / 1e6;
}

telar::Backend backendOf(const std::string& name) {
  if (name == "egl-device") return telar::Backend::kEglDevice;
  if (name == "egl-surfaceless") return telar::Backend::kEglSurfaceless;
  if (name == "osmesa") return telar::Backend::kOsmesa;
  return telar::Backend::kAuto;
}

int run(int argc, char** argv) {
  telar::RendererOptions options;
  options.assetDirectory = TELAR_SOURCE_DIR "/js/assets";
  std::string environmentFile;
  int repeat = 1;
  for (int i = 4; i < argc; ++i) {
    const std::string flag = argv[i];
    if (flag == "--all-features") options.allFeatures = true;
    if (i + 1 >= argc) continue;
    if (flag == "--env") environmentFile = argv[i + 1];
    if (flag == "--backend") options.backend = backendOf(argv[i + 1]);
    if (flag == "--repeat") repeat = std::atoi(argv[i + 1]);
  }
  const auto shotText = readAll(argv[2]);
  const telar::Shot shot = telar::parseShot({reinterpret_cast<const char*>(shotText.data()), shotText.size()});
  const auto environment = environmentFile.empty() ? std::vector<std::byte>() : readAll(environmentFile);
  const telar::CancelToken cancel;
  const auto scene = telar::loadPath(argv[1], options.limits, cancel);
  const auto renderer = telar::Renderer::create(options);
  telar::Frame frame;
  for (int i = 0; i < repeat; ++i) {
    telar::FrameInfo info;
    const double before = cpuMs();
    frame = renderer->draw(scene, shot, environment, cancel, info);
    auto json = nlohmann::ordered_json::parse(info.json);
    json["cpuMs"] = cpuMs() - before;  // all threads of the process
    std::cout << json.dump() << "\n";
  }
  std::ofstream(argv[3], std::ios::binary)
      .write(reinterpret_cast<const char*>(frame.pixels.data()), static_cast<std::streamsize>(frame.pixels.size()));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4)
    return std::fputs(
               "usage: telar_draw MODEL SHOT.json OUT.raw [--env FILE] [--backend NAME] [--all-features] [--repeat "
               "N]\n",
               stderr),
           2;
  try {
    return run(argc, argv);
  } catch (const telar::Error& error) {
    std::cerr << error.code << ": " << error.what() << (error.pointer ? " at " + *error.pointer : "") << "\n";
    return 3;
  }
}
