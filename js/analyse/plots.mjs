import { escaped } from '../compare/markup.mjs';

/** SVG plots that stand alone or inline: colours follow the reader's light or dark scheme, and print on white. */

const PALETTE = `.axis{stroke:#8a8a8a;stroke-width:.6;fill:none}.ring{stroke:#8a8a8a;stroke-width:.5;stroke-dasharray:2 3;fill:none}
.from{stroke:#2867b8}.to{stroke:#b8501f}.total{stroke-width:1.8;fill:none}.lobe{stroke-width:1;stroke-dasharray:4 2.5;fill:none;opacity:.75}
text{font:10px system-ui,sans-serif;fill:#444}.from-text{fill:#2867b8}.to-text{fill:#b8501f}.title{font-weight:600;font-size:11px;fill:#222}
.view{stroke:#8a8a8a;stroke-width:1}`;
const DARK = '.from{stroke:#7db2f5}.to{stroke:#f0965f}text{fill:#c4c4c4}.from-text{fill:#7db2f5}.to-text{fill:#f0965f}.title{fill:#e8e8e8}';

/** Lobes that a plot shows beside the total, and how their lines are broken. */
const LOBE_DASHES = { diffuse: '5 2', specular: '1.5 2', sheen: '7 2 1.5 2', coat: '3 4' };

const n = (value) => Number(value.toFixed(1));
const path = (points) => points.map(([x, y], i) => `${i === 0 ? 'M' : 'L'}${n(x)} ${n(y)}`).join('');
const text = (x, y, content, { anchor = 'start', className } = {}) =>
  `<text x="${n(x)}" y="${n(y)}"${anchor === 'start' ? '' : ` text-anchor="${anchor}"`}${className ? ` class="${className}"` : ''}>${escaped(content)}</text>`;

function svg(width, height, title, body) {
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" aria-label="${escaped(title)}">
<style>${PALETTE}
@media screen and (prefers-color-scheme:dark){${DARK}}</style>
${body.join('\n')}
</svg>`;
}

/** A round number at or above a value: 1, 2 or 5 times a power of ten. */
export function roundUp(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((step) => value <= step * power * (1 + 1e-9));
}

/** Lobes that reflect anything in either series. */
const lobesIn = (...series) => Object.keys(LOBE_DASHES).filter((lobe) => series.some((list) => list.some((value) => value[lobe] > 1e-6)));

/** Total and lobes of both series as paths; `place(value, i)` gives the point. */
function curves({ from, to }, place) {
  const shown = lobesIn(from, to);
  return [
    ['from', from],
    ['to', to],
  ].flatMap(([name, list]) => [
    ...shown.map(
      (lobe) => `<path class="lobe ${name}" style="stroke-dasharray:${LOBE_DASHES[lobe]}" d="${path(list.map((value, i) => place(value[lobe], i)))}"/>`,
    ),
    `<path class="total ${name}" d="${path(list.map((value, i) => place(value.total, i)))}"/>`,
  ]);
}

function legend(x, y, names, shown) {
  return [
    text(x, y, names.from, { className: 'from-text' }),
    text(x, y + 13, names.to, { className: 'to-text' }),
    ...shown.map(
      (lobe, i) =>
        `<path class="lobe view" style="stroke-dasharray:${LOBE_DASHES[lobe]}" d="M${x} ${y + 26 + i * 12}h18"/>${text(x + 23, y + 29.5 + i * 12, lobe)}`,
    ),
  ];
}

const POLAR = { width: 360, height: 236, x: 170, y: 196, radius: 156 };

/**
 * A polar plot in the plane of incidence: distance from the centre is the square root of the light that leaves towards the
 * viewer (BRDF times cosine), direction is where the light comes from; the viewer stands on the right.
 * @param {object} plot
 * @param {string} plot.title
 * @param {{from: string, to: string}} plot.names - Of the two shadings.
 * @param {number} plot.viewAngle - Degrees from the normal.
 * @param {number[]} plot.angles - Of the lights, degrees from the normal, positive on the viewer's side.
 * @param {import('./lobes.mjs').Lobes[]} plot.from
 * @param {import('./lobes.mjs').Lobes[]} plot.to
 * @returns {string} SVG
 */
export function lobePlot({ title, names, viewAngle, angles, from, to }) {
  const { width, height, x, y, radius } = POLAR;
  const largest = roundUp(Math.max(...from.map(({ total }) => total), ...to.map(({ total }) => total)));
  const at = (degrees, length) => [x + Math.sin((degrees * Math.PI) / 180) * length, y - Math.cos((degrees * Math.PI) / 180) * length];
  const place = (value, i) => at(angles[i], Math.sqrt(Math.max(0, value) / largest) * radius);
  const rings = [1, 0.25, 0.05].map((share) => {
    const r = Math.sqrt(share) * radius;
    const label = text(x - r, y + 11, String(Number((share * largest).toPrecision(3))), { anchor: 'middle' });
    return `<path class="ring" d="M${n(x - r)} ${y}A${n(r)} ${n(r)} 0 0 1 ${n(x + r)} ${y}"/>${label}`;
  });
  const [eyeX, eyeY] = at(viewAngle, radius + 12);
  return svg(width, height, title, [
    text(4, 13, title, { className: 'title' }),
    ...rings,
    `<path class="axis" d="M${x - radius} ${y}H${x + radius}M${x} ${y}V${y - radius}"/>`,
    `<path class="view" d="${path([[x, y], at(viewAngle, radius + 4)])}"/>`,
    text(eyeX, eyeY + 3, 'viewer', { anchor: 'middle' }),
    ...curves({ from, to }, place),
    ...legend(width - 92, 30, names, lobesIn(from, to)),
  ]);
}

const CURVE = { width: 360, height: 236, left: 40, right: 250, top: 26, bottom: 200 };

/**
 * The directional albedo over the angle between normal and viewer.
 * @param {object} plot
 * @param {string} plot.title
 * @param {{from: string, to: string}} plot.names
 * @param {number[]} plot.angles - Degrees, ascending.
 * @param {import('./lobes.mjs').Lobes[]} plot.from
 * @param {import('./lobes.mjs').Lobes[]} plot.to
 * @returns {string} SVG
 */
export function albedoPlot({ title, names, angles, from, to }) {
  const { width, height, left, right, top, bottom } = CURVE;
  const largest = roundUp(Math.max(...from.map(({ total }) => total), ...to.map(({ total }) => total)));
  const across = (degrees) => left + (degrees / 90) * (right - left);
  const up = (value) => bottom - (value / largest) * (bottom - top);
  const lines = [0, 0.25, 0.5, 0.75, 1].map(
    (share) =>
      `<path class="ring" d="M${left} ${n(up(share * largest))}H${right}"/>${text(left - 5, up(share * largest) + 3, String(Number((share * largest).toPrecision(3))), { anchor: 'end' })}`,
  );
  return svg(width, height, title, [
    text(4, 13, title, { className: 'title' }),
    ...lines,
    `<path class="axis" d="M${left} ${top}V${bottom}H${right}"/>`,
    ...[0, 30, 60, 90].map((degrees) => text(across(degrees), bottom + 13, `${degrees}°`, { anchor: 'middle' })),
    text((left + right) / 2, bottom + 28, 'angle between normal and viewer', { anchor: 'middle' }),
    ...curves({ from, to }, (value, i) => [across(angles[i]), up(value)]),
    ...legend(right + 14, 40, names, lobesIn(from, to)),
  ]);
}
