/** A glTF file of one square, written by hand: a library would drop the extensions that it does not know. */

const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const FLOAT = 5126;
const ARRAY_BUFFER = 34962;

const padded = (bytes, fill) => Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3, fill)]);

function chunk(type, bytes) {
  const head = Buffer.alloc(8);
  head.writeUInt32LE(bytes.length, 0);
  head.writeUInt32LE(type, 4);
  return Buffer.concat([head, bytes]);
}

/** Two triangles in the plane z = 0 about the origin, which face +Z; v runs down. */
function vertices(side, [u, v]) {
  const half = side / 2;
  const corner = (x, y) => ({ position: [x * half, y * half, 0], uv: [((x + 1) / 2) * u, ((1 - y) / 2) * v] });
  const [a, b, c, d] = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  return [a, b, c, a, c, d];
}

/**
 * @param {object} square
 * @param {string} square.name
 * @param {number} square.side - Metres.
 * @param {[number, number]} square.repeats - Of the texture, along u and v.
 * @param {object} square.material - glTF material; its textures are indices of `images`.
 * @param {Buffer[]} square.images - PNG.
 * @returns {Uint8Array} GLB
 */
export function squareGlb({ name, side, repeats, material, images }) {
  const corners = vertices(side, repeats);
  const streams = [corners.flatMap(({ position }) => position), corners.flatMap(() => [0, 0, 1]), corners.flatMap(({ uv }) => uv)].map((values) =>
    Buffer.from(Float32Array.from(values).buffer),
  );
  const parts = [...streams, ...images].map((bytes) => padded(bytes, 0));
  const offsets = parts.map((_, i) => parts.slice(0, i).reduce((sum, { length }) => sum + length, 0));
  const lengths = [...streams, ...images].map(({ length }) => length);
  const bufferViews = lengths.map((byteLength, i) => ({ buffer: 0, byteOffset: offsets[i], byteLength, ...(i < streams.length && { target: ARRAY_BUFFER }) }));
  const half = side / 2;
  const extensions = Object.keys(material.extensions ?? {});
  const accessor = (bufferView, type, rest) => ({ bufferView, componentType: FLOAT, count: corners.length, type, ...rest });
  const json = {
    asset: { version: '2.0', generator: 'telar', copyright: 'Copyright telar. Part of telar, under its licence; free to render, copy and show with it.' },
    ...(extensions.length > 0 && { extensionsUsed: extensions }),
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name, mesh: 0 }],
    meshes: [{ name, primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, material: 0 }] }],
    materials: [material],
    textures: images.map((_, source) => ({ source })),
    images: images.map((_, i) => ({ bufferView: streams.length + i, mimeType: 'image/png' })),
    accessors: [accessor(0, 'VEC3', { min: [-half, -half, 0], max: [half, half, 0] }), accessor(1, 'VEC3'), accessor(2, 'VEC2')],
    bufferViews,
    buffers: [{ byteLength: parts.reduce((sum, { length }) => sum + length, 0) }],
  };
  const chunks = Buffer.concat([chunk(JSON_CHUNK, padded(Buffer.from(JSON.stringify(json)), 0x20)), chunk(BIN_CHUNK, Buffer.concat(parts))]);
  const head = Buffer.alloc(12);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(head.length + chunks.length, 8);
  return new Uint8Array(Buffer.concat([head, chunks]));
}
