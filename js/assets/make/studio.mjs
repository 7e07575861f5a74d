import { encodeRgbe } from './rgbe.mjs';

export const STUDIO_WIDTH = 512;
export const STUDIO_HEIGHT = 256;

/**
 * Irradiance / pi on a surface that faces the camera (+Z), after scaling. A white cotton of
 * albedo 0.8 then leaves about 0.66 linear, which the neutral tone curve shows near 0.82.
 */
export const FRONT_LEVEL = 0.82;

/**
 * The lamps of the set. Azimuth from +Z (the camera) towards +X, elevation from the horizon,
 * `width` and `height` are full angles, `edge` the share of the half angle that fades, in degrees
 * throughout; `radiance` is relative, the whole set is scaled to FRONT_LEVEL.
 */
const SOFT_BOXES = [
  { name: 'key', azimuth: -56, elevation: 31, width: 58, height: 60, edge: 0.55, radiance: 5.6 },
  { name: 'fill', azimuth: 64, elevation: 10, width: 70, height: 80, edge: 0.8, radiance: 0.7 },
  { name: 'rim-left', azimuth: -142, elevation: 22, width: 26, height: 84, edge: 0.6, radiance: 2.6 },
  { name: 'rim-right', azimuth: 138, elevation: 24, width: 28, height: 84, edge: 0.6, radiance: 3.2 },
  { name: 'overhead', azimuth: 180, elevation: 80, width: 80, height: 60, edge: 0.7, radiance: 1.6 },
];

const RAD = Math.PI / 180;

function smooth(a, b, x) {
  const t = Math.min(1, Math.max(0, (x - a) / (b - a)));
  return t * t * (3 - 2 * t);
}

function frameOf({ azimuth, elevation }) {
  const [sa, ca, se, ce] = [Math.sin(azimuth * RAD), Math.cos(azimuth * RAD), Math.sin(elevation * RAD), Math.cos(elevation * RAD)];
  return { to: [sa * ce, se, ca * ce], right: [ca, 0, -sa], up: [-sa * se, ce, -ca * se] };
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

function softBox(box, direction) {
  const depth = dot(direction, box.frame.to);
  if (depth <= 0.05) return 0;
  const x = Math.atan(Math.abs(dot(direction, box.frame.right)) / depth) / (box.width * 0.5 * RAD);
  const y = Math.atan(Math.abs(dot(direction, box.frame.up)) / depth) / (box.height * 0.5 * RAD);
  // A rounded-square distance: cloth diffusers have no sharp corners and are brightest in the middle.
  const r = (x ** 4 + y ** 4) ** 0.25;
  return box.radiance * (1 - smooth(1 - box.edge, 1, r)) * (1 - 0.18 * Math.min(1, r * r));
}

// The cyclorama: a wall that darkens towards the ceiling, a floor that returns light in front of the
// model, and one soft transition between them, so that no horizon line shows in a reflection.
function cyclorama(direction) {
  const elevation = Math.asin(direction[1]) / RAD;
  const wall = 0.34 - 0.2 * smooth(0, 75, elevation);
  const front = 0.5 + 0.5 * direction[2];
  const floor = 0.3 + 0.42 * front;
  return wall + (floor - wall) * smooth(8, -40, elevation);
}

/** Direction of a texel's centre; u = atan2(z, x) as the client reads equirectangular maps. */
function texelDirection(x, y, width, height) {
  const theta = (0.5 - (y + 0.5) / height) * Math.PI;
  const phi = ((x + 0.5) / width - 0.5) * 2 * Math.PI;
  return [Math.cos(theta) * Math.cos(phi), Math.sin(theta), Math.cos(theta) * Math.sin(phi)];
}

/**
 * Irradiance / pi of an equirectangular map on a surface with the given normal.
 * @param {Float64Array} radiance - Linear, one value per texel.
 * @param {number[]} normal - Unit, world space.
 */
export function irradiance(radiance, width, height, normal) {
  let sum = 0;
  for (let y = 0; y < height; y++) {
    const solidAngle = ((2 * Math.PI) / width) * (Math.PI / height) * Math.cos((0.5 - (y + 0.5) / height) * Math.PI);
    for (let x = 0; x < width; x++) {
      sum += radiance[y * width + x] * Math.max(0, dot(normal, texelDirection(x, y, width, height))) * solidAngle;
    }
  }
  return sum / Math.PI;
}

/** @returns {Float64Array} Linear radiance, one neutral value per texel, scaled to FRONT_LEVEL. */
function studioRadiance(width = STUDIO_WIDTH, height = STUDIO_HEIGHT) {
  const boxes = SOFT_BOXES.map((box) => ({ ...box, frame: frameOf(box) }));
  const radiance = new Float64Array(width * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const direction = texelDirection(x, y, width, height);
      radiance[y * width + x] = boxes.reduce((sum, box) => sum + softBox(box, direction), cyclorama(direction));
    }
  }
  const scale = FRONT_LEVEL / irradiance(radiance, width, height, [0, 0, 1]);
  return radiance.map((value) => value * scale);
}

/** @returns {Buffer} The bundled environment as a Radiance file. */
export function makeStudio() {
  const grey = studioRadiance();
  const rgb = new Float64Array(grey.length * 3);
  for (let i = 0; i < rgb.length; i++) rgb[i] = grey[Math.floor(i / 3)];
  return encodeRgbe(rgb, STUDIO_WIDTH, STUDIO_HEIGHT);
}
