import { readFile } from 'node:fs/promises';
import { drape } from '../../../test/fixtures/drape.mjs';
import { ENVIRONMENTS } from '../../../test/fixtures/index.mjs';
import { GlbBuilder } from '../../../test/fixtures/glb.mjs';

/** What the pictures of cloths are taken of: a shirt, a drape and a ball, from afar and from near, in three skies. */

const DRAPE_M = 0.4;
const BALL_M = 0.06; // radius

/** A ball in cloth; its radius in metres. */
export const ballOf = (radius) => glbOf(dome(radius));

/** The half of a ball that faces the camera; u and v are metres along it, so that cloth is hardly stretched. */
function dome(radius, cells = 64) {
  const mesh = { positions: [], normals: [], uvs: [], indices: [] };
  for (let ring = 0; ring <= cells; ring++) {
    const angle = (ring / cells) * 0.53 * Math.PI; // a little beyond the edge that is seen
    for (let i = 0; i <= 2 * cells; i++) {
      const around = (i / cells) * Math.PI;
      const normal = [Math.sin(angle) * Math.cos(around), Math.sin(angle) * Math.sin(around), Math.cos(angle)];
      mesh.normals.push(...normal);
      mesh.positions.push(...normal.map((c) => c * radius));
      mesh.uvs.push(radius * angle * Math.cos(around), -radius * angle * Math.sin(around));
    }
  }
  const at = (ring, i) => ring * (2 * cells + 1) + i;
  for (let ring = 0; ring < cells; ring++) {
    for (let i = 0; i < 2 * cells; i++) mesh.indices.push(at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i), at(ring + 1, i + 1), at(ring, i + 1));
  }
  return mesh;
}

async function glbOf(mesh) {
  const builder = new GlbBuilder();
  builder.add(mesh, builder.material({ name: 'cloth', doubleSided: true }));
  return builder.bytes();
}

const near = (height, position, target) => ({ projection: 'orthographic', height, position, target, near: 0.05, far: 3 });

/** Models with their two cameras; the near one shows `height` metres. */
export const SCENES = {
  shirt: {
    model: () => readFile(new URL('../tshirt.glb', import.meta.url)),
    far: { azimuth: 25, elevation: 8 },
    near: near(0.05, [0.3, 0.6, 1], [0.03, 0.45, 0.1]),
  },
  drape: {
    model: () => glbOf(drape({ side: DRAPE_M })),
    far: { position: [0, 0.12, 1.05], target: [0, -0.02, 0], fovY: 15.5 },
    near: near(0.05, [0.2, 0.2, 1], [0.03, 0.04, 0.08]),
  },
  ball: {
    model: () => ballOf(BALL_M),
    far: { ...near(0.13, [0, 0, 1], [0, 0, 0]) },
    near: near(0.04, [0, 0, 1], [0.012, 0.012, 0]),
  },
};

/** .hdr bytes by name. */
export const SKIES = Object.fromEntries(['soft-studio', 'sunny-sky', 'overcast-sky'].map((name) => [name, ENVIRONMENTS[name]]));

/** One colour for all, so that cloths differ by what they are. */
export const TAN = '#8c7a66';
export const PAPER = '#f4f1ec';

/** @param {string} preset @param {number} side - Pixels. @returns {object} what every shot of a cloth has */
export const shotOf = (preset, side) => ({
  size: { width: side, height: side },
  shading: 'fabric',
  background: PAPER,
  materials: { '*': { preset, color: TAN } },
  output: { format: 'png' },
});
