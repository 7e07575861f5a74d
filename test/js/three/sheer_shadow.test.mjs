import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { shadingText } from '../../../js/build/shading/translate.mjs';
import { applyShading, loadFabricMaterial } from '../../../js/three/index.mjs';
import { castSheerShadow } from '../../../js/three/shading/sheer_shadow.mjs';
import '../built.mjs';

const TEXT = shadingText('fabric').layerThreshold;

/** A mesh of a scene without a parser, with a material of three.js's own. */
function sceneOf(parameters) {
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(), new THREE.MeshStandardMaterial(parameters));
  return { mesh, model: { scene: new THREE.Group().add(mesh) } };
}

const SHEER = { transparent: true, opacity: 0.4 };

/** A shader of three.js's as it compiles it for a caster. */
function compiled(caster, chunk = 'depth_frag') {
  const shader = { uniforms: {}, fragmentShader: THREE.ShaderChunk[chunk] };
  caster.onBeforeCompile(shader);
  return shader;
}

test('sheer cloth casts by its alpha, of every kind of light, as it is at the time', async () => {
  const { mesh, model } = sceneOf(SHEER);
  await applyShading(model, 'fabric', { THREE });
  assert.ok(mesh.customDepthMaterial.isMeshDepthMaterial);
  assert.ok(mesh.customDistanceMaterial.isMeshDistanceMaterial);
  assert.equal(mesh.customDepthMaterial, mesh.customDepthMaterial, 'one for all frames');
  const shader = compiled(mesh.customDepthMaterial);
  assert.equal(shader.uniforms.telar_alphaFactor.value, 0.4);
  mesh.material.opacity = 0.7;
  assert.equal(shader.uniforms.telar_alphaFactor.value, 0.7);
  for (const { fragmentShader } of [shader, compiled(mesh.customDistanceMaterial, 'distance_frag')]) {
    assert.match(fragmentShader, /if \(telar_alphaFactor \* diffuseColor\.a <= telar_layerThreshold\(\)\) discard;/);
    assert.match(fragmentShader, /float telar_layerThreshold\(\)/);
  }
});

test('what is not sheer casts as three.js has it', async () => {
  for (const parameters of [{}, { ...SHEER, alphaTest: 0.5 }]) {
    const { mesh, model } = sceneOf(parameters);
    await applyShading(model, 'fabric', { THREE });
    assert.equal(mesh.customDepthMaterial, undefined);
    assert.equal(mesh.customDistanceMaterial, undefined);
  }
});

test('with the shading the shadow goes', async () => {
  const { mesh, model } = sceneOf(SHEER);
  await applyShading(model, 'fabric', { THREE });
  await applyShading(model, 'three', { THREE });
  assert.equal(mesh.customDepthMaterial, undefined);
  await applyShading(model, 'fabric', { THREE });
  assert.ok(mesh.customDepthMaterial.isMeshDepthMaterial);
});

test('a client casts with materials of its own', async () => {
  const { mesh, model } = sceneOf(SHEER);
  const own = new THREE.MeshDepthMaterial();
  mesh.customDepthMaterial = own;
  await applyShading(model, 'fabric', { THREE });
  assert.equal(mesh.customDepthMaterial, own);
  mesh.customDepthMaterial = undefined;
  assert.notEqual(mesh.customDepthMaterial, own);
  assert.ok(mesh.customDepthMaterial.isMeshDepthMaterial);
});

test('a map that comes later has three.js choose the program anew', async () => {
  const { mesh, model } = sceneOf(SHEER);
  await applyShading(model, 'fabric', { THREE });
  const { version } = mesh.customDepthMaterial;
  Object.assign(mesh.material, { map: new THREE.Texture(), needsUpdate: true });
  assert.notEqual(mesh.customDepthMaterial.version, version);
});

test('a mesh whose material was taken away casts as three.js has it', async () => {
  const { mesh, model } = sceneOf(SHEER);
  await applyShading(model, 'fabric', { THREE });
  mesh.material = null;
  assert.equal(mesh.customDepthMaterial, undefined);
});

test('a client’s own material casts so from its first draw on', async () => {
  const FabricMaterial = await loadFabricMaterial(THREE);
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(), new FabricMaterial(SHEER));
  mesh.material.onBeforeRender({}, new THREE.Scene(), new THREE.PerspectiveCamera(), mesh.geometry, mesh, null);
  assert.ok(mesh.customDepthMaterial.isMeshDepthMaterial);
});

test('a material lets go of what it casts with', async () => {
  const FabricMaterial = await loadFabricMaterial(THREE);
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(), new FabricMaterial(SHEER));
  castSheerShadow(THREE, mesh, TEXT);
  const caster = mesh.customDepthMaterial;
  let gone = 0;
  caster.addEventListener('dispose', () => {
    gone += 1;
  });
  mesh.material.dispose();
  assert.equal(gone, 1);
  assert.equal(mesh.customDepthMaterial, caster, 'a material that has gone may be drawn again');
  mesh.material.dispose();
  assert.equal(gone, 2);
});

test('releases whose shadow maps are packed cast as they do', () => {
  const { mesh } = sceneOf(SHEER);
  castSheerShadow({ ...THREE, REVISION: '181' }, mesh, TEXT);
  assert.equal(Object.getOwnPropertyDescriptor(mesh, 'customDepthMaterial')?.get, undefined);
});
