#pragma once
#include <vector>

namespace telar::lobes {

struct Node {
  double at, weight;
};

/// Nodes and weights on [0, 1]: exact for polynomials up to degree 2 count - 1.
std::vector<Node> gaussLegendre(int count);

}  // namespace telar::lobes
