import { swapsBetween } from '../../../js/analyse/swaps.mjs';

/** A cloth whose terms do what a test plants: a disc, bright where it faces the viewer, seen through a fake renderer. */

const RADIUS = 0.8;

/** Cosine between normal and viewer at a pixel of a ball; null beside it. */
function cosineAt(x, y, size) {
  const [u, v] = [((x + 0.5) / size) * 2 - 1, ((y + 0.5) / size) * 2 - 1].map((value) => value / RADIUS);
  const inside = 1 - u * u - v * v;
  return inside > 0 ? Math.sqrt(inside) : null;
}

/**
 * Stands in for the API. A picture is grey 100 plus what `effects` of the slots give whose term is not three-r115's.
 * @param {(swapped: Set<string>, cosine: number, shot: object) => number} effect - What the swapped slots add to the grey.
 */
export function plantedApi(effect, { delay = async () => {} } = {}) {
  const calls = { loaded: 0, rendered: 0, closed: 0, released: 0 };
  const { terms } = swapsBetween('three-r115', 'disney-2012');
  const draw = (shot, colour) => {
    const { width, height } = shot.size;
    const data = new Float32Array(width * height * 4);
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const cosine = cosineAt(x, y, width);
        if (cosine !== null) data.set(colour(cosine), (y * width + x) * 4);
      }
    }
    return data;
  };
  const renderer = {
    load: async (source) => {
      calls.loaded += 1;
      return { source, facts: { materials: [{ name: 'leather' }] } };
    },
    render: async (_model, shot, { signal }) => {
      await delay();
      signal?.throwIfAborted();
      calls.rendered += 1;
      const swapped = new Set(terms.filter(({ slot, to }) => shot.shading[slot] === to).map(({ slot }) => slot));
      const data = Uint8Array.from(draw(shot, (cosine) => [...new Array(3).fill(Math.round(100 + effect(swapped, cosine, shot))), 255]));
      return { data: Buffer.from(data), info: { warnings: [{ code: 'W_RANGE', message: 'clamped' }], features: [] } };
    },
    renderQuantity: async (_model, shot) => ({ ...shot.size, data: draw(shot, (cosine) => [cosine, 0, 0, 1]) }),
    release: async () => void (calls.released += 1),
    close: async () => void (calls.closed += 1),
  };
  const lobes = (value) => ({ diffuse: [value, value, value], specular: [0, 0, 0], sheen: [0, 0, 0], coat: [0, 0, 0], total: [value, value, value] });
  const api = {
    createRenderer: async () => renderer,
    evaluateShading: async ({ directions = [], albedo }) => ({ radiance: directions.map(([, , z]) => lobes(z)), albedo: albedo ? lobes(0.5) : null }),
  };
  return { api, renderer, calls };
}

const SVG_OR_HTML_VOID = new Set(['meta', 'img', 'br', '!doctype']);

/** Complains about tags that are not closed in order, attributes without quotes and bare ampersands. */
export function assertWellFormed(text) {
  const open = [];
  const withoutStyle = text.replace(/<style>[\s\S]*?<\/style>/g, '');
  for (const [tag, closing, name, attributes] of withoutStyle.matchAll(/<(\/?)([!\w-]+)((?:[^<>"]|"[^"]*")*)>/g)) {
    if (closing) {
      const last = open.pop();
      if (last !== name) throw new Error(`${tag} closes <${last}>`);
    } else {
      const rest = attributes.replace(/\s+[\w:-]+(="[^"<]*")?/g, '').trim();
      if (rest !== '' && rest !== '/') throw new Error(`attributes of ${tag}`);
      if (rest !== '/' && !SVG_OR_HTML_VOID.has(name.toLowerCase())) open.push(name);
    }
  }
  if (open.length > 0) throw new Error(`left open: ${open.join(' ')}`);
  if (/&(?!#\d+;)/.test(withoutStyle)) throw new Error('a bare ampersand');
  if (/<(?![/!\w])/.test(withoutStyle)) throw new Error('a bare <');
}
