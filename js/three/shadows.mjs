/** Name of the mesh that catches the shadows, so that the next shot can replace it. */
const GROUND = 'telar ground';

/** Drawn before everything else that is see-through, whatever lies farther away. */
const FIRST = -1;

/**
 * Sets a light's shadow up from the resolved shot: every value comes from there.
 *
 * @param {import('three').Light} object - Directional, spot or point light.
 * @param {object} light - The same light in the resolved shot.
 */
export function applyLightShadow(object, { castShadow, shadow }) {
  object.castShadow = castShadow === true;
  if (!object.castShadow) return;
  const { mapSize, radius, intensity, bias, normalBias, near, far, left, right, bottom, top, focus } = shadow;
  Object.assign(object.shadow, { radius, intensity, bias, normalBias });
  object.shadow.mapSize.set(mapSize, mapSize);
  if (object.isSpotLight) object.shadow.focus = focus;
  Object.assign(object.shadow.camera, object.isDirectionalLight ? { near, far, left, right, bottom, top } : { near, far });
  object.shadow.camera.updateProjectionMatrix();
}

/**
 * Turns shadow maps on where a light of the shot casts a shadow, and lets the model's meshes cast and receive them. Lights
 * of the model cast none, as GLTFLoader leaves them.
 *
 * @param {object} shot - Resolved shot.
 * @param {typeof import('three')} THREE
 * @param {object} target - As of applyShot.
 */
export function applyShadows(shot, THREE, { renderer, scene, model }) {
  const casts = shot.lights.some(({ castShadow }) => castShadow === true);
  renderer.shadowMap.enabled = casts;
  // What a renderer has by default, and as fixed as a picture: the filter's noise goes by the pixel's place.
  renderer.shadowMap.type = THREE.PCFShadowMap;
  model?.scene.traverse((object) => {
    if (object.isMesh) object.castShadow = object.receiveShadow = casts;
  });
  applyGround(shot.ground, THREE, scene);
}

/** @param {import('three').Scene} scene @returns {() => void} Shows it again. */
export function hideGround(scene) {
  const ground = scene.getObjectByName(GROUND);
  if (ground) ground.visible = false;
  return () => {
    if (ground) ground.visible = true;
  };
}

function applyGround(ground, THREE, scene) {
  const last = scene.getObjectByName(GROUND);
  last?.removeFromParent();
  last?.geometry.dispose();
  last?.material.dispose();
  if (ground === 'none') return;
  const material = new THREE.ShadowMaterial({ opacity: ground.opacity, depthWrite: false });
  const mesh = new THREE.Mesh(levelRectangle(THREE, ground.size), material);
  mesh.name = GROUND;
  mesh.position.fromArray(ground.position);
  mesh.receiveShadow = true;
  mesh.renderOrder = FIRST;
  scene.add(mesh);
}

/** Two triangles about the origin that face +Y; size in metres along x and z. */
function levelRectangle(THREE, [width, depth]) {
  const [x, z] = [width / 2, depth / 2];
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute([-x, 0, -z, -x, 0, z, x, 0, z, x, 0, -z], 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute([0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0], 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}
