import { resolveShot } from '../../../js/shot/index.mjs';

const FACTS = { bounds: { min: [-1, -1, -1], max: [1, 1, 1] }, triangles: 1000, variants: [], cameras: [], animations: [] };

/** How far off a quality is, levels of 255: what a test plants. */
const offset = ({ preset, samples }) => (preset === 'reference' ? 4 / Math.sqrt(samples) : 64 / Math.sqrt(samples));

/**
 * Stands in for the API: a disc that fills 0.8 of the picture's height, as grey as its quality is wrong.
 * @param {{fail?: (count: number) => void, gl?: string}} [options] gl: what the machine draws with
 * @returns {{api: object, calls: {rendered: object[], inspected: object[], loaded: string[], released: number, closed: number}}}
 */
export function plantedBench({ fail = () => {}, gl = 'planted' } = {}) {
  const calls = { rendered: [], inspected: [], loaded: [], released: 0, closed: 0 };
  const render = async (model, shot, { signal } = {}) => {
    signal?.throwIfAborted();
    const resolved = resolveShot(shot, FACTS);
    calls.rendered.push({ source: model.source, shot: resolved });
    fail(calls.rendered.length);
    const { width, height } = resolved.size;
    const data = Buffer.alloc(width * height * 4);
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const isInside = Math.hypot((2 * x + 1) / width - 1, (2 * y + 1) / height - 1) < 0.8;
        if (isInside) data.set([...new Array(3).fill(Math.round(100 + offset(resolved.quality))), 255], (y * width + x) * 4);
      }
    }
    return {
      data,
      info: {
        shot: resolved,
        key: JSON.stringify([model.source, { ...shot, quality: '' }]),
        picture: { coverage: 0.5 },
        passes: ['surface'],
        milliseconds: { draw: 1 },
        samples: 1,
        warnings: [],
      },
    };
  };
  const api = {
    createRenderer: async () => ({
      gl: { renderer: gl },
      load: async (source) => {
        calls.loaded.push(source);
        return { source };
      },
      render,
      release: async () => void (calls.released += 1),
      close: async () => void (calls.closed += 1),
    }),
    inspect: async (_source, options) => {
      calls.inspected.push(options);
      return { ...FACTS, plan: { features: ['normal-map', 'environment'], fragments: 9000 } };
    },
  };
  return { api, calls };
}
