import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { boundsOf, readDocument } from './bounds.mjs';
import { ASSETS, SHARED_MODELS } from './places.mjs';
import { CASE_ENVIRONMENT, LIGHTS, shot } from './shot.mjs';

/** Only files whose features are drawn today: [name, path, azimuth, elevation]. */
const MODELS = [
  ['box', 'Box/glTF_Binary/Box.glb', 35, 25],
  ['box-draco', 'Box/glTF_Binary/Box_Draco.glb', 35, 25],
  ['box-draco-gltf', 'BoxDraco/BoxDraco.gltf', 35, 25],
  ['box-vertex-colors', 'BoxVertexColors/BoxVertexColors.glb', 35, 25],
  ['duck', 'Duck/glTF_Binary/Duck.glb', 40, 15],
  ['duck-gltf', 'Duck/glTF/Duck.gltf', -60, 20],
  ['heart-draco', 'heart_draco/heart_draco.glb', 20, 10],
  ['lights', 'Lights/Lights.glb', 30, 30],
  ['multi-uv', 'MultiUVTest/glTF/MultiUVTest.gltf', 30, 20],
  ['normal-tangent', 'NormalTangentTest/NormalTangentTest.glb', 0, 0],
  ['sparse', 'SimpleSparseAccessor/glTF/SimpleSparseAccessor.gltf', 0, 0],
  ['texture-settings', 'TextureSettingsTest/glTF/TextureSettingsTest.gltf', 0, 0],
  ['texture-transform', 'TextureTransformTest/glTF/TextureTransformTest.gltf', 0, 0],
  ['dense-sphere', 'TransformFunctions/DenseSphere.glb', 30, 20],
  ['shapes', 'TransformFunctions/ShapeCollection.glb', 30, 30],
  ['two-cubes', 'TransformFunctions/TwoCubes.glb', 30, 20],
  ['two-sided', 'TwoSidedPlane/glTF/TwoSidedPlane.gltf', 20, 40],
  ['two-sided-back', 'TwoSidedPlane/glTF/TwoSidedPlane.gltf', 160, -40],
  ['unlit', 'UnlitTest/glTF/UnlitTest.gltf', 0, 0],
  ['vertex-color', 'VertexColorTest/glTF/VertexColorTest.gltf', 0, 0],
];

/**
 * Cases of models beneath ../shared/models, each by itself in the picture; where the folder is absent, there are none.
 * @param {[string, string, number, number][]} rows - [name, path, azimuth, elevation]
 */
export function sharedCases(rows) {
  return rows.filter(([, file]) => existsSync(path.join(SHARED_MODELS, file))).map((row) => sharedCase(...row));
}

/** The bundled garment as `npm run thumbnail` draws it, from other sides and in another colourway. */
const BUNDLED_CASES = [
  bundledCase('tshirt-front', { view: 'front' }, {}, true),
  bundledCase('tshirt-three-quarter', { view: 'three-quarter' }, { variant: 'indigo' }),
  bundledCase('tshirt-back', { view: 'back' }, { lights: [LIGHTS.directional], background: 'white' }),
];

function bundledCase(name, camera, overrides, fast = false) {
  const bounds = boundsOf(readDocument(readFileSync(path.join(ASSETS, 'tshirt.glb'))));
  const settings = { size: 512, camera, environment: CASE_ENVIRONMENT, ...overrides };
  return { name, model: 'bundled:tshirt.glb', environment: 'studio', shot: shot(settings, bounds), fast };
}

function sharedCase(name, file, azimuth, elevation) {
  const bounds = boundsOf(readDocument(readFileSync(path.join(SHARED_MODELS, file))));
  const overrides = {
    size: 512,
    camera: { azimuth, elevation },
    environment: CASE_ENVIRONMENT,
    lights: [LIGHTS.directional],
  };
  return {
    name: `shared-${name}`,
    model: `shared:${file}`,
    environment: 'shared:env/brown_photostudio_02_1k.hdr',
    shot: shot(overrides, bounds),
    fast: false,
  };
}

/** What another case shows as well: the same model in another container. */
const EXTENDED = ['shared-box-draco-gltf', 'shared-duck-gltf', 'shared-two-cubes'];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [...BUNDLED_CASES, ...sharedCases(MODELS)].map((item) => ({ ...item, extended: EXTENDED.includes(item.name) }));
