import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { applyShading, restoreMaterials } from '../../../js/three/shading.mjs';
import { loadShading } from '../../../js/three/shading/index.mjs';
import '../built.mjs';

/** Two meshes that share a lit material, one with a physical one, one that is not lit. */
function model() {
  const root = new THREE.Group();
  const shared = new THREE.MeshStandardMaterial({ color: 0x336699, roughness: 0.3, name: 'shared' });
  const physical = new THREE.MeshPhysicalMaterial({ sheen: 1, sheenRoughness: 0.4, clearcoat: 0.5 });
  const unlit = new THREE.MeshBasicMaterial();
  for (const material of [shared, shared, physical, unlit]) root.add(new THREE.Mesh(new THREE.BufferGeometry(), material));
  return { root, shared, physical, unlit, materials: () => root.children.map(({ material }) => material) };
}

test('lit materials are replaced, a shared one by one, and put back as they were', async () => {
  const { root, shared, physical, unlit, materials } = model();
  await applyShading({ scene: root }, 'three', { THREE, ownText: true });
  const [a, b, c, d] = materials();
  assert.equal(a, b);
  assert.ok(a.isTelarShadingMaterial && c.isTelarShadingMaterial && a !== c);
  assert.equal(d, unlit);
  assert.deepEqual([a.roughness, a.color.getHex(), a.name, c.sheenRoughness, c.clearcoat], [0.3, 0x336699, 'shared', 0.4, 0.5]);
  assert.deepEqual(a.defines, { STANDARD: '', PHYSICAL: '' });
  restoreMaterials(root);
  assert.deepEqual(materials(), [shared, shared, physical, unlit]);
});

test('a second shot takes the same replacement, in the state that the original has now', async () => {
  const { root, shared, materials } = model();
  await applyShading({ scene: root }, 'three', { THREE, ownText: true });
  const [first] = materials();
  shared.roughness = 0.9;
  await applyShading({ scene: root }, 'three', { THREE, ownText: true });
  assert.equal(materials()[0], first);
  assert.equal(first.roughness, 0.9);
});

test('an original that is disposed of takes its replacements along', async () => {
  const { root, shared, materials } = model();
  await applyShading({ scene: root }, 'three', { THREE, ownText: true });
  let disposed = 0;
  materials()[0].addEventListener('dispose', () => disposed++);
  shared.dispose();
  assert.equal(disposed, 1);
});

test('the class is made once for a module, and its programs are told apart from stock ones', async () => {
  const Material = await loadShading(THREE, 'three');
  assert.equal(await loadShading(THREE, 'three'), Material);
  const material = new Material({ roughness: 0.2 });
  assert.equal(material.roughness, 0.2);
  assert.equal(material.type, 'MeshPhysicalMaterial');
  const clone = material.clone();
  assert.ok(clone instanceof Material);
  assert.equal(clone.customProgramCacheKey(), material.customProgramCacheKey());
  assert.notEqual(material.customProgramCacheKey(), new THREE.MeshPhysicalMaterial().customProgramCacheKey());
  material.shadingDefines = { TERM: 1 };
  assert.notEqual(clone.customProgramCacheKey(), material.customProgramCacheKey());
});

test('three.js gets the lighting of telar, its own lights and everything else', async () => {
  const material = new (await loadShading(THREE, 'three'))();
  const shader = { fragmentShader: THREE.ShaderLib.physical.fragmentShader };
  material.shadingDefines = { TERM: 7 };
  material.onBeforeCompile(shader);
  assert.match(shader.fragmentShader, /#define telar_TERM 7\n/);
  assert.match(shader.fragmentShader, /RE_Direct\( directLight/);
  assert.doesNotMatch(shader.fragmentShader, /TELAR_LIGHT_LOOPS|lights_physical_fragment>/);
  assert.equal(shader.fragmentShader.match(/void main\(\)/g).length, 1);
});

test('what the text does not draw, and another three.js, are errors that say so', async () => {
  const Material = await loadShading(THREE, 'three');
  const shiny = new Material({ name: 'knit', retroreflectivity: 1 });
  assert.throws(() => shiny.onBeforeCompile({ fragmentShader: 'void main() {' }), /material knit: .* retroreflectivity/);
  assert.throws(() => new Material().onBeforeCompile({ fragmentShader: '' }), /written for three\.js 0\.187/);
});
