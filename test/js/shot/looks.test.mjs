import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shotIdentity } from '../../../js/shot/identity.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { LOOKS } from '../../../js/shot/table/looks.mjs';

const FACTS = { bounds: { min: [-0.4, 0, -0.2], max: [0.4, 0.8, 0.2] } };
const resolved = (shot) => resolveShot(shot, FACTS);

test('a look is the shot that it stands for, and says so', () => {
  for (const [look, { shot }] of Object.entries(LOOKS)) {
    assert.deepEqual(resolved({ look }), { ...resolved(shot), look });
    assert.notDeepEqual(resolved(shot), resolved({}), 'and shows another picture than no look');
  }
});

test('what a shot says holds before its look', () => {
  const { background, environment, lights } = resolved({ look: 'hero', background: 'white', lights: [] });
  assert.deepEqual([background, lights, environment], [[1, 1, 1], [], resolved(LOOKS.hero.shot).environment]);
  assert.deepEqual(resolved({ look: 'hero', background: undefined }), resolved({ look: 'hero' }));
});

test('of a camera each key is filled in by itself, where it stands as a whole', () => {
  const hero = LOOKS.hero.shot.camera;
  const camera = (own) => resolved({ look: 'hero', camera: own }).camera;
  const plain = (own) => resolved({ camera: own }).camera;
  assert.deepEqual(camera({ fit: 0.5 }), plain({ ...hero, fit: 0.5 }));
  assert.deepEqual(camera({ view: 'back' }), plain({ view: 'back', fovY: hero.fovY, fit: hero.fit }));
  assert.deepEqual(camera({ elevation: 10 }), plain({ elevation: 10, fovY: hero.fovY, fit: hero.fit }));
  assert.deepEqual(camera({ projection: 'orthographic' }), plain({ ...hero, fovY: undefined, projection: 'orthographic' }));
  const placed = { position: [0, 0, 3], target: [0, 0, 0] };
  assert.deepEqual(camera(placed), plain(placed));
});

test('each look has a true scale: its lens is left out', () => {
  for (const [look, { shot }] of Object.entries(LOOKS)) {
    const { fovY: _, ...camera } = shot.camera;
    const scaled = { scale: '1:5', output: { ppi: 150 } };
    const wanted = { ...resolved({ ...shot, ...scaled, camera }), look };
    assert.deepEqual(resolved({ look, ...scaled }), wanted, look);
    assert.deepEqual(resolved({ look, ...scaled, camera: { fit: shot.camera.fit } }), wanted, look);
    assert.deepEqual(resolved({ look, scale: 'none' }), resolved({ look }));
  }
  const own = { look: 'catalogue', scale: '1:5', output: { ppi: 150 }, camera: { fovY: 15 } };
  assert.throws(() => resolved(own), { code: 'E_SHOT', message: 'shot.camera.fovY: expected no fovY with the orthographic projection, got 15' });
});

test('each look has a format without transparency, which shows it before white', () => {
  for (const look of Object.keys(LOOKS)) {
    const [png, jpeg] = ['png', 'jpeg'].map((format) => resolved({ look, output: { format } }).background);
    assert.deepEqual(jpeg, png === 'transparent' ? [1, 1, 1] : png, look);
  }
  assert.equal(resolved({ look: 'ghost', output: { format: 'webp' } }).background, 'transparent');
  assert.throws(() => resolved({ look: 'ghost', background: 'transparent', output: { format: 'jpeg' } }), { code: 'E_SHOT', pointer: '/background' });
  for (const output of ['jpeg', { format: 'constructor' }, null]) assert.throws(() => resolved({ look: 'ghost', output }), { code: 'E_SHOT' });
});

test('a resolved shot with a look resolves to itself', () => {
  const once = resolved({ look: 'furniture' });
  assert.deepEqual(resolved(once), once);
});

test('an identity has what the look says', () => {
  const { look: _, ...written } = shotIdentity({ look: 'catalogue' });
  const { look: __, ...plain } = shotIdentity(LOOKS.catalogue.shot);
  assert.deepEqual(written, plain);
});

test('unknown looks are refused', () => {
  assert.throws(() => resolved({ look: 'catalog' }), { code: 'E_SHOT', pointer: '/look', message: /did you mean "catalogue"|"catalogue"/ });
  assert.throws(() => resolved({ look: 'constructor' }), { code: 'E_SHOT', pointer: '/look' });
});
