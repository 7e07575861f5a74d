// Checked by tsc against the published entries, never run.
import { TelarError, createRenderer, doctor, inspect, toTelarError, versions, type FrameInfo, type Model, type SettledImage, type Shot } from 'telar';
import { compareImages, embedShot, encodePng, heatMap, htmlReport, judge, junitReport, readEmbeddedShot, readImage } from 'telar/compare';
import { createPool, type Pool, type PoolModel } from 'telar/pool';
import { openQueue, startWorker, type JobState } from 'telar/queue';
import { VIEWS, parseColour, resolveShot, type ResolvedShot } from 'telar/shot';
import { applyShot, rendererParameters } from 'telar/three';

const shot: Shot = {
  size: { width: 800 },
  camera: { view: 'three-quarter', fit: 0.95 },
  environment: { map: new Uint8Array(4), rotation: 30 },
  lights: [{ type: 'spot', color: [1, 0.5, 0.25], angle: 0.4 }, { type: 'ambient', color: 'white' }],
  background: '#eee',
  quality: { samples: 4 },
  output: { format: 'tiff', bitDepth: 16 },
};

export async function draw(signal: AbortSignal): Promise<FrameInfo> {
  await using renderer = await createRenderer({ backend: 'egl-surfaceless', limits: { L_NODES: 5 }, cacheDirectory: null, signal });
  const { data, info } = await renderer.render('shirt.glb', shot, { signal });
  const model: Model = await renderer.load(new Uint8Array(data), { signal });
  const views = await renderer.renderAll(model, [shot, info.shot, {}]);
  const bytes: number = views.reduce((sum, view) => sum + view.data.byteLength, 0);
  const resolved: ResolvedShot = resolveShot(shot, model.facts);
  resolveShot(resolved, { min: { x: 0, y: 0, z: 0 }, max: [1, 1, 1] });
  if (resolved.camera.projection === 'orthographic') resolved.camera.height.toFixed(bytes);
  await applyShot(resolved, { THREE: {}, renderer: {}, scene: {} });
  rendererParameters(resolved).antialias satisfies boolean;
  const { plan, bounds, goal } = await inspect(new URL('file:///shirt.glb'), { shot });
  const apart: Model = await model.explode(0.1, { timeoutMs: null, signal });
  // @ts-expect-error nothing is loaded
  await apart.explode(0.1, { failOn: 'none' });
  const report = await doctor();
  [plan?.features, goal?.predicted.flip, bounds?.min, report.chosen, versions.telar, VIEWS.front.azimuth, parseColour('red')?.[0]].join();
  return info;
}

export async function drawAll(store: Map<string, Uint8Array>): Promise<number> {
  await using renderer = await createRenderer({ failOn: 'none', resolve: (uri) => store.get(uri), cacheBytes: 2 ** 20 });
  const outcomes: SettledImage[] = await renderer.renderAll('shirt.gltf', [shot], { settled: true, resolve: async (uri, { signal }) => (signal?.aborted ? null : store.get(uri)) });
  const [one] = outcomes;
  if (one?.status === 'rejected') return one.reason.index ?? toTelarError(one.reason).exit;
  const images = await renderer.renderAll('shirt.gltf', [shot], { failOn: 'warning' });
  // @ts-expect-error a level that does not exist
  await inspect('shirt.gltf', { failOn: 'all' });
  // @ts-expect-error text is no bytes
  await renderer.load('shirt.gltf', { resolve: () => 'text' });
  return images.length + (one?.value.data.length ?? 0);
}

export function classify(error: unknown): string {
  return error instanceof TelarError && error.code === 'E_SHOT' ? `${error.pointer} ${error.kind} ${error.limit?.max}` : 'other';
}

// @ts-expect-error an unknown key
export const unknownKey: Shot = { colour: 'red' };
// @ts-expect-error an unknown view
export const unknownView: Shot = { camera: { view: 'up' } };
// @ts-expect-error an explicit camera has a target
export const noTarget: Shot = { camera: { position: [0, 0, 1], fovY: 3 } };
// @ts-expect-error a light of another type has no angle
export const noAngle: Shot = { lights: [{ type: 'point', angle: 1 }] };
// @ts-expect-error a backend that does not exist
export const noBackend = createRenderer({ backend: 'glx' });
// @ts-expect-error a code that is not in the table
export const noCode = new TelarError('E_NOTHING', '');

export async function compare(signal: AbortSignal): Promise<number> {
  const actual = await readImage(new Uint8Array(4), { limits: { L_IMAGE_PIXELS: 100 }, signal });
  const comparison = compareImages(await readImage('expected.png'), actual, { pixelsPerDegree: 40, mask: new Uint8Array(1) });
  const verdict = judge(comparison);
  const shot: object | null = readEmbeddedShot(embedShot(await encodePng(heatMap(comparison)), { exposure: 1 }));
  if (shot === null) return comparison.frame.mean;
  htmlReport(comparison, verdict, { expected: 'a.png', actual: 'b.png', heatMap: 'c.png' }).concat(junitReport([{ name: 'shirt', verdict }]));
  // @ts-expect-error no such gate
  judge(comparison, 'strict');
  // @ts-expect-error a region may be empty
  return comparison.edge.flip.mean;
}

export async function drawInWorkers(pool: Pool): Promise<number> {
  const model: PoolModel = await pool.load('shirt.glb');
  const [first] = await pool.renderAll(await model.swatch({ part: { material: 0 } }), [shot], { settled: true });
  const own = await createPool({ size: 2, memoryBytes: 1e9, cpuMs: null, backend: 'osmesa' });
  // @ts-expect-error: it is no option
  await createPool({ sizes: 2 });
  await own.close();
  return first?.status === 'fulfilled' ? first.value.data.length : pool.workers.length;
}

export async function drawLater(pool: Pool): Promise<Uint8Array | undefined> {
  const queue = await openQueue({ sqlite: 'jobs.db', attempts: 2 });
  const { id }: JobState = await queue.add({ kind: 'thumbnail', asked: { shot }, files: { model: new Uint8Array(4) } }, { priority: 1, tenant: 'one' });
  const worker = startWorker(queue, { pool, atOnce: 2 });
  const stop = queue.watch(id, ({ state, error }) => console.log(state, error?.retryable));
  await worker.drain(1000);
  stop();
  // @ts-expect-error: no such kind
  await queue.add({ kind: 'picture', asked: {}, files: {} });
  return (await queue.result(id))?.result.files[0]?.data;
}
