#pragma once
#include <functional>

#include "frames.h"

namespace telar::numerics {

/// A scene at one extreme.
struct ExtremeRow {
  std::string name;
  std::shared_ptr<Scene> scene;
  Shot shot;
  std::vector<std::byte> environment;
  /// What else the picture has to be, as a figure of the linear frame and its bar; empty where it need only be finite.
  std::function<double(const Frame&)> measure;
  double high = 0, low = 0;
};

/// Every extreme of light, surface and view that can be drawn, for one shading.
std::vector<ExtremeRow> extremeRows(ShadingModel shading);

}  // namespace telar::numerics
