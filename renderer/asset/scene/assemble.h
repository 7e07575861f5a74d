#pragma once
#include "asset/geometry/geometry.h"
#include "asset/material/images.h"
#include "asset/scene/graph.h"

namespace telar::asset {

/// Makes the scene of a checked document: nodes of the drawn scene, the meshes, materials and images that they reach.
/// @throws Error{E_NO_GEOMETRY, ...} as loadPath() says
class Assembler {
 public:
  explicit Assembler(const GeometryReader::Sources& sources) : from_(sources), geometry_(sources) {}

  Scene assemble();

 private:
  const tinygltf::Model& model() const { return from_.document.model; }

  void checkWork(const std::vector<Visit>& visits) const;
  void addNode(const Visit& visit);
  void addMesh(Node& node);
  void findJoints(const std::vector<Visit>& visits);
  std::vector<float> weightsOf(const tinygltf::Node& source, int node) const;
  int lightOf(const tinygltf::Node& source);
  int cameraOf(const tinygltf::Node& source) const;
  void readCameras();
  int readMesh(int mesh);
  void readMotion(const std::vector<int>& nodes);
  void readMaterials();
  void loadImages();
  void chargeDeformedCopies();
  void readNames();

  GeometryReader::Sources from_;
  GeometryReader geometry_;
  Scene scene_;
  std::vector<int> meshes_;          ///< by mesh of the file: index into scene_.meshes, -1 = not read yet
  std::vector<std::size_t> joints_;  ///< see findJoints()
  std::vector<int> cameras_;         ///< by camera of the file: index into scene_.cameras, -1 = malformed
};

}  // namespace telar::asset
