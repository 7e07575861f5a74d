import { seeded } from '../random.mjs';

/**
 * Ambient occlusion of the draped pieces, by ray casting against their own triangles.
 * A ray that leaves the garment sees the set; a ray that hits cloth brings back light from it, which
 * matters for white cotton: the lift is that of Jimenez et al. for a mid albedo.
 * src: Jimenez, Wu, Pesce, Jarabo 2016, "Practical realtime strategies for accurate indirect occlusion", eq. 9
 */

const LEAF = 6;

class Tree {
  constructor(corners) {
    this.corners = corners;
    const count = corners.length / 9;
    this.order = Uint32Array.from({ length: count }, (_, i) => i);
    this.centres = new Float64Array(count * 3);
    for (let i = 0; i < count; i++)
      for (let c = 0; c < 3; c++) this.centres[i * 3 + c] = (corners[i * 9 + c] + corners[i * 9 + 3 + c] + corners[i * 9 + 6 + c]) / 3;
    // Per node: a box of six numbers; first triangle, last triangle, left child, right child (or -1).
    this.boxes = [];
    this.links = [];
    this.#build(0, count);
    this.boxes = Float64Array.from(this.boxes);
    this.links = Int32Array.from(this.links);
    this.stack = new Int32Array(64);
  }

  #build(from, to) {
    const box = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    for (let n = from; n < to; n++) {
      for (let k = 0; k < 9; k++) {
        const value = this.corners[this.order[n] * 9 + k];
        box[k % 3] = Math.min(box[k % 3], value);
        box[(k % 3) + 3] = Math.max(box[(k % 3) + 3], value);
      }
    }
    const index = this.links.length / 4;
    this.boxes.push(...box);
    this.links.push(from, to, -1, -1);
    if (to - from > LEAF) {
      const extent = [0, 1, 2].map((c) => box[c + 3] - box[c]);
      const axis = extent.indexOf(Math.max(...extent));
      this.order.subarray(from, to).sort((a, b) => this.centres[a * 3 + axis] - this.centres[b * 3 + axis] || a - b);
      const middle = (from + to) >> 1;
      this.links[index * 4 + 2] = this.#build(from, middle);
      this.links[index * 4 + 3] = this.#build(middle, to);
    }
    return index;
  }

  /** Does the ray o + t d (0 < t < reach) hit any triangle, from either side? */
  hits(ox, oy, oz, dx, dy, dz, reach) {
    const { boxes, links, stack } = this;
    const ix = 1 / dx;
    const iy = 1 / dy;
    const iz = 1 / dz;
    let depth = 1;
    stack[0] = 0;
    while (depth > 0) {
      const node = stack[--depth];
      const b = node * 6;
      const x0 = (boxes[b] - ox) * ix;
      const x1 = (boxes[b + 3] - ox) * ix;
      const y0 = (boxes[b + 1] - oy) * iy;
      const y1 = (boxes[b + 4] - oy) * iy;
      const z0 = (boxes[b + 2] - oz) * iz;
      const z1 = (boxes[b + 5] - oz) * iz;
      const near = Math.max(Math.min(x0, x1), Math.min(y0, y1), Math.min(z0, z1), 0);
      const far = Math.min(Math.max(x0, x1), Math.max(y0, y1), Math.max(z0, z1), reach);
      if (near > far) continue;
      const left = links[node * 4 + 2];
      if (left >= 0) {
        stack[depth++] = left;
        stack[depth++] = links[node * 4 + 3];
        continue;
      }
      for (let n = links[node * 4]; n < links[node * 4 + 1]; n++) {
        if (this.#crosses(this.order[n] * 9, ox, oy, oz, dx, dy, dz, reach)) return true;
      }
    }
    return false;
  }

  #crosses(at, ox, oy, oz, dx, dy, dz, reach) {
    const k = this.corners;
    const ax = k[at + 3] - k[at];
    const ay = k[at + 4] - k[at + 1];
    const az = k[at + 5] - k[at + 2];
    const bx = k[at + 6] - k[at];
    const by = k[at + 7] - k[at + 1];
    const bz = k[at + 8] - k[at + 2];
    const px = dy * bz - dz * by;
    const py = dz * bx - dx * bz;
    const pz = dx * by - dy * bx;
    const determinant = ax * px + ay * py + az * pz;
    if (Math.abs(determinant) < 1e-14) return false;
    const tx = ox - k[at];
    const ty = oy - k[at + 1];
    const tz = oz - k[at + 2];
    const u = (tx * px + ty * py + tz * pz) / determinant;
    if (u < 0 || u > 1) return false;
    const qx = ty * az - tz * ay;
    const qy = tz * ax - tx * az;
    const qz = tx * ay - ty * ax;
    const v = (dx * qx + dy * qy + dz * qz) / determinant;
    if (v < 0 || u + v > 1) return false;
    const t = (bx * qx + by * qy + bz * qz) / determinant;
    return t > 0 && t < reach;
  }
}

