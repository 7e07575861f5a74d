import { escaped } from '../compare/markup.mjs';
import { PRESET_NAMES } from '../predict/settings.mjs';
import { frontOf } from './front.mjs';

/** SVG plots of time against error that stand alone or inline: colours follow the reader's light or dark scheme. */

const FRAME = { width: 560, height: 340, left: 52, right: 440, top: 30, bottom: 290 };
const STYLE = `.axis{stroke:#8a8a8a;stroke-width:.6;fill:none}.grid{stroke:#8a8a8a;stroke-width:.4;stroke-dasharray:2 3}.front{stroke:#2867b8;stroke-width:1.6;fill:none}
.prefiltered{fill:#b8501f}.denoised{fill:#2867b8}.tracer{fill:#3d8f4f}.peer{fill:#8a4fbf}.other{fill:#777}.scaled{fill-opacity:.35}
text{font:10px system-ui,sans-serif;fill:#444}.title{font-weight:600;font-size:11px;fill:#222}.preset{font-weight:600}`;
const DARK =
  '.front{stroke:#7db2f5}.prefiltered{fill:#f0965f}.denoised{fill:#7db2f5}.tracer{fill:#7fce91}.peer{fill:#c79bf0}text{fill:#c4c4c4}.title{fill:#e8e8e8}';
const FAMILY_NAMES = { prefiltered: 'prefiltered light', denoised: 'raster, denoised', tracer: 'path tracer', peer: 'others' };

const n = (value) => Number(value.toFixed(1));
const text = (x, y, content, more = '') => `<text x="${n(x)}" y="${n(y)}"${more}>${escaped(content)}</text>`;

/** Powers of ten that hold all values. */
function decades(values) {
  const logs = values.map((value) => Math.log10(value));
  const [low, high] = [Math.floor(Math.min(...logs)), Math.ceil(Math.max(...logs))];
  return [low, high > low ? high : low + 1];
}

const timeText = (ms) => (ms >= 1000 ? `${ms / 1000} s` : `${ms} ms`);

/**
 * @param {string} title
 * @param {{setting: string, family: string, cpuMs: number, flip: number, timed?: string}[]} points not empty
 * @returns {string} SVG: time on a logarithmic axis against FLIP, the Pareto front, presets and others (family "peer", not on the front) by name
 */
export function tradePlot(title, points) {
  const { width, height, left, right, top, bottom } = FRAME;
  const [from, to] = decades(points.map(({ cpuMs }) => cpuMs));
  const most = Math.max(...points.map(({ flip }) => flip), 0.01) * 1.08;
  const x = (ms) => left + ((Math.log10(ms) - from) / (to - from)) * (right - left);
  const y = (flip) => bottom - (flip / most) * (bottom - top);
  const ticks = Array.from({ length: to - from + 1 }, (_, i) => 10 ** (from + i));
  const steps = [0, 0.25, 0.5, 0.75, 1].map((part) => part * most);
  const front = frontOf(points.filter(({ family }) => family !== 'peer'));
  const stairs = front.map(({ cpuMs, flip }, i) => (i === 0 ? `M${n(x(cpuMs))} ${n(y(flip))}` : `H${n(x(cpuMs))}V${n(y(flip))}`)).join('');
  const named = Object.entries(PRESET_NAMES).flatMap(([preset, setting]) =>
    points.filter((point) => point.setting === setting).map((point) => [preset, point]),
  );
  named.push(...points.filter(({ family }) => family === 'peer').map((point) => [point.setting, point]));
  const families = Object.entries(FAMILY_NAMES).filter(([family]) => points.some((point) => point.family === family));
  const mark = ({ setting, family, cpuMs, flip, timed }) =>
    `<circle class="${family}${timed === 'window' ? ' scaled' : ''}" cx="${n(x(cpuMs))}" cy="${n(y(flip))}" r="3.4"><title>${escaped(`${setting}: FLIP ${flip.toFixed(4)}, ${cpuMs.toFixed(0)} ms`)}</title></circle>`;
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" aria-label="${escaped(title)}">
<style>${STYLE}
@media screen and (prefers-color-scheme:dark){${DARK}}</style>
${text(4, 14, title, ' class="title"')}
${ticks.map((ms) => `<path class="grid" d="M${n(x(ms))} ${top}V${bottom}"/>${text(x(ms), bottom + 14, timeText(ms), ' text-anchor="middle"')}`).join('\n')}
${steps.map((flip) => `<path class="grid" d="M${left} ${n(y(flip))}H${right}"/>${text(left - 5, y(flip) + 3, flip.toFixed(3), ' text-anchor="end"')}`).join('\n')}
<path class="axis" d="M${left} ${top}V${bottom}H${right}"/>
${text((left + right) / 2, bottom + 32, 'CPU time of a picture', ' text-anchor="middle"')}
${text(left - 44, top - 8, 'FLIP')}
<path class="front" d="${stairs}"/>
${points.map(mark).join('\n')}
${named.map(([preset, { cpuMs, flip }]) => text(x(cpuMs) + 6, y(flip) - 5, preset, ' class="preset"')).join('\n')}
${families.map(([family, name], i) => `<circle class="${family}" cx="${right + 14}" cy="${top + 8 + 15 * i}" r="3.4"/>${text(right + 22, top + 11.5 + 15 * i, name)}`).join('\n')}
<path class="front" d="M${right + 8} ${top + 8 + 15 * families.length}h12"/>${text(right + 24, top + 11.5 + 15 * families.length, 'Pareto front')}
</svg>`;
}
