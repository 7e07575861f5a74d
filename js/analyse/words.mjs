/** The direction of a change in words, each taken from a figure. */

/** Below this CIEDE2000 of the 95th percentile nobody sees a difference side by side. */
const NOT_VISIBLE_BELOW = 1;
/** Changes of CIELAB lightness and chroma that are worth a word, and that are worth a strong one. */
const WORTH = 0.5;
const STRONG = 5;
const CHROMA_WORTH = 1;
/** One region leads where it changes so many times as much as the other. */
const LEADS = 1.6;

const side = (lightness) => (lightness > 0 ? 'brighter' : 'darker');
const degree = (lightness) => (Math.abs(lightness) >= STRONG ? 'much ' : '');
const phrase = (lightness, where) => `${degree(lightness)}${side(lightness)} ${where}`;
const isWorth = (lightness) => Math.abs(lightness) >= WORTH;

/** Limb and centre: one phrase where they go together or one leads, two where they go apart. */
function ofShape(limb, centre) {
  const [l, c] = [limb?.lightness ?? 0, centre?.lightness ?? 0];
  if (!isWorth(l) && !isWorth(c)) return [];
  if (isWorth(l) && isWorth(c) && l * c < 0) return [phrase(l, 'limb'), phrase(c, 'centre')];
  if (Math.abs(l) >= LEADS * Math.abs(c)) return [phrase(l, 'limb')];
  if (Math.abs(c) >= LEADS * Math.abs(l)) return [phrase(c, 'centre')];
  return [phrase((l + c) / 2, 'throughout')];
}

/** Highlights, where they change otherwise than the cloth around them. */
function ofHighlight(highlight, cloth) {
  const own = (highlight?.lightness ?? 0) - cloth.lightness;
  if (Math.abs(own) < 2 * WORTH) return [];
  return [`${Math.abs(own) >= STRONG ? 'much ' : ''}${own > 0 ? 'stronger' : 'weaker'} highlights`];
}

const ofChroma = ({ chroma }) => (Math.abs(chroma) < CHROMA_WORTH ? [] : [chroma > 0 ? 'more saturated' : 'paler']);

/**
 * @param {import('./differences.mjs').Difference} difference
 * @returns {string} as in "much brighter limb, weaker highlights, paler"; "no change" for equal pictures
 */
export function inWords(difference) {
  const { deltaE, cloth, limb, centre, highlight } = difference;
  if (deltaE.p95 === 0 && deltaE.mean === 0) return 'no change';
  if (deltaE.p95 < NOT_VISIBLE_BELOW) return 'not visible';
  const words = [...ofShape(limb, centre), ...ofHighlight(highlight, cloth), ...ofChroma(cloth)];
  return words.join(', ') || 'local changes that even out';
}
