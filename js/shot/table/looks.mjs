import { choice } from './rows.mjs';

/**
 * Looks by name: plain shots. Lights are directions, so that they fit a model of any size; cameras are framed by the model's own
 * proportions. The front of a garment is +Z, up is +Y.
 *
 * Key, fill and rim as product photography has them: the key from the upper left, the fill weaker from the other side, the rim from
 * behind, which parts a dark garment from what is behind it.
 */
const key = { type: 'directional', position: [-1, 1.2, 1.6], intensity: 1.6 };
const fill = { type: 'directional', position: [1.4, 0.3, 1.2], intensity: 0.5 };
const rim = { type: 'directional', position: [0.8, 1.1, -1.5], intensity: 1.2 };

/** Between a garment that nobody wears and its shadow on the floor, in heights of the garment: near enough to belong to it. */
const HANGING = 0.1;

/** A white shirt keeps its folds; what is dark stays dark. */
const metering = { percentile: 0.98, level: 0.95, least: 0.6, most: 1.15 };

export const LOOKS = Object.freeze({
  catalogue: {
    doc: 'a garment from the front before white, lit from the upper left, as shops list it',
    shot: {
      camera: { view: 'front', fovY: 15, fit: 0.88 },
      background: 'white',
      environment: { map: 'studio', intensity: 0.75 },
      lights: [key, fill],
      metering,
    },
  },
  ghost: {
    doc: 'a garment as if worn by nobody: even light, no background, so that the inside of the neck is seen',
    shot: {
      camera: { azimuth: 0, elevation: 6, fovY: 15, fit: 0.9 },
      background: 'transparent',
      environment: { map: 'studio', intensity: 1.05 },
      ground: { opacity: 0.3, gap: HANGING },
      metering,
    },
  },
  hanger: {
    doc: 'a garment that hangs: light from above, grey behind it',
    shot: {
      camera: { azimuth: -12, elevation: 2, fovY: 20, fit: 0.84 },
      background: '#e9e7e4',
      environment: { map: 'studio', intensity: 0.6 },
      lights: [{ type: 'directional', position: [-0.5, 2, 1.1], intensity: 1.8 }, fill],
      ground: { opacity: 0.4, gap: HANGING },
      metering,
    },
  },
  'flat-lay': {
    doc: 'a garment as it lies on paper, without perspective, in soft light and without a shadow: the ground of a shot is level, and this paper stands upright',
    shot: {
      camera: { view: 'front', projection: 'orthographic', fit: 0.9 },
      background: '#f7f6f4',
      environment: { map: 'studio', intensity: 0.9 },
      lights: [{ type: 'directional', position: [-1, 1, 2.4], intensity: 0.7 }],
      metering,
    },
  },
  furniture: {
    doc: 'what stands on the floor, from a corner and a little above, with its shadow',
    shot: {
      camera: { azimuth: 35, elevation: 14, fovY: 25, fit: 0.82 },
      background: 'white',
      environment: { map: 'studio', intensity: 0.85 },
      lights: [key, fill],
      ground: { opacity: 0.55 },
      metering,
    },
  },
  hero: {
    doc: 'a garment from below its middle, rim light against a dark background',
    shot: {
      camera: { azimuth: 28, elevation: -4, fovY: 32, fit: 0.9 },
      background: '#23262b',
      environment: { map: 'studio', intensity: 0.45 },
      lights: [
        { ...key, intensity: 2.4 },
        { ...rim, intensity: 3.5 },
      ],
      toneMapping: 'agx',
      metering,
    },
  },
});

const DOCS = Object.entries(LOOKS).map(([name, { doc }]) => `"${name}": ${doc}`);

export const look = choice(
  `Keys that the shot leaves out are taken from a look, those of \`camera\` one by one (with a \`scale\` it has no lens, and in a format without transparency its background is white); \`telar looks --json\` prints them as shots. ${DOCS.join('; ')}`,
  ['none', ...Object.keys(LOOKS)],
  { default: 'none', drawn: false },
);
