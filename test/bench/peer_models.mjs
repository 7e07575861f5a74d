import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { addGridIndices, sphere } from '../fixtures/geometry.mjs';
import { GlbBuilder } from '../fixtures/glb.mjs';

// Models as platforms store them, of telar's own making: what they cost is in their triangles, textures and layers.

const { abs, cos, hypot, PI, sin } = Math;

/** Soft noise as a photograph has it, the same at each call. @param {number} seed @param {boolean} [relief] blue is 1, as in a normal map */
export async function photograph(side, seed, relief = false) {
  let state = seed;
  const coarse = Buffer.from(
    Array.from({ length: (side / 8) ** 2 * 3 }, (_, i) => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      if (!relief) return state >>> 24;
      return i % 3 === 2 ? 255 : 96 + (state >>> 26);
    }),
  );
  const raw = { width: side / 8, height: side / 8, channels: 3 };
  return new Uint8Array(await sharp(coarse, { raw }).resize(side, side, { kernel: 'cubic' }).jpeg({ quality: 90 }).toBuffer());
}

/** Open tube about y, radius(t) at height t in 0..1, in metres. */
function tube(height, radius, segments, rows, squeeze = 1) {
  const mesh = { positions: [], normals: [], uvs: [], indices: [] };
  for (let row = 0; row <= rows; row++) {
    const t = row / rows;
    for (let segment = 0; segment <= segments; segment++) {
      const phi = (2 * PI * segment) / segments;
      const r = radius(t) * (1 + 0.04 * sin(7 * phi + 9 * t));
      const normal = [sin(phi), 0, cos(phi) / squeeze];
      const length = hypot(...normal);
      mesh.positions.push(r * sin(phi), height * (0.5 - t), r * cos(phi) * squeeze);
      mesh.normals.push(...normal.map((c) => c / length));
      mesh.uvs.push(segment / segments, t);
    }
  }
  addGridIndices(mesh.indices, segments, rows);
  return mesh;
}

/** A body and two sleeves of one double-sided cloth: 20,000 triangles, two JPEGs of 1024 x 1024. */
export async function shirt() {
  const glb = new GlbBuilder();
  const wrap = [10497, 10497];
  const textures = {
    baseColor: { image: await photograph(1024, 5), wrap },
    normal: { image: await photograph(1024, 6, true), wrap, transform: { scale: [8, 8] } },
  };
  const cloth = glb.material({ roughness: 0.9, doubleSided: true, textures });
  glb.add(
    tube(0.7, (t) => 0.24 + 0.05 * abs(t - 0.4), 100, 70, 0.55),
    cloth,
    { name: 'body' },
  );
  for (const side of [-1, 1]) {
    const turn = (side * PI) / 5;
    const rotation = [0, 0, sin(turn / 2), cos(turn / 2)];
    glb.add(
      tube(0.3, (t) => 0.1 - 0.02 * t, 50, 30),
      cloth,
      { name: `sleeve ${side}`, translation: [side * 0.32, 0.2, 0], rotation },
    );
  }
  return glb.bytes();
}

/** A seat and a back of velvet with sheen, on turned legs: 23,000 triangles, a JPEG of 1024 x 1024. */
export async function chair() {
  const glb = new GlbBuilder();
  const relief = { image: await photograph(1024, 7, true), wrap: [10497, 10497], transform: { scale: [6, 6] } };
  const velvet = glb.material({
    baseColor: [0.2, 0.03, 0.05, 1],
    roughness: 0.8,
    textures: { normal: relief },
    layers: { sheen: { sheenColorFactor: [0.6, 0.3, 0.35], sheenRoughnessFactor: 0.4 } },
  });
  const wood = glb.material({ baseColor: [0.25, 0.12, 0.05, 1], roughness: 0.45 });
  glb.add(sphere(0.3, { rings: 48 }), velvet, { name: 'seat', scale: [1, 0.3, 1] });
  glb.add(sphere(0.3, { rings: 48 }), velvet, { name: 'back', scale: [1, 1.1, 0.25], translation: [0, 0.35, -0.27] });
  for (const x of [-0.2, 0.2])
    for (const z of [-0.2, 0.2])
      glb.add(
        tube(0.4, (t) => 0.025 - 0.01 * t, 24, 24),
        wood,
        { name: 'leg', translation: [x, -0.25, z] },
      );
  return glb.bytes();
}

/** A ball with a texture in each of glTF's five slots: 15,400 triangles, five JPEGs of 2048 x 2048. */
export async function helmet() {
  const glb = new GlbBuilder();
  const slots = ['baseColor', 'metallicRoughness', 'normal', 'occlusion', 'emissive'];
  const images = await Promise.all(slots.map((slot, i) => photograph(2048, 11 + i, slot === 'normal')));
  const textures = Object.fromEntries(slots.map((slot, i) => [slot, { image: images[i] }]));
  glb.add(sphere(1, { rings: 62 }), glb.material({ metallic: 1, emissive: [0.1, 0.1, 0.1], textures }), { name: 'helmet' });
  return glb.bytes();
}

const TSHIRT = fileURLToPath(new URL('../../js/assets/tshirt.glb', import.meta.url));

/** The pictures that are drawn by telar and by the browser: `side` in pixels, 512 where it is left out. */
export const cases = async () => [
  { name: 'T-shirt of 58,000 triangles', model: TSHIRT },
  { name: 'the same, 256 x 256', model: TSHIRT, side: 256 },
  { name: 'shirt of 20,000 triangles, two JPEGs', model: await shirt() },
  { name: 'chair with sheen', model: await chair() },
  { name: 'ball with five textures of 2048 x 2048', model: await helmet() },
];
