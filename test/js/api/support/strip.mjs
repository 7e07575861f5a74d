/** A strip of two quads, folded by a right angle at x = 1, and 5 m above it a triangle; the strip's node halves it. */
export function strip() {
  const positions = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 1, 0],
    [0, 1, 0],
    [1, 0, 0],
    [1, 0, -1],
    [1, 1, -1],
    [1, 1, 0],
  ];
  const indices = [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7];
  const floats = Buffer.from(new Float32Array(positions.flat()).buffer);
  const shorts = Buffer.from(new Uint16Array(indices).buffer);
  const bytes = Buffer.concat([floats, shorts]);
  return Buffer.from(
    JSON.stringify({
      asset: { version: '2.0' },
      buffers: [{ byteLength: bytes.length, uri: `data:application/octet-stream;base64,${bytes.toString('base64')}` }],
      bufferViews: [
        { buffer: 0, byteLength: floats.length },
        { buffer: 0, byteOffset: floats.length, byteLength: shorts.length },
      ],
      accessors: [
        { bufferView: 0, componentType: 5126, count: 8, type: 'VEC3', min: [0, 0, -1], max: [1, 1, 0] },
        { bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR' },
        { bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
      ],
      materials: [{ name: 'cloth' }, { name: 'patch' }],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, material: 0 }] }, { primitives: [{ attributes: { POSITION: 2 }, material: 1 }] }],
      nodes: [
        { name: 'strip', mesh: 0, scale: [0.5, 0.5, 0.5] },
        { name: 'patch', mesh: 1, translation: [0, 5, 0] },
      ],
      scenes: [{ nodes: [0, 1] }],
      scene: 0,
    }),
  );
}
