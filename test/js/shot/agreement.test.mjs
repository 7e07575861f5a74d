import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { before, test } from 'node:test';
import Ajv from 'ajv/dist/2020.js';
import { shotJson } from '../../../js/api/shot_json.mjs';
import { Model, loadModel } from '../../../js/api/model.mjs';
import { loadNative } from '../../../js/api/native.mjs';
import { resolveShot, TelarError } from '../../../js/shot/index.mjs';
import { isGoal, resolveQuality } from '../../../js/shot/quality.mjs';
import { resolvedShotSchema } from '../../../js/shot/resolved_schema.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import '../api/support/real.mjs';
import { RandomShots } from './random_shots.mjs';

// What the published schema, resolveShot, the schema of its result, the types and the C++ that reads it say of the same shots.

const SHOTS = 8000;
const SEED = 20261122;

/** What a shot may be refused for by resolveShot: keys that do not go together, and what this model lacks. */
const REFUSED = ['E_SHOT', 'E_CAMERA', 'E_FRAME', 'E_VARIANT', 'E_POSE'];

const part = { frame: { node: 'Sleeve' }, found: true, bounds: { min: [0, 0, 0], max: [0.2, 0.3, 0.1] } };
const FACTS = {
  bounds: { min: [-0.4, 0.1, -0.15], max: [0.42, 0.82, 0.17] },
  variants: ['navy', '\ud800', '\u2028'],
  part,
  animations: [
    { name: 'walk', duration: 1 },
    { name: 'Sleeve', duration: 2 },
    { name: '', duration: 0 },
  ],
  cameras: [{ name: 'shop', projection: 'perspective', fovY: 40, near: 0.1, far: null, position: [0, 1, 4], target: [0, 1, 3], up: [0, 1, 0] }],
};

/** Pairs of shots and what they resolve to, of the shots that are not refused. */
function acceptedShots(count, seed) {
  const random = new RandomShots(seed);
  const accepted = [];
  for (let i = 0; i < count; i++) {
    const shot = random.next();
    try {
      accepted.push({ shot, resolved: resolveShot(shot, FACTS) });
    } catch (error) {
      assert.ok(error instanceof TelarError && REFUSED.includes(error.code), `${JSON.stringify(shot)}: ${error.stack}`);
    }
  }
  return accepted;
}

let accepted, native, model;
before(async () => {
  native = loadNative();
  model = await MODELS.boxes();
  accepted = acceptedShots(SHOTS, SEED);
});

/** A decoded model of its own: a plan is the last that is made of one. */
const loadScene = async () => Model.sceneOf(await loadModel(native, new native.Bytes(model, model.length), native.limits));

/** What C++ says of a resolved shot: undefined where it takes it. */
async function refusalOf(scene, resolved) {
  const request = { material: 0, shot: shotJson(resolved), viewAngle: 0, directions: new Float64Array(0), albedo: false };
  return native.evaluateLobes(scene, request, new native.CancelToken()).then(
    () => undefined,
    (error) => error,
  );
}

test('enough of the random shots are taken to say something, each kind of thing among them', () => {
  assert.ok(accepted.length > SHOTS / 4, `${accepted.length} of ${SHOTS}`);
  const counts = {
    perspective: ({ camera }) => camera.projection === 'perspective',
    orthographic: ({ camera }) => camera.projection === 'orthographic',
    lens: ({ lens }) => lens !== null,
    ground: ({ ground }) => ground !== 'none',
    pose: ({ pose }) => pose !== null,
    variant: ({ variant }) => variant !== '',
    reference: ({ quality }) => quality.preset === 'reference',
    goal: ({ quality }) => isGoal(quality),
    terms: ({ shading }) => typeof shading === 'object',
    fabric: ({ shading }) => shading === 'fabric',
    ...Object.fromEntries(
      ['ambient', 'hemisphere', 'directional', 'point', 'spot', 'rect', 'disk'].map((type) => [
        type,
        ({ lights }) => lights.some((light) => light.type === type),
      ]),
    ),
    ...Object.fromEntries(
      ['directional', 'point', 'spot'].map((type) => [`shadow of ${type}`, ({ lights }) => lights.some((light) => light.type === type && light.castShadow)]),
    ),
  };
  for (const [name, has] of Object.entries(counts)) {
    assert.ok(accepted.filter(({ resolved }) => has(resolved)).length >= 10, `${name}: ${accepted.filter(({ resolved }) => has(resolved)).length}`);
  }
});

/** As it goes to C++: a goal has settings in its place by then. */
const drawn = (resolved) => (isGoal(resolved.quality) ? { ...resolved, quality: resolveQuality('standard') } : resolved);

test('what resolveShot takes, C++ takes', async () => {
  const scene = await loadScene();
  const refused = new Map();
  for (const { resolved } of accepted) {
    const error = await refusalOf(scene, drawn(resolved));
    if (error) refused.set(`${error.code} ${error.message.replace(/\[\d+\]/, '[]').replace(/, got .*/, '')}`, error.message);
  }
  assert.deepEqual([...refused.values()], []);
});

test('what C++ takes, it can plan: the faults of a plan are limits', async () => {
  for (const { resolved } of accepted.slice(0, 500)) {
    const scene = await loadScene();
    const variant = ''; // the fixture has none, nor parts for ghosts
    const plan = native.plan(scene, shotJson({ ...drawn(resolved), variant, pose: null, ghost: [] }), native.limits, new native.CancelToken());
    await plan.catch(({ code, message }) => assert.match(code, /^L_/, `${message}: ${JSON.stringify(resolved)}`));
  }
});

test('what resolveShot takes, the published JSON Schema takes, and its own schema what it gives', () => {
  const published = JSON.parse(readFileSync(new URL('../../../js/shot/schema.json', import.meta.url), 'utf8'));
  const validate = new Ajv({ strict: false }).compile(published);
  for (const { shot, resolved } of accepted) {
    assert.ok(validate(shot), `${JSON.stringify(shot)}: ${JSON.stringify(validate.errors?.[0])}`);
    assert.equal(resolvedShotSchema.safeParse(resolved).error, undefined, JSON.stringify(shot));
    assert.ok(validate(JSON.parse(JSON.stringify(resolved))), `resolved ${JSON.stringify(resolved)}: ${JSON.stringify(validate.errors?.[0])}`);
  }
});

test('a resolved shot resolves to itself', () => {
  for (const { resolved } of accepted) assert.deepEqual(resolveShot(resolved, FACTS), resolved);
});

test('shots and resolved shots are of their types', () => {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-types-'));
  try {
    const root = fileURLToPath(new URL('../../../', import.meta.url));
    const some = accepted.slice(0, 400);
    const list = (key) => some.map((pair) => JSON.stringify(pair[key])).join(',\n');
    const text =
      `import type { ResolvedShot, Shot } from '${root}js/shot/shot.js';\nexport const shots: Shot[] = [${list('shot')}];\n` +
      `export const resolved: ResolvedShot[] = [${list('resolved')}];\nexport const again: Shot[] = resolved;\n`;
    writeFileSync(path.join(folder, 'shots.mts'), text);
    const { stdout } = spawnSync(
      process.execPath,
      [
        `${root}node_modules/typescript/bin/tsc`,
        '--noEmit',
        '--strict',
        '--skipLibCheck',
        '--module',
        'nodenext',
        '--types',
        '',
        path.join(folder, 'shots.mts'),
      ],
      { cwd: folder, encoding: 'utf8' },
    );
    assert.equal(stdout.slice(0, 2000), '');
  } finally {
    rmSync(folder, { recursive: true });
  }
});
