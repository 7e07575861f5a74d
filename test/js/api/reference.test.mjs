import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { promisify } from 'node:util';
import { createRenderer, doctor, inspect } from '../../../js/index.mjs';
import { nativePath } from '../../../js/api/native.mjs';
import { compareImages } from '../../../js/compare/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

const ROOT = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '../../..');
const LIBRARY = path.join(
  path.dirname(path.resolve(ROOT, process.env.TELAR_BUILD_DIR ? path.join(process.env.TELAR_BUILD_DIR, 'addon/x') : nativePath())),
  'libtelar_reference.so',
);
const SIZE = { width: 24, height: 24 };
const reference = (settings = {}) => ({ preset: 'reference', samples: 4, ...settings });

let renderer;
let ball;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  ball = await MODELS.ball();
});
after(() => renderer.close());

test('info tells what a traced frame is made of', async () => {
  const { data, info } = await renderer.render(ball, { size: SIZE, quality: reference({ seed: 3 }) });
  assert.equal(data.subarray(1, 4).toString(), 'PNG');
  assert.deepEqual(info.quality, { preset: 'reference', samples: 4, noise: 0, seed: 3, transport: 'global', bounces: 8, threads: 0 });
  assert.deepEqual([info.backend, info.gl, info.features, info.programs, info.passes, info.drawCalls], ['reference', {}, [], [], ['trace'], 0]);
  assert.equal(info.environmentSource, 'bundled');
  assert.equal(info.threads, Math.min(os.availableParallelism(), SIZE.height));
  assert.ok(info.triangles > 100 && info.rays >= SIZE.width * SIZE.height * 4);
  for (const stage of ['environment', 'hierarchy', 'draw', 'encode', 'total']) assert.ok(info.milliseconds[stage] >= 0, stage);
  const raster = await renderer.render(ball, { size: SIZE });
  assert.deepEqual(info.worldToPixel, raster.info.worldToPixel);
  assert.equal(raster.info.backend, renderer.backend);
});

test('quality high of a fine mesh is traced where that costs less, and shows what the passes of the raster do', async () => {
  const size = { width: 16, height: 16 };
  const shot = { size, shading: 'fabric', output: { format: 'raw' } };
  const shirt = path.join(ROOT, 'js/assets/tshirt.glb');
  const draw = (quality, model = shirt) => renderer.render(model, { ...shot, quality });
  const high = await draw('high');
  assert.deepEqual([high.info.backend, high.info.passes, high.info.quality.preset], ['reference', ['trace'], 'high']);
  assert.ok(high.info.samples >= 16 && high.info.samples <= 1024);
  const passes = await draw({ samples: 256, environmentSamples: 512 });
  assert.equal(passes.info.backend, renderer.backend, 'settings one by one are the raster');
  const apart = ({ data }) => compareImages({ ...size, data: passes.data }, { ...size, data }).object.flip.mean;
  const facts = { high: apart(high), occluded: apart(await draw(reference({ samples: 64, transport: 'occlusion' }))) };
  assert.ok(facts.high < 0.03, JSON.stringify(facts));
  assert.ok(facts.occluded > 0.03, `planted fault: another light. ${JSON.stringify(facts)}`);
});

test('who draws quality high goes by what the model covers, in every shading that both show the same', async () => {
  const shirt = path.join(ROOT, 'js/assets/tshirt.glb');
  const traces = async (side, more) => {
    const { plan } = await inspect(shirt, { shot: { size: { width: side, height: side }, quality: 'high', ...more } });
    return plan.passes.includes('trace');
  };
  for (const shading of ['three', 'fabric', 'disney-2012'])
    assert.deepEqual([await traces(16, { shading }), await traces(1024, { shading })], [true, false], shading);
  const far = { camera: { view: 'front', fit: 0.01 } };
  assert.equal(await traces(1024, far), true, 'small in a large picture');
  const lights = [{ type: 'directional', castShadow: true }];
  assert.deepEqual([await traces(16, { lights }), await traces(16, { lights, shading: 'fabric' })], [false, true], 'shadows of a browser have soft borders');
});

