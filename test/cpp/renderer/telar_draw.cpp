// telar_draw MODEL SHOT.json OUT.raw [--env FILE] [--backend NAME] [--all-features] [--repeat N] [--debug NAME,...]
//            [--shader-edits FILE.json] [--cache FOLDER] [--slice-ms N]
// Draws one resolved shot without Node: OUT.raw gets the frame's bytes, stdout the frame's info as JSON. --debug draws
// these debug outputs instead, one after another. --shader-edits changes the shaders before they are compiled.
#include <time.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "editable_shaders.h"
#include "telar/load.h"
#include "telar/pose.h"
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

telar::RendererOptions::LeaveOut leaveOut(const std::string& name) {
  using LeaveOut = telar::RendererOptions::LeaveOut;
  if (name == "always") return LeaveOut::kAlways;
  return name == "never" ? LeaveOut::kNever : LeaveOut::kWhereItPays;
}

struct Arguments {
  telar::RendererOptions options;
  std::string environmentFile, shaderEdits, debugOutputs;
  int repeat = 1;
};

Arguments parseArguments(int argc, char** argv) {
  Arguments arguments;
  arguments.options.assetDirectory = TELAR_SOURCE_DIR "/js/assets";
  for (int i = 4; i < argc; ++i) {
    const std::string flag = argv[i];
    if (flag == "--all-features") arguments.options.allFeatures = true;
    if (i + 1 >= argc) continue;
    if (flag == "--env") arguments.environmentFile = argv[i + 1];
    if (flag == "--backend") arguments.options.backend = backendOf(argv[i + 1]);
    if (flag == "--cache") {
      arguments.options.cacheDirectory = argv[i + 1];
      arguments.options.cacheBytes = 64u << 20;
    }
    if (flag == "--hidden") {
      arguments.options.hiddenTriangles = leaveOut(argv[i + 1]);
      arguments.options.visibilityBuffer = telar::RendererOptions::LeaveOut::kNever;  // it has no use for them
    }
    if (flag == "--buffer") arguments.options.visibilityBuffer = leaveOut(argv[i + 1]);
    if (flag == "--slice-ms") arguments.options.sliceMs = std::atof(argv[i + 1]);
    if (flag == "--repeat") arguments.repeat = std::atoi(argv[i + 1]);
    if (flag == "--debug") arguments.debugOutputs = argv[i + 1];
    if (flag == "--shader-edits") arguments.shaderEdits = argv[i + 1];
  }
  return arguments;
}

/// The shot once, or once for each debug output.
std::vector<telar::Shot> shotsOf(const std::vector<std::byte>& text, const std::string& debugOutputs) {
  auto json = nlohmann::json::parse(reinterpret_cast<const char*>(text.data()),
                                    reinterpret_cast<const char*>(text.data()) + text.size());
  if (debugOutputs.empty()) return {telar::parseShot(json.dump())};
  std::vector<telar::Shot> shots;
  std::istringstream names(debugOutputs);
  for (std::string name; std::getline(names, name, ',');) {
    json["debugOutput"] = name;
    shots.push_back(telar::parseShot(json.dump()));
  }
  return shots;
}

int run(int argc, char** argv) {
  const Arguments arguments = parseArguments(argc, argv);
  if (!arguments.shaderEdits.empty()) telar::test::editShaders(arguments.shaderEdits);
  const std::vector<telar::Shot> shots = shotsOf(readAll(argv[2]), arguments.debugOutputs);
  const auto environment =
      arguments.environmentFile.empty() ? std::vector<std::byte>() : readAll(arguments.environmentFile);
  const telar::CancelToken cancel;
  // As three.js, which draws on without what it cannot read; a case that must not lack anything is told by its picture.
  const auto model = telar::loadPath(argv[1], arguments.options.limits, cancel, {.tolerant = true});
  const auto renderer = telar::Renderer::create(arguments.options);
  std::ofstream out(argv[3], std::ios::binary);
  for (const telar::Shot& shot : shots) {
    const auto scene = shot.pose ? telar::poseScene(model, *shot.pose, cancel) : model;
    telar::Frame frame;
    for (int i = 0; i < arguments.repeat; ++i) {
      telar::FrameInfo info;
      const double before = cpuMs();
      frame = renderer->draw(scene, shot, environment, cancel, info);
      auto json = nlohmann::ordered_json::parse(info.json);
      json["cpuMs"] = cpuMs() - before;  // all threads of the process
      std::cout << json.dump() << "\n";
    }
    out.write(reinterpret_cast<const char*>(frame.pixels.data()), static_cast<std::streamsize>(frame.pixels.size()));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4)
    return std::fputs(
               "usage: telar_draw MODEL SHOT.json OUT.raw [--env FILE] [--backend NAME] [--all-features] [--repeat "
               "N] [--debug NAME,...] [--shader-edits FILE.json] [--cache FOLDER] [--slice-ms N]\n",
               stderr),
           2;
  try {
    return run(argc, argv);
  } catch (const telar::Error& error) {
    std::cerr << error.code << ": " << error.what() << (error.pointer ? " at " + *error.pointer : "") << "\n";
    return 3;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
