// Our tangents against the reference algorithm (npm package mikktspace, the original compiled to WebAssembly).
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { test } from 'node:test';
import { foldedSheet, mirroredSphere, opposedFan, roughSheet, soup, sphere, torus } from './meshes.mjs';

const { generateTangents } = createRequire(import.meta.url)('mikktspace');
const BUILD = process.env.TELAR_BUILD_DIR ?? path.resolve(import.meta.dirname, '../../../out/dev');
const TOOL = path.join(BUILD, 'test/cpp/mesh/tangent_tool');
const MAX_DEGREES = 0.1;
const MIN_SHARE = 0.999;

/** Tangents (4 floats a corner) by our C++. */
function ourTangents({ positions, normals, uvs, indices }) {
  if (!existsSync(TOOL)) throw new Error('tangent_tool is not built; run: cmake --preset dev && cmake --build --preset dev');
  const counts = Uint32Array.of(positions.length / 3, indices.length);
  const input = Buffer.concat([counts, positions, normals, uvs, indices].map((a) => Buffer.from(a.buffer, a.byteOffset, a.byteLength)));
  const output = execFileSync(TOOL, { input, maxBuffer: 1 << 28 });
  return new Float32Array(output.buffer.slice(output.byteOffset, output.byteOffset + output.byteLength));
}

const pick = (stream, width, indices) =>
  Float32Array.from({ length: indices.length * width }, (_, i) => stream[indices[Math.floor(i / width)] * width + (i % width)]);

/** Tangents of the reference by glTF's convention: its v grows upwards, glTF's downwards, so the sign turns. */
function referenceTangents(mesh) {
  const tangents = generateTangents(pick(mesh.positions, 3, mesh.indices), pick(mesh.normals, 3, mesh.indices), pick(mesh.uvs, 2, mesh.indices));
  return tangents.map((value, i) => (i % 4 === 3 ? -value : value));
}

const vector = (array, at, width = 3) => Array.from(array.subarray(at, at + width));
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const degrees = (a, b) => (180 / Math.PI) * 2 * Math.atan2(Math.hypot(...a.map((x, i) => x - b[i])), Math.hypot(...a.map((x, i) => x + b[i])));

/**
 * Why a corner may differ. The reference leaves +X where UVs say nothing, and 0 where tangents cancel, neither of which
 * is a frame; ours is one.
 */
function cause(reference, normal) {
  const length = Math.hypot(...reference);
  if (Math.abs(length - 1) > 1e-3) return 'reference has no tangent';
  if (reference[0] === 1 && reference[1] === 0 && reference[2] === 0 && Math.abs(dot(reference, normal)) > 1e-4) {
    return 'reference leaves its start value';
  }
  return 'differs';
}

function compare(mesh) {
  const ours = ourTangents(mesh), reference = referenceTangents(mesh);
  assert.equal(ours.length, reference.length);
  const causes = {};
  let worst = 0, agree = 0;
  for (let corner = 0; corner < mesh.indices.length; corner++) {
    const t = vector(ours, 4 * corner), r = vector(reference, 4 * corner), n = vector(mesh.normals, 3 * mesh.indices[corner]);
    assert.ok(Math.abs(Math.hypot(...t) - 1) < 1e-4 && Math.abs(dot(t, n)) < 1e-4, `corner ${corner} has no frame: ${t}`);
    const angle = degrees(t, r), sameSign = ours[4 * corner + 3] === reference[4 * corner + 3];
    if (angle < MAX_DEGREES && sameSign) {
      agree++;
      worst = Math.max(worst, angle);
    } else {
      const why = cause(r, n);
      causes[why] = (causes[why] ?? 0) + 1;
    }
  }
  return { corners: mesh.indices.length, agree, worst, causes };
}

const soups = (count, triangles, options) => Array.from({ length: count }, (_, seed) => soup(seed + 1, triangles, options));
const CASES = {
  'sphere 32 x 16': [sphere(32, 16)],
  'sphere 200 x 100': [sphere(200, 100)],
  'mirrored sphere 64 x 32': [mirroredSphere(64, 32)],
  'torus 96 x 48': [torus(96, 48)],
  'folded sheet 90 x 70': [foldedSheet(90, 70)],
  'opposed fan': [opposedFan()],
  'rough sheets': [1, 2, 3, 4, 5].map((seed) => roughSheet(seed, 60, 60)),
  // Real triangles that share vertices at random.
  'soups, fine grid': soups(20, 500, { steps: 64, normals: 40 }),
  // Few points and one or two normals: edges of many triangles, collapsed triangles and UVs.
  'soups, coarse grid': soups(40, 300, { steps: 3, normals: 1 }),
  'soups, medium grid': soups(40, 300, { steps: 4, normals: 2 }),
};

for (const [name, meshes] of Object.entries(CASES)) {
  test(`tangents equal MikkTSpace's: ${name}`, (t) => {
    const total = { corners: 0, agree: 0, worst: 0, causes: {} };
    for (const mesh of meshes) {
      const result = compare(mesh);
      total.corners += result.corners;
      total.agree += result.agree;
      total.worst = Math.max(total.worst, result.worst);
      for (const [why, count] of Object.entries(result.causes)) total.causes[why] = (total.causes[why] ?? 0) + count;
    }
    // Where the reference has no frame there is nothing to agree with.
    const { differs = 0, ...undefinedThere } = total.causes;
    const defined = total.corners - Object.values(undefinedThere).reduce((sum, count) => sum + count, 0);
    t.diagnostic(`${total.agree} of ${total.corners} corners agree, worst of them ${total.worst.toExponential(1)} degrees; ` +
      `others: ${JSON.stringify(total.causes)}`);
    assert.ok(total.agree >= MIN_SHARE * defined, `${differs} of ${defined} corners differ`);
    assert.ok(defined > 0.5 * total.corners, 'too little of the mesh has a reference');
  });
}
