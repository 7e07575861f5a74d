import { cornersOfBox } from '../shot/frame.mjs';

/** A first spec, made of what a model tells: something to start from. */

const titled = (text) => {
  const words = text.replaceAll(/[_.]+/g, ' ').trim();
  return words === '' ? '' : words[0].toUpperCase() + words.slice(1);
};

/** Millimetres to a tenth of a centimetre. */
const centimetres = (metres) => Number((100 * metres).toFixed(1));

/** What materials of one cloth in several colours share: "jersey" of jersey_natural and jersey_indigo. */
function withoutVariant(name, variants) {
  const found = variants.find((variant) => name.toLowerCase().endsWith(variant.toLowerCase()) && name.length > variant.length);
  return found ? name.slice(0, -found.length).replace(/[\s_.-]+$/, '') : name;
}

/** Part of the extent by which a point may lie nearer than the farthest. */
const AS_FAR = 0.02;
/** What a pair that leans in the front view counts against one whose length is off by as much. */
const LEANING = 0.25;
/** Pairs whose costs differ by less are alike, metres: anchors are rounded so, and a model far from the origin has such noise. */
const ALIKE = 1e-4;

const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

/**
 * Of the points that lie farthest out along an axis, two whose distance is the extent of the front view, and that are level or upright there.
 * A line that runs in depth too is longer than the front shows it; one within the outline is shorter. Of pairs that are alike it is the
 * nearest to the viewer.
 * @param {0 | 1} axis
 */
function farthestPair(points, axis) {
  const along = points.map((point) => point[axis]);
  const [low, high] = [Math.min(...along), Math.max(...along)];
  const ends = [low, high].map((end) => points.filter((point) => Math.abs(point[axis] - end) <= AS_FAR * (high - low)));
  const pairs = ends[0].flatMap((from) =>
    ends[1].map((to) => {
      const shown = to[axis] - from[axis];
      const [missing, excess] = [high - low - shown, distance(from, to) - shown];
      return { pair: [from, to], cost: missing + excess + LEANING * Math.abs(from[1 - axis] - to[1 - axis]), near: from[2] + to[2] };
    }),
  );
  const least = pairs.reduce((cost, pair) => Math.min(cost, pair.cost), Infinity);
  return pairs.filter(({ cost }) => cost < least + ALIKE).reduce((best, pair) => (pair.near > best.near + ALIKE ? pair : best)).pair;
}

/** Overall width and length as points of measure: between the points of the model that lie farthest out. */
function overall({ bounds, outline }) {
  const points = outline?.length > 1 ? outline : cornersOfBox(bounds);
  const round = (point) => point.map((value) => Number(value.toFixed(4)));
  const [[left, right], [bottom, top]] = [0, 1].map((axis) => farthestPair(points, axis).map(round));
  return { anchors: { left, right, top, bottom }, size: [distance(left, right), distance(top, bottom)] };
}

/** Most colours of a colourway: those of the materials that are most of it. */
const SWATCHES = 6;

/** The materials of a variant as its colours, which the sheet measures; by name where no other has it. */
function swatchesOf({ materials = [], variants, variantMaterials = [] }, i) {
  return (variantMaterials[i] ?? []).slice(0, SWATCHES).map((index) => {
    const { name } = materials[index];
    const part = titled(withoutVariant(name, variants));
    const isAlone = name !== '' && materials.filter((other) => other.name === name).length === 1;
    return { ...(part && { part }), material: isAlone ? name : index };
  });
}

/**
 * @param {object} facts of a loaded model
 * @param {{name?: string, language?: string}} [options] name: of the style, where the model has none
 * @returns {object} a spec
 */
export function firstSpec(facts, { name, language = 'en' } = {}) {
  const { anchors, size } = overall(facts);
  const variants = facts.variants ?? [];
  const materials = [...new Set((facts.materials ?? []).map((material) => withoutVariant(material.name, variants)).filter(Boolean))];
  const [width, height] = size.map(centimetres);
  const spanish = language.startsWith('es');
  const words = spanish ? ['Ancho total', 'Largo total'] : ['Overall width', 'Overall length'];
  return {
    language,
    units: 'cm',
    paper: { size: 'A4', orientation: 'landscape' },
    header: { style: '', name: titled(facts.name || name || ''), season: '', brand: '', sizes: ['M'], baseSize: 'M', date: '', revision: '1', author: '' },
    views: [...['front', 'back'].map((view) => ({ name: view, view })), ...['front', 'back'].map((view) => ({ name: `flat-${view}`, view, style: 'flat' }))],
    anchors,
    callouts: [],
    details: [],
    measures: [
      { code: 'A', description: words[0], view: 'flat-front', points: ['left', 'right'], tolerance: 1, values: { M: width } },
      { code: 'B', description: words[1], view: 'flat-front', points: ['top', 'bottom'], tolerance: 1, values: { M: height } },
    ],
    colourways: variants.slice(0, 48).map((variant, i) => ({ name: titled(variant), variant, swatches: swatchesOf(facts, i) })),
    bill: materials.slice(0, 500).map((material) => ({ item: titled(material), composition: '', supplier: '', placement: '' })),
    construction: [],
    labels: [],
    care: { symbols: [] },
    artwork: [],
    revisions: [],
  };
}
