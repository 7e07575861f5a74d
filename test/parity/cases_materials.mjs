// Parts in another cloth: `materials` of the shot, which server and browser put on by themselves.
import { makeCase } from './make_case.mjs';
import { CAMERAS, LIGHTS } from './shot.mjs';

const NAVY = [0.02, 0.035, 0.08];

/** name: model, materials, and whether all shadings draw it. */
const WORN = {
  denim: ['cloth', { '*': { preset: 'denim', color: NAVY } }],
  'denim-turned': ['cloth', { '*': { preset: 'denim', color: NAVY, rotation: 35, scale: 6 } }],
  'satin-turned-tangents': ['cloth-tangents', { '*': { preset: 'satin', color: [0.5, 0.12, 0.2], rotation: 35, scale: 20 } }],
  'leather-own-color': ['cloth', { '*': { preset: 'leather', metresPerUv: [0.3, 0.2] } }],
  lace: ['cloth', { '*': { preset: 'lace', color: [0.8, 0.78, 0.72], scale: 4 } }],
  // Its relief runs along lines.
  'corduroy-turned': ['cloth', { '*': { preset: 'corduroy', color: [0.24, 0.14, 0.05], rotation: 35, scale: 2 } }],
  recolored: ['cloth', { '*': { color: NAVY } }],
  // A preset's sheen is dyed: more in green and blue than in red.
  velvet: ['cloth', { '*': { preset: 'velvet', color: [0.3, 0.02, 0] } }],
  chiffon: ['cloth', { '*': { preset: 'chiffon', color: [0.7, 0.4, 0.45], scale: 4 } }],
  'no-uvs': ['no-uvs', { '*': { preset: 'leather', color: NAVY } }],
  variant: ['variants', { '*': { preset: 'towel', color: [0.75, 0.72, 0.62], scale: 2 } }, { variant: 'blue' }],
  skin: ['skin', { '*': { preset: 'leather', color: [0.12, 0.05, 0.025], scale: 3 } }],
  instances: ['instances', { 0: { preset: 'nylon-shell', color: [0.6, 0.16, 0.02], scale: 20 } }],
};

/** Sees the bundled drape, in whose folds up to six layers lie over each other. */
const DRAPE = { projection: 'perspective', fovY: 30, position: [0.4, 0.55, 0.85], target: [0, 0.2, 0], near: 0.4, far: 2 };
const PARALLEL = { projection: 'orthographic', height: 0.5, position: DRAPE.position, target: DRAPE.target, near: DRAPE.near, far: DRAPE.far };
const ROSE = [0.7, 0.4, 0.45];

/** Nets and sheer cloth in folds, whose triangles the shading "fabric" draws far to near. */
const FOLDED = {
  'chiffon-folds': ['bundled:fabrics.glb', { '*': { preset: 'chiffon', color: ROSE } }, { camera: DRAPE }],
  'tulle-folds': ['bundled:fabrics.glb', { '*': { preset: 'tulle', color: ROSE } }, { camera: DRAPE }],
  'mesh-folds': ['bundled:fabrics.glb', { '*': { preset: 'athletic-mesh', color: NAVY } }, { camera: PARALLEL }],
  'chiffon-skin': ['skin', { '*': { preset: 'chiffon', color: ROSE } }, { pose: { animation: 0, time: 0.85 } }],
};

const wornCases = (worn, shadings, fast) =>
  Object.entries(worn).flatMap(([name, [model, materials, rest]]) =>
    shadings.map((shading) =>
      makeCase(
        `materials-${name}-${shading}`,
        model,
        null,
        { camera: CAMERAS.quarter, lights: [LIGHTS.directional, LIGHTS.ambient], shading, ...rest, materials },
        name === fast,
      ),
    ),
  );

export const CASES = [...wornCases(WORN, ['three', 'fabric'], 'denim-turned'), ...wornCases(FOLDED, ['fabric'], 'mesh-folds')];
