/**
 * Gives a mesh a material of the file as GLTFLoader does: changed for the geometry's tangents and vertex colours.
 * @param {object} parser - Of GLTFLoader.
 * @param {import('three').Mesh} mesh
 * @param {import('three').Material} material - As the parser loaded it.
 */
export function assignMaterial(parser, mesh, material) {
  mesh.material = material;
  parser.assignFinalMaterial(mesh);
  // GLTFLoader does it twice for instances, which turns normal maps round: every material of a mesh is to look alike.
  if (mesh.isInstancedMesh) parser.assignFinalMaterial(mesh);
}
