import { cornersOfBox } from '../shot/frame.mjs';
import { HUGE } from '../shot/table/rows.mjs';
import { isName, oneLine, unlike } from './names.mjs';
import { LENGTH_MAX, MOST } from './table/basics.mjs';

/** A first spec, made of what a model tells: something to start from. */

/** "Crew neck" of crew_neck; a name of such marks alone stays as it is. */
function titled(text = '') {
  const words = text.replaceAll(/[_.\s]+/g, ' ').trim();
  return oneLine(words === '' ? text : words[0].toUpperCase() + words.slice(1));
}

/** Metres to a tenth of a centimetre. */
const centimetres = (metres) => Number((100 * metres).toFixed(1));

/** What materials of one cloth in several colours share: "jersey" of jersey_natural and jersey_indigo. */
function withoutVariant(name, variants) {
  const lower = name.toLowerCase();
  const found = variants.find((variant) => variant !== '' && name.length > variant.length && lower.endsWith(variant.toLowerCase()));
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
  return pairs.filter(({ cost }) => cost <= least + ALIKE).reduce((best, pair) => (pair.near > best.near + ALIKE ? pair : best)).pair;
}

/** Overall width and length: between the points of the model that lie farthest out. Nothing where these are no places that a spec may name. */
function overall({ bounds, outline }, words) {
  const points = outline?.length > 1 ? outline : cornersOfBox(bounds);
  if (!points.flat().every((value) => Math.abs(value) <= HUGE)) return { anchors: {}, measured: [] };
  const round = (point) => point.map((value) => Number(value.toFixed(4)));
  const [[left, right], [bottom, top]] = [0, 1].map((axis) => farthestPair(points, axis).map(round));
  return {
    anchors: { left, right, top, bottom },
    measured: [
      { code: 'A', description: words.width, points: ['left', 'right'], size: distance(left, right) },
      { code: 'B', description: words.length, points: ['top', 'bottom'], size: distance(top, bottom) },
    ],
  };
}

/** Most colours of a colourway: those of the materials that are most of it. */
const SWATCHES = 6;

/** The materials of a variant as its colours, which the sheet measures; by name where no other has it. */
function swatchesOf({ materials = [], variants, variantMaterials = [] }, i) {
  return (variantMaterials[i] ?? []).slice(0, SWATCHES).map((index) => {
    const { name } = materials[index];
    const part = titled(withoutVariant(name, variants));
    const isAlone = name !== '' && isName(name) && materials.filter((other) => other.name === name).length === 1;
    return { ...(part && { part }), material: isAlone ? name : index };
  });
}

/** A colourway of each variant that a spec can name: "" means none, and of several of one name the first is shown. */
function colourwaysOf(facts, word) {
  const first = new Map(facts.variants.map((variant, i) => [variant, i]).reverse());
  const named = [...first].reverse().filter(([variant]) => variant !== '' && isName(variant));
  const taken = new Set();
  return named.slice(0, MOST.colourways).map(([variant, i]) => ({ name: unlike(titled(variant) || word, taken), variant, swatches: swatchesOf(facts, i) }));
}

/** What a garment is made of: each cloth once. */
const clothsOf = (materials, variants) => [...new Set(materials.map(({ name }) => titled(withoutVariant(name, variants))).filter(Boolean))];

/** The specified length, centimetres; a spec has none that is longer than its largest. */
const valuesOf = (metres) => (centimetres(metres) <= LENGTH_MAX ? { M: centimetres(metres) } : {});

/** Words of a first spec. */
const WORDS = {
  en: { width: 'Overall width', length: 'Overall length', colourway: 'Colourway' },
  es: { width: 'Ancho total', length: 'Largo total', colourway: 'Variante' },
};

/**
 * @param {object} facts of a loaded model
 * @param {{name?: string, language?: string}} [options] name: of the style, where the model has none
 * @returns {object} a spec
 */
export function firstSpec(facts, { name, language = 'en' } = {}) {
  const { variants = [], materials = [] } = facts;
  const words = language.startsWith('es') ? WORDS.es : WORDS.en;
  const { anchors, measured } = overall(facts, words);
  return {
    language,
    units: 'cm',
    paper: { size: 'A4', orientation: 'landscape' },
    header: { style: '', name: titled(facts.name || name), season: '', brand: '', sizes: ['M'], baseSize: 'M', date: '', revision: '1', author: '' },
    views: [...['front', 'back'].map((view) => ({ name: view, view })), ...['front', 'back'].map((view) => ({ name: `flat-${view}`, view, style: 'flat' }))],
    anchors,
    callouts: [],
    details: [],
    measures: measured.map(({ size, ...measure }) => ({ ...measure, view: 'flat-front', tolerance: 1, values: valuesOf(size) })),
    colourways: colourwaysOf({ ...facts, materials, variants }, words.colourway),
    bill: clothsOf(materials, variants)
      .slice(0, MOST.bill)
      .map((item) => ({ item, composition: '', supplier: '', placement: '' })),
    construction: [],
    labels: [],
    care: { symbols: [] },
    artwork: [],
    revisions: [],
  };
}