function multiBounce(visible, albedo) {
  const [a, b, c] = [2.0404 * albedo - 0.3324, -4.7951 * albedo + 0.6417, 2.7552 * albedo + 0.6903];
  return Math.max(visible, ((visible * a + b) * visible + c) * visible);
}

function basisOf([x, y, z]) {
  // src: Duff et al. 2017, "Building an orthonormal basis, revisited"
  const sign = z < 0 ? -1 : 1;
  const a = -1 / (sign + z);
  const b = x * y * a;
  return [
    [1 + sign * x * x * a, sign * b, -sign * x],
    [b, sign + y * y * a, -y],
  ];
}

function radicalInverse(i) {
  let [sum, half] = [0, 0.5];
  for (let n = i; n > 0; n >>= 1, half /= 2) if (n & 1) sum += half;
  return sum;
}

function smoothOver(values, indices, rounds) {
  let current = values;
  for (let round = 0; round < rounds; round++) {
    const sum = current.slice();
    const count = new Float64Array(values.length).fill(1);
    for (let t = 0; t < indices.length; t += 3) {
      for (let k = 0; k < 3; k++) {
        const [a, b] = [indices[t + k], indices[t + ((k + 1) % 3)]];
        sum[a] += current[b];
        sum[b] += current[a];
        count[a]++;
        count[b]++;
      }
    }
    current = sum.map((value, i) => value / count[i]);
  }
  return current;
}

/**
 * @param {object[]} pieces - From `cutPieces`.
 * @param {object} [options] - `rays` per vertex; `reach` and `lift` (start above the cloth) in metres;
 *   `albedo` of the cloth that lights itself; `seed`.
 * @returns {Float64Array[]} Occlusion per piece and vertex, 0 dark .. 1 open.
 */
export function bakeOcclusion(pieces, { rays = 64, reach = 0.45, lift = 0.0018, albedo = 0.5, seed = 5 } = {}) {
  const corners = pieces.flatMap(({ positions, indices }) => indices.flatMap((i) => [positions[i * 3], positions[i * 3 + 1], positions[i * 3 + 2]]));
  const tree = new Tree(Float64Array.from(corners));
  const random = seeded(seed);
  return pieces.map(({ positions, normals, indices }) => {
    const open = new Float64Array(positions.length / 3);
    for (let i = 0; i < open.length; i++) {
      const normal = [normals[i * 3], normals[i * 3 + 1], normals[i * 3 + 2]];
      const origin = normal.map((value, c) => positions[i * 3 + c] + value * lift);
      open[i] = openness(tree, origin, normal, { rays, reach, turn: random() });
    }
    return smoothOver(open, indices, 3).map((value) => multiBounce(value, albedo));
  });
}

function openness(tree, origin, normal, { rays, reach, turn }) {
  const [tangent, bitangent] = basisOf(normal);
  let free = 0;
  for (let r = 0; r < rays; r++) {
    const share = (r + 0.5) / rays;
    const angle = 2 * Math.PI * ((radicalInverse(r) + turn) % 1);
    const [sine, cosine] = [Math.sqrt(share), Math.sqrt(1 - share)];
    const [x, y] = [Math.cos(angle) * sine, Math.sin(angle) * sine];
    const dx = tangent[0] * x + bitangent[0] * y + normal[0] * cosine;
    const dy = tangent[1] * x + bitangent[1] * y + normal[1] * cosine;
    const dz = tangent[2] * x + bitangent[2] * y + normal[2] * cosine;
    if (!tree.hits(origin[0], origin[1], origin[2], dx, dy, dz, reach)) free++;
  }
  return free / rays;
}