test('noise ends the paths of quiet pixels, and what is left of it is as small as asked', async () => {
  const draw = (settings) => renderer.render(ball, { size: SIZE, quality: reference({ transport: 'direct', ...settings }), output: { format: 'raw' } });
  const truth = await draw({ samples: 2048, seed: 2 });
  assert.equal(truth.info.samples, 2048);
  const [coarse, fine] = [await draw({ samples: 2048, noise: 8 }), await draw({ samples: 2048, noise: 1.5 })];
  // Inside: the colour of a pixel that the ball hardly covers is that of few paths.
  const inside = [...truth.data.keys()].filter((i) => truth.data[i | 3] === 255);
  const rms = ({ data }) => Math.sqrt(inside.reduce((sum, i) => sum + (data[i] - truth.data[i]) ** 2, 0) / inside.length);
  const facts = [coarse, fine].map((each) => ({ samples: each.info.samples, rays: each.info.rays, rms: rms(each) }));
  assert.ok(facts[0].samples >= 16 && facts[0].samples < facts[1].samples && facts[1].samples < 2048, JSON.stringify(facts));
  assert.ok(facts[0].rays < facts[1].rays && facts[1].rays < truth.info.rays, JSON.stringify(facts));
  // The truth's own error and rounding come on top.
  assert.ok(facts[1].rms < 1.5 && facts[0].rms > facts[1].rms, JSON.stringify(facts));
});

test('the seed gives the bytes, with any number of threads', async () => {
  const draw = async (settings) => (await renderer.render(ball, { size: SIZE, quality: reference(settings) })).data;
  const first = await draw({ seed: 5, threads: 1 });
  for (const threads of [0, 2, 7]) assert.ok(first.equals(await draw({ seed: 5, threads })), `${threads} threads`);
  assert.ok(!first.equals(await draw({ seed: 6 })));
});

test('direct light is what the raster draws, but for noise', async () => {
  const shot = {
    size: SIZE,
    environment: 'none',
    lights: [{ type: 'directional', position: [1, 2, 3], intensity: 3 }],
    toneMapping: 'none',
    output: { format: 'raw', bitDepth: 32 },
  };
  const floats = ({ data }) => new Float32Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.length));
  const raster = floats(await renderer.render(ball, shot));
  const traced = floats(await renderer.render(ball, { ...shot, quality: reference({ samples: 64, transport: 'direct' }) }));
  const mean = (pixels) => pixels.reduce((sum, x) => sum + x, 0) / pixels.length;
  assert.ok(Math.abs(mean(traced) / mean(raster) - 1) < 0.01, `${mean(traced)} ${mean(raster)}`);
});

test('a signal ends a trace, and nothing is left behind', async () => {
  const controller = new AbortController();
  const slow = { size: { width: 512, height: 512 }, quality: reference({ samples: 65536 }) };
  const drawing = renderer.render(ball, slow, { signal: controller.signal });
  await new Promise((resolve) => setTimeout(resolve, 400));
  const cpuBefore = process.cpuUsage();
  controller.abort();
  await assert.rejects(drawing, { name: 'AbortError' });
  // The renderer's thread is free again as soon as the tracer's have ended.
  await renderer.liveObjects();
  const { user } = process.cpuUsage(cpuBefore);
  assert.ok(user < 2e6, `${user / 1000} ms of CPU after the abort; the trace would take hours`);
  const threads = () => readFileSync('/proc/self/status', 'utf8').match(/Threads:\s+(\d+)/)[1];
  const idle = threads();
  await renderer.render(ball, { size: SIZE, quality: reference({ threads: 5 }) });
  assert.equal(threads(), idle);
});

test('progress never falls and ends at 1', async () => {
  const parts = [];
  await renderer.render(
    ball,
    { size: { width: 64, height: 64 }, quality: reference({ samples: 128, threads: 1 }) },
    { onProgress: (part) => parts.push(part) },
  );
  assert.equal(parts.at(-1), 1);
  assert.ok(parts.length > 1 && parts.every((part, i) => i === 0 || part > parts[i - 1]), String(parts));
});

