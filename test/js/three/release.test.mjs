import assert from 'node:assert/strict';
import { test } from 'node:test';
import * as THREE from 'three';
import { resolveShot } from '../../../js/shot/index.mjs';
import { REVISION, termsOfRevision } from '../../../js/shot/three_terms.mjs';
import { applyShot } from '../../../js/three/index.mjs';

const CAMERA = { position: [1, 2, 3], target: [0, 0.5, 0], near: 0.5, far: 9 };
const resolve = (shot = {}) => resolveShot({ environment: 'none', camera: CAMERA, toneMapping: 'aces', ...shot });
const release = (revision) => ({ ...THREE, REVISION: String(revision) });
const renderer = () => ({ shadowMap: {}, setPixelRatio() {}, setSize() {}, setClearColor() {} });

/** A map of 8 columns whose red is the column's number. */
function mapOf(columns) {
  const data = new Float32Array(columns * 2 * 4);
  for (let i = 0; i < columns * 2; i++) data.set([i % columns, 0, 0, 1], i * 4);
  return new THREE.DataTexture(data, columns, 2, THREE.RGBAFormat, THREE.FloatType);
}

async function apply(t, revision, shot, more = {}) {
  const lines = [];
  t.mock.method(console, 'warn', (line) => lines.push(line));
  const target = { THREE: release(revision), renderer: renderer(), scene: new THREE.Scene(), ...more };
  const camera = await applyShot(shot, target);
  t.mock.restoreAll();
  return { ...target, camera, lines };
}

test('a page that draws with another family of three.js than the server is told so, once', async (t) => {
  const { lines } = await apply(t, 170, resolve());
  assert.equal(lines.length, 1);
  assert.match(lines[0], /three\.js 0\.170 .*three\.js 0\.187, .*revision: 170.*revision: "client"/);
  assert.deepEqual((await apply(t, 170, resolve())).lines, []);
});

test("the same family is no matter; shadings that no release has are made for today's", async (t) => {
  assert.deepEqual((await apply(t, 180, resolve({ shading: { base: 'three', revision: 170 } }))).lines, []);
  assert.deepEqual((await apply(t, REVISION, resolve())).lines, []);
  assert.deepEqual((await apply(t, `${REVISION}dev`, resolve())).lines, []);
  const fabric = resolve({ shading: 'fabric' });
  assert.match((await apply(t, 168, fabric, { revision: 'client' })).lines[0], /made for three\.js 0\.187, and this page has 0\.168/);
  assert.equal(fabric.shading, 'fabric');
});

test('revision "client" writes the page\'s own release into the shot, which resolves to itself', async (t) => {
  const shot = resolve();
  const { lines } = await apply(t, 171, shot, { revision: 'client' });
  assert.deepEqual(lines, []);
  assert.deepEqual(shot.shading, { base: 'three', revision: 171, ...termsOfRevision(171) });
  assert.deepEqual(resolveShot(shot).shading, shot.shading);
  await apply(t, REVISION, shot, { revision: 'client' });
  assert.equal(shot.shading, 'three');
  await assert.rejects(apply(t, 171, shot, { revision: 171 }), /revision "shot" or "client", got 171/);
});

test('a release beyond the table and one whose patches differ are told', async (t) => {
  assert.match((await apply(t, REVISION + 1, resolve(), { revision: 'client' })).lines[0], new RegExp(`0\\.${REVISION + 1} is not known.*nearest`));
  assert.match((await apply(t, 181, resolve(), { revision: 'client' })).lines[0], /0\.181\.2/);
});

test('a tone mapping that the release does not have is an error', async (t) => {
  const THREE_160 = release(160);
  delete THREE_160.NeutralToneMapping;
  await assert.rejects(
    apply(t, 160, resolve({ toneMapping: 'neutral' }), { THREE: THREE_160 }),
    /shot\.toneMapping: three\.js 0\.160 has no tone mapping neutral/,
  );
});

const material = () => new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshStandardMaterial());
const lit = { environment: { map: 'studio.hdr', intensity: 0.7, rotation: 90 } };
const red = ({ image: { data } }) => Array.from({ length: 8 }, (_, i) => data[i * 4]);

test('releases without a property for it get it by material, texel or colour', async (t) => {
  const mesh = material();
  const scene = new THREE.Scene().add(mesh);
  const environment = mapOf(8);
  await apply(t, 161, resolve(lit), { scene, environment });
  assert.equal(mesh.material.envMapIntensity, 0.7);
  const half = (value) => THREE.DataUtils.toHalfFloat(value);
  assert.deepEqual(red(scene.environment), [2, 3, 4, 5, 6, 7, 0, 1].map(half));
  const first = scene.environment;
  await apply(t, 161, resolve(lit), { scene, environment });
  assert.equal(scene.environment, first);

  const newer = material();
  const { scene: own } = await apply(t, 163, resolve(lit), { scene: new THREE.Scene().add(newer), environment });
  assert.equal(newer.material.envMapIntensity, 1);
  assert.deepEqual(red(own.environment), [0, 1, 2, 3, 4, 5, 6, 7].map(half));
  assert.equal(own.environmentRotation.y, Math.PI / 2);
});

test('an angle between two columns is rounded, and that is said', async (t) => {
  const shot = resolve({ environment: { map: 'studio.hdr', rotation: -50 } });
  const { scene, lines } = await apply(t, 161, shot, { environment: mapOf(8), revision: 'client' });
  assert.equal(red(scene.environment)[0], THREE.DataUtils.toHalfFloat(7));
  assert.match(lines[0], /-50 degrees are no whole columns of the map, and it is turned by 5\.000 more/);
});

test('output, lights and backgrounds of the first releases', async (t) => {
  const background = [0.5, 0.25, 0];
  const { renderer: first, scene } = await apply(t, 151, resolve({ background }), { THREE: { ...release(151), sRGBEncoding: 3001 }, revision: 'client' });
  assert.deepEqual([first.outputEncoding, first.useLegacyLights], [3001, false]);
  assert.ok(Math.abs(scene.background.r - 0.735) < 1e-3);
  const { renderer: later, scene: linear } = await apply(t, 155, resolve({ background }), { revision: 'client' });
  assert.deepEqual([later.outputEncoding, later.useLegacyLights], [undefined, undefined]);
  assert.deepEqual(linear.background.toArray(), background);
});
