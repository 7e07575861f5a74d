import { createHash } from 'node:crypto';
import { PassThrough, Readable } from 'node:stream';
import { TelarError } from '../../../js/error/index.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { COMMANDS } from '../../../js/cli/commands.mjs';
import { run } from '../../../js/cli/run.mjs';

const FACTS = { bounds: { min: [-1, 0, -1], max: [1, 2, 1] }, variants: ['navy'], cameras: [], size: [2, 2, 2], triangles: 12, warnings: [] };

/**
 * Stands in for the API: "draws" the resolved shot as JSON, fails for models named after an error code, and notes each call.
 */
export function fakeApi({ delayMs = 0, told = 0.5 } = {}) {
  const calls = { created: [], rendered: [], loaded: [], released: 0, closed: 0, mostAtOnce: 0, inspected: [], baked: [] };
  const wait = (signal) =>
    new Promise((resolve, reject) => {
      signal?.throwIfAborted();
      const timer = setTimeout(resolve, delayMs);
      signal?.addEventListener('abort', () => {
        clearTimeout(timer);
        reject(signal.reason);
      });
    });
  const failing = (source) => /([ELX]_[A-Z_]+)/.exec(typeof source === 'string' ? source : '')?.[1];
  const warningsOf = (source) => (/warn/.test(String(source)) ? [{ code: 'W_RANGE', message: 'clamped', pointer: '/materials/0' }] : []);
  const keyOf = (source, shot) =>
    createHash('sha256')
      .update(JSON.stringify([String(source), shot]))
      .digest('hex');
  const render = async (given, shot, { signal, onProgress }) => {
    const source = given?.loaded ?? given;
    onProgress?.(told);
    await wait(signal);
    if (failing(source)) throw new TelarError(failing(source), 'it fails', { pointer: '/nodes/0' });
    const resolved = resolveShot(shot, FACTS);
    calls.rendered.push({ source, shot: resolved });
    return { data: Buffer.from(JSON.stringify(resolved)), info: { width: 1, key: keyOf(source, shot), warnings: warningsOf(source), shot: resolved } };
  };
  const load = async (source, { signal }) => {
    await wait(signal);
    if (failing(source)) throw new TelarError(failing(source), 'it fails', { pointer: '/nodes/0' });
    calls.loaded.push(source);
    return { loaded: source };
  };
  const release = async () => void (calls.released += 1);
  const open = async (options) => {
    calls.created.push(options);
    if (options.backend === 'egl-device') throw new TelarError('X_GL', 'no device');
    return { render, load, release, close: async () => void (calls.closed += 1) };
  };
  const api = {
    createRenderer: open,
    pictureKey: async (source, shot) => keyOf(source, shot),
    inspect: async (source, options) => {
      calls.inspected.push({ source, options });
      if (failing(source)) throw new TelarError(failing(source), 'it fails');
      return { ...FACTS, warnings: warningsOf(source), plan: { features: ['normalMap'], programs: [{}], passes: ['opaque'] } };
    },
    bake: async (source, options) => {
      calls.baked.push({ source, options });
      if (failing(source)) throw new TelarError(failing(source), 'it fails');
      const format = /\.gltf$/.test(String(source)) ? 'gltf' : 'glb';
      return { data: Buffer.from('baked'), info: { format, parts: format === 'gltf' ? ['m.bin'] : [], vertices: 3, warnings: warningsOf(source) } };
    },
    doctor: async () => ({
      ok: true,
      versions: { telar: '1', node: '20' },
      system: 'Linux',
      native: { path: 'x' },
      chosen: 'osmesa',
      reason: 'first',
      backends: [
        { backend: 'egl-device', works: false, failure: 'no libEGL', cure: 'apt-get install libegl1' },
        { backend: 'osmesa', works: true, renderer: 'llvmpipe', version: 'OpenGL ES 3.2', software: true },
      ],
      reference: { works: true, version: 'Embree 3' },
      imageFiles: { works: false, failure: 'no OpenImageIO' },
    }),
  };
  let running = 0;
  const pool = {
    createPool: async ({ size = 3, ...options }) => {
      const renderer = await open({ ...options, size });
      const counted = async (...args) => {
        running += 1;
        calls.mostAtOnce = Math.max(calls.mostAtOnce, running);
        return renderer.render(...args).finally(() => (running -= 1));
      };
      return { ...renderer, render: counted, workers: new Array(size).fill({}) };
    },
  };
  return { api, pool, calls };
}

/** A renderer whose methods wait until it is open. What is loaded ahead stays its source. */
const begun = (opening) => ({
  renderer: new Proxy({}, { get: (_, name) => (name === 'workers' ? undefined : async (...args) => (await opening)[name](...args)) }),
  opened: opening.then(() => {}),
  beginLoad: (source) => source,
});

const TERMINAL = { isTTY: true };

/** Runs the command line on a fake API: {exit, stdout, stderr, calls}. */
export async function runFake(argv, { stdin = '', env = {}, tty = false, signal, fake = fakeApi(), api = fake.api } = {}) {
  const collected = { stdout: [], stderr: [] };
  const sink = (name) =>
    Object.assign(
      new PassThrough().on('data', (chunk) => collected[name].push(chunk)),
      tty && TERMINAL,
    );
  const [stdout, stderr] = [sink('stdout'), sink('stderr')];
  const exit = await run(
    argv,
    {
      stdin: Readable.from(stdin === '' ? [] : [Buffer.from(stdin)]),
      stdout,
      stderr,
      env,
      signal,
      loadApi: async () => ({ ...api, beginRenderer: (options) => begun(api.createRenderer(options)) }),
      loadPool: async () => fake.pool,
    },
    COMMANDS,
  );
  return { exit, stdout: Buffer.concat(collected.stdout).toString(), stderr: Buffer.concat(collected.stderr).toString(), calls: fake.calls };
}

/** Whether no model was loaded or drawn. A renderer may have been opened beside the checks, and was closed. */
export const drewNothing = ({ created, closed, loaded, rendered }) => created.length === closed && loaded.length + rendered.length === 0;
