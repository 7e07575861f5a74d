import { INCH } from '../shot/true_scale.mjs';
import { DASH } from '../shot/table/flat.mjs';

/** Millimetres of an inch and pixels of CSS in it. */
const PIXEL_MM = INCH / 96;

const text = (x) => String(Number(x.toFixed(3)));

function pathOf({ points, closed }, unit) {
  const [first, ...rest] = points.map(([x, y]) => `${text(x * unit)} ${text(y * unit)}`);
  return `M${first}L${rest.join(' ')}${closed ? 'Z' : ''}`;
}

/**
 * A flat as SVG: one path a kind, the lightest lines first, so that heavier ones lie over their ends.
 * @param {{width: number, height: number, strokes: {kind: string, closed: boolean, points: number[][]}[], millimetresPerPixel: number | null}} flat
 * @param {{scale?: number, weights: Record<string, number>, color: string}} style scale: n of 1:n, for an orthographic camera
 * @returns {string}
 */
export function svgOf({ width, height, strokes, millimetresPerPixel }, { scale, weights, color }) {
  // Units of the picture are millimetres on paper. Without a scale a pixel is one of CSS.
  const unit = scale === undefined ? PIXEL_MM : millimetresPerPixel / scale;
  const [w, h] = [text(width * unit), text(height * unit)];
  const kinds = Object.keys(weights).toReversed();
  const paths = kinds.flatMap((kind) => {
    const drawn = strokes.filter((stroke) => stroke.kind === kind);
    if (drawn.length === 0 || weights[kind] === 0) return [];
    const dash = kind === 'stitch' ? ` stroke-dasharray="${DASH.map((part) => text(part * weights[kind])).join(' ')}" stroke-linecap="butt"` : '';
    return `<path class="${kind}" stroke-width="${text(weights[kind])}"${dash} d="${drawn.map((stroke) => pathOf(stroke, unit)).join('')}"/>`;
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${w}mm" height="${h}mm" viewBox="0 0 ${w} ${h}">`,
    `<g fill="none" stroke="${color}" stroke-linecap="round" stroke-linejoin="round">`,
    ...paths,
    '</g>',
    '</svg>',
    '',
  ].join('\n');
}