test('the raster says that it does not blur', async () => {
  const lens = { aperture: 2, focusDistance: 'target' };
  const raster = await renderer.render(ball, { size: SIZE, lens });
  assert.deepEqual(
    raster.info.warnings.map(({ code }) => code),
    ['W_LENS'],
  );
  assert.deepEqual((await renderer.render(ball, { size: SIZE, lens, quality: reference() })).info.warnings, []);
  assert.deepEqual((await renderer.render(ball, { size: SIZE, lens: { aperture: 2 } })).info.warnings, []);
});

test('doctor finds it', async () => {
  const { reference: found } = await doctor();
  assert.equal(found.works, true);
  assert.match(found.version, /^Embree 3\.\d+/);
});

/** What a process of its own prints as JSON. */
async function printed(script, env = {}) {
  const { stdout } = await promisify(execFile)(
    process.execPath,
    [
      '--input-type=module',
      '-e',
      `
    import { readFileSync } from 'node:fs';
    import { createRenderer, doctor } from ${JSON.stringify(path.join(ROOT, 'js/index.mjs'))};
    import { MODELS } from ${JSON.stringify(path.join(ROOT, 'test/fixtures/index.mjs'))};
    const loaded = () => /libembree/.test(readFileSync('/proc/self/maps', 'utf8'));
    const renderer = await createRenderer({ cacheDirectory: null });
    const draw = async (quality, layers, more) => renderer.render(await MODELS.ball(), { size: { width: 8, height: 8 }, environment: 'none', quality, layers, ...more });
    ${script}
    await renderer.close();`,
    ],
    { env: { ...process.env, ...env } },
  );
  return JSON.parse(stdout);
}

test('Embree is loaded by the first traced frame, not by others', async () => {
  assert.deepEqual(
    await printed(`
    await draw('standard');
    const before = loaded();
    await draw({ preset: 'reference', samples: 1 });
    console.log(JSON.stringify([before, loaded()]));`),
    [false, true],
  );
});

test('a host without the library, or without Embree, draws the rest and names the cure', async () => {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'telar-reference-'));
  const script = `
    const { info } = await draw('standard');
    const error = await draw({ preset: 'reference', samples: 1 }).catch((thrown) => thrown);
    const layer = await draw('standard', ['ao']).catch((thrown) => thrown);
    const sees = Object.keys((await draw('standard', ['depth'])).layers);
    const missed = ({ warnings }) => warnings.filter(({ code }) => code === 'W_LIBRARY_MISSING');
    const { info: high } = await draw('high', undefined, { shading: 'fabric' });
    const instead = [high.backend === renderer.backend, missed(high).map(({ message, pointer }) => [message.endsWith(error.message), pointer])];
    const told = [error.code, error.exit, error.message, layer.message === error.message];
    const { reference, imageFiles } = await doctor();
    console.log(JSON.stringify([info.passes.length > 0, missed(info), ...told, sees, instead, reference, imageFiles.works]));`;
  const missing = (file) =>
    `Embree is needed for quality "reference", the layer "ao" and ambient visibility, but ${file} cannot be loaded; run: apt-get install libembree3-3, and build telar again if it is older`;
  try {
    const instead = [true, [[true, '/quality']]];
    const expect = (file) => [true, [], 'X_LIBRARY_MISSING', 6, missing(file), true, ['depth'], instead, { works: false, failure: missing(file) }, false];
    assert.deepEqual(await printed(script, { TELAR_LIBRARY_DIR: folder }), expect('libtelar_reference.so'));
    const copy = path.join(folder, 'libtelar_reference.so');
    copyFileSync(LIBRARY, copy);
    const bytes = readFileSync(copy);
    bytes.write('libembree9', bytes.indexOf('libembree3.so'));
    writeFileSync(copy, bytes);
    assert.deepEqual(await printed(script, { TELAR_LIBRARY_DIR: folder }), expect('libembree9.so.3'));
  } finally {
    rmSync(folder, { recursive: true });
  }
});
