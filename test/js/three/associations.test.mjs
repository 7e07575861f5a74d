import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { recallAssociations } from '../../../js/three/associations.mjs';
import { factsOf } from '../../../js/three/index.mjs';

// What a file with two scenes is in the browser once GLTFLoader has forgotten the parts of the one that is drawn.

const json = {
  scene: 1,
  scenes: [{ nodes: [4] }, { nodes: [0, 3] }],
  nodes: [
    { name: 'body', mesh: 0, camera: 0, children: [1, 2] },
    { name: 'sleeve', mesh: 1 },
    { name: 'empty' },
    { name: 'stand', mesh: 1 },
    { name: 'other', mesh: 1 },
  ],
  meshes: [{ primitives: [{ material: 0 }, { material: 1 }] }, { primitives: [{ material: 0 }] }],
  materials: [{ name: 'cloth' }, { name: 'button' }],
  cameras: [{ type: 'perspective', perspective: { yfov: 1, znear: 0.1 } }],
};

const box = (x) => new THREE.Mesh(new THREE.BoxGeometry().translate(x, 0, 0));

/** As the loader builds it: what a node draws, and behind it the nodes below. */
function model() {
  const [front, back, sleeve, empty, stand] = [box(0), box(1), box(2), new THREE.Object3D(), box(50)];
  const body = new THREE.Group().add(new THREE.Group().add(front, back), new THREE.PerspectiveCamera(), sleeve, empty);
  const scene = new THREE.Group().add(body, stand);
  scene.updateMatrixWorld(true);
  // What was told after the other scene was done.
  const associations = new Map([[sleeve, { nodes: 1 }]]);
  return { parts: { body, front, back, sleeve, empty, stand }, model: { scene, parser: { json, associations } } };
}

test('each part is told again, a primitive each', () => {
  const { parts, model: given } = model();
  recallAssociations(given);
  const told = Object.fromEntries(Object.entries(parts).map(([name, object]) => [name, given.parser.associations.get(object)]));
  assert.deepEqual(told, {
    body: { nodes: 0 },
    front: { meshes: 0, primitives: 0 },
    back: { meshes: 0, primitives: 1 },
    sleeve: { nodes: 1, meshes: 1, primitives: 0 },
    empty: { nodes: 2 },
    stand: { nodes: 3, meshes: 1, primitives: 0 },
  });
});

test('facts leave out what the shot does, measure its parts and know its cameras', () => {
  const { model: given } = model();
  const facts = factsOf(given, { THREE, ghost: [{ node: 'stand', opacity: 0 }], frame: { material: 'button' } });
  assert.equal(facts.bounds.max[0], 2.5);
  assert.deepEqual([facts.part.bounds.min[0], facts.part.bounds.max[0]], [0.5, 1.5]);
  assert.deepEqual(
    facts.cameras.map(({ name }) => name),
    ['body'],
  );
});

test('a scene that the caller chose is taken', () => {
  const [first, second] = [new THREE.Group().add(box(0)), new THREE.Group()];
  const parser = { json, associations: new Map() };
  recallAssociations({ scene: first, scenes: [first, second], parser });
  assert.deepEqual(parser.associations.get(first.children[0]), { nodes: 4, meshes: 1, primitives: 0 });
});
