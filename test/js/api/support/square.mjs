/**
 * glTF of a square about the origin, in the plane z = 0.
 * @param {number} side metres
 * @returns {Buffer}
 */
export function square(side) {
  const h = side / 2;
  const corners = [-h, -h, 0, h, -h, 0, h, h, 0, -h, -h, 0, h, h, 0, -h, h, 0];
  const bytes = Buffer.from(new Float32Array(corners).buffer);
  return Buffer.from(
    JSON.stringify({
      asset: { version: '2.0' },
      buffers: [{ byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString('base64')}` }],
      bufferViews: [{ buffer: 0, byteLength: bytes.length }],
      accessors: [{ bufferView: 0, componentType: 5126, count: 6, type: 'VEC3', min: [-h, -h, 0], max: [h, h, 0] }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
      nodes: [{ mesh: 0 }],
      scenes: [{ nodes: [0] }],
      scene: 0,
    }),
  );
}
