#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "telar/scene.h"

namespace telar::asset {

/// `mode` of a glTF primitive (GL's own enums).
enum Mode { MODE_POINTS, MODE_LINES, MODE_LINE_LOOP, MODE_LINE_STRIP, MODE_TRIANGLES, MODE_STRIP, MODE_FAN };

/// Vertex indices in drawing order; none = the vertices as they come.
using Order = std::optional<std::vector<std::uint32_t>>;

/// Turns the order of a glTF mode into one that Topology can draw: strips and fans become triangles with the winding
/// that the glTF specification gives them (section 3.7.2.1), and incomplete last elements are cut off.
Topology toTopology(int mode, std::size_t vertices, Order& order);

/// Removes each element (point, line, triangle) that touches a bad vertex; strips and loops become plain lines first.
/// @return how many elements were removed
std::size_t dropElements(Topology& topology, std::size_t vertices, const std::vector<bool>& bad, Order& order);

/// Whether not even one element is complete.
bool drawsNothing(Topology topology, std::size_t vertices, const Order& order);

/// Vertices that are drawn, each once; empty where all are.
std::vector<std::uint32_t> usedVertices(std::size_t vertices, const std::vector<std::uint32_t>& indices);
/// Bounds of vertices that are drawn. @param used  of usedVertices()
Bounds drawnBounds(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& used);

}  // namespace telar::asset
