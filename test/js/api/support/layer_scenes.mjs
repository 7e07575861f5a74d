import { plane, sphere } from '../../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../../fixtures/glb.mjs';

/** Models whose layers are known without drawing them. */

/** Half a turn about an axis as a quaternion, and parts of it. */
const turn = (degrees, [x, y, z]) => {
  const half = (degrees * Math.PI) / 360;
  return [x * Math.sin(half), y * Math.sin(half), z * Math.sin(half), Math.cos(half)];
};

export const RED = [0.8, 0.1, 0.05, 1];
export const BLUE = [0.1, 0.2, 0.7, 1];

/** A sphere of 0.5 m before a square that leans back by 30 degrees. */
export async function sphereAndSlope() {
  const builder = new GlbBuilder();
  builder.add(sphere(0.5, { rings: 96 }), builder.material({ name: 'red', baseColor: RED, roughness: 0.6 }), { name: 'ball', translation: [0, 0, 0.2] });
  builder.add(plane(2, 2), builder.material({ name: 'blue', baseColor: BLUE, doubleSided: true }), {
    name: 'slope',
    translation: [0.25, 0, -0.6],
    rotation: turn(-30, [1, 0, 0]),
  });
  return builder.bytes();
}

/** A ball of glTF's default material before a red slope. */
export async function ballOfNoMaterial() {
  const builder = new GlbBuilder();
  builder.add(sphere(0.5, { rings: 24 }), null, { name: 'ball', translation: [0, 0, 0.2] });
  builder.add(plane(2, 2), builder.material({ name: 'red', baseColor: RED }), { name: 'slope', translation: [0.25, 0, -0.6] });
  return builder.bytes();
}

/** The inside of the corner of a box of edge 1: floor y = 0, walls x = 0 and z = 0. */
export async function corner() {
  const builder = new GlbBuilder();
  const white = builder.material({ name: 'white' });
  builder.add(plane(1, 1), white, { name: 'floor', translation: [0.5, 0, 0.5], rotation: turn(-90, [1, 0, 0]) });
  builder.add(plane(1, 1), white, { name: 'back', translation: [0.5, 0.5, 0] });
  builder.add(plane(1, 1), white, { name: 'side', translation: [0, 0.5, 0.5], rotation: turn(90, [0, 1, 0]) });
  return builder.bytes();
}

/** A square that floats above a larger one: it throws a shadow of known place. */
export async function canopy() {
  const builder = new GlbBuilder();
  const cloth = builder.material({ name: 'cloth', doubleSided: true });
  builder.add(plane(2, 2), cloth, { name: 'floor', rotation: turn(-90, [1, 0, 0]) });
  builder.add(plane(0.5, 0.5), cloth, { name: 'roof', translation: [0, 0.5, 0], rotation: turn(-90, [1, 0, 0]) });
  return builder.bytes();
}

const subtract = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

/**
 * Part of the hemisphere, weighted by the cosine, that a polygon above the horizon covers.
 * src: Lambert 1760, "Photometria"; Baum, Rushmeier and Winget 1989, "Improving Radiosity Solutions Through the Use of
 * Analytically Determined Form-Factors"
 */
export function formFactor(point, normal, polygon) {
  const rays = polygon.map((corner1) => unit(subtract(corner1, point)));
  const sum = rays.reduce((total, a, i) => {
    const b = rays[(i + 1) % rays.length];
    const across = cross(a, b);
    const angle = Math.atan2(Math.hypot(...across), dot(a, b));
    return total + (angle > 0 ? angle * dot(unit(across), normal) : 0);
  }, 0);
  return Math.abs(sum) / (2 * Math.PI);
}
