import { row } from '../../js/build/docs/tables.mjs';

// js/docs/scale.md from what was measured: arithmetic and words, no measuring.

const MS_AN_HOUR = 3_600_000;
const RATES = [1, 100, 10_000];
const SAMPLES = 4;
/** Of a small GPU: a billion a second. */
const FRAGMENTS_A_MS = 1e6;

/** Cores that draw `rate` pictures a second of `cpuMs` each, where cores may be busy for the part `busy` of the time. */
export const coresFor = (rate, cpuMs, busy) => (rate * cpuMs) / 1000 / busy;

/** Price of a million pictures, at `price` a core-hour. */
export const priceOfMillion = (cpuMs, { price, busy }) => ((1e6 * cpuMs) / MS_AN_HOUR / busy) * price;

const ms = (value) => `${value.toFixed(0)} ms`;
const table = (head, rows) => [row(head), row(head.map(() => '---')), ...rows.map(row)].join('\n');
const grouped = (value) => Math.round(value).toLocaleString('en');
const cores = (value) => (value < 10 ? value.toFixed(1) : grouped(Math.ceil(value)));
const gibibytes = (mebibytes) => {
  if (mebibytes < 1024) return `${mebibytes.toFixed(0)} MiB`;
  return mebibytes < 10_240 ? `${(mebibytes / 1024).toFixed(1)} GiB` : `${grouped(mebibytes / 1024)} GiB`;
};
const significant = (value) => Number(value.toPrecision(3)).toString();
const meanOf = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;

function costs({ peers, pictures }) {
  return table(
    ['picture, from file to PNG', 'telar, CPU', 'memory', 'bytes', 'Chromium, CPU', 'ratio', 'telar, wall', 'Chromium, wall'],
    peers.pictures.map(({ name, telar, browser }) => [
      name,
      ms(telar.cpu),
      pictures[name] ? gibibytes(pictures[name].mib) : '',
      pictures[name] ? grouped(pictures[name].bytes) : '',
      ms(browser.cpu),
      (browser.cpu / telar.cpu).toFixed(1),
      ms(telar.wall),
      ms(browser.wall),
    ]),
  );
}

/** Those that are drawn from a file again and again; the last one of the peers starts a process. */
const warm = ({ peers, pictures }) => peers.pictures.filter(({ name }) => pictures[name]);

function ratesTable(told, { busy }) {
  const { telar, browser } = warm(told)[0];
  const rows = RATES.flatMap((rate) =>
    [
      ['telar', telar, told.peers.mebibytes.telar],
      ['Chromium', browser, told.peers.mebibytes.browser],
    ].map(([name, { cpu }, mebibytes]) => {
      const wanted = coresFor(rate, cpu, busy);
      return [grouped(rate), name, cores(wanted), gibibytes(Math.max(1, Math.ceil(wanted)) * mebibytes), grouped(Math.max(1, Math.ceil(wanted / 64)))];
    }),
  );
  return table(['pictures a second', 'with', 'cores', 'memory, one process a core', 'machines of 64 cores'], rows);
}

const pricesTable = (told, settings) =>
  table(
    ['a million of', 'telar', 'Chromium', 'saved'],
    warm(told).map(({ name, telar, browser }) => {
      const [own, theirs] = [telar, browser].map(({ cpu }) => priceOfMillion(cpu, settings));
      return [name, own.toFixed(2), theirs.toFixed(2), (theirs - own).toFixed(2)];
    }),
  );

/** Milliseconds that stay on the CPU where drawing costs nothing. */
const leftOf = ({ cpu, redrawn, after }) => Math.min(cpu, cpu - redrawn + after);

const gpuTable = (told) =>
  table(
    ['picture', 'pixels covered', 'CPU at 512 x 512', 'of it the drawing', 'left with a GPU', 'at most faster by'],
    warm(told)
      .filter(({ name }) => told.pictures[name].redrawn !== undefined)
      .map(({ name }) => {
        const { cpu, covered } = told.pictures[name];
        const left = leftOf(told.pictures[name]);
        return [name, grouped(covered), ms(cpu), ms(Math.max(0, cpu - left)), ms(left), (cpu / left).toFixed(1)];
      }),
  );

/** Whether a quantity grows by a tenth at all, so that its line says something. */
const grows = ({ fixed, each }, points) => each * points.at(-1).count > 0.1 * fixed;

const growthTable = ({ growth }) =>
  table(
    ['one more', 'CPU', 'memory', 'without any', 'R2 of CPU, of memory', 'measured to'],
    growth.map(({ unit, cpu, mib, points }) => [
      unit,
      `${significant(cpu.each)} ms`,
      grows(mib, points) ? `${significant(mib.each)} MiB` : 'none',
      `${cpu.fixed.toFixed(0)} ms, ${mib.fixed.toFixed(0)} MiB`,
      `${cpu.r2.toFixed(4)}, ${grows(mib, points) ? mib.r2.toFixed(4) : '-'}`,
      `${significant(points.at(-1).count)}: ${ms(points.at(-1).cpu)}, ${gibibytes(points.at(-1).mib)}`,
    ]),
  );

/**
 * @param {object} told - `peers`: what test/bench/peers.mjs writes; `growth`: test/bench/scale.mjs; `pictures`: by name, `bytes` of the PNG, `mib` of the process, and
 *   milliseconds of CPU: `cpu` of a picture, `redrawn` of the same of a model that is kept, `after` of reading back and encoding; `covered` pixels; `machine`
 * @param {{price: number, busy: number, command: string}} settings
 * @returns {string} js/docs/scale.md
 */
export function scalePage(told, settings) {
  const { machine } = told;
  const ratios = warm(told).map(({ telar, browser }) => browser.cpu / telar.cpu);
  const first = told.pictures[warm(told)[0].name];
  const fed = { cpu: first.cpu, left: leftOf(first) };
  const fill = ((Math.max(...Object.values(told.pictures).map(({ covered }) => covered)) * SAMPLES) / FRAGMENTS_A_MS).toFixed(1);
  return `# How large does this get

What a picture costs, what many cost, and how that grows. Written by \`${settings.command}\` on ${machine.cores} cores (${machine.cpu}), ${machine.gl}, Node ${machine.node}; load of the machine
at the start ${machine.load.toFixed(1)}${machine.load > 0.5 ? ', so that other work was there as well: times are too high, ratios and fits less exact' : ''}. Medians of ${machine.runs}.

## One picture

${costs(told)}

The two draw in turns, the same pictures by the bars of the parity gate, on the same Mesa; Chromium hands over pixels, not a PNG. CPU is of all threads and processes; memory
the largest of a process that draws that picture alone, Node included. Ratio of the
pictures that are drawn again, mean: ${meanOf(ratios).toFixed(1)}. Memory of all processes with five models drawn: ${gibibytes(told.peers.mebibytes.telar)} and ${gibibytes(told.peers.mebibytes.browser)}.

## Many pictures

Of the first line above, with cores that are busy for ${(settings.busy * 100).toFixed(0)} % of the time, so that requests seldom wait:

${ratesTable(told, settings)}

cores = pictures a second x CPU seconds / ${settings.busy}. A pool has one worker a core ([pool.md](pool.md)), a queue spreads them over machines. Pictures share nothing but the cache of environments, so
cores add up; what does not grow with them is the network: at 10,000 a second, ${gibibytes((10_000 * first.bytes) / 2 ** 20)} of pictures leave each second. The cheapest picture is the one
that is not drawn: \`info.key\` names it before ([many.md](many.md), [server.md](server.md)).

## A million pictures

At ${settings.price} for a core-hour (a mid-size machine of a large provider, in its currency; \`--price\` sets yours), cores busy for ${(settings.busy * 100).toFixed(0)} %:

${pricesTable(told, settings)}

## What a GPU changes

No GPU was at hand. What it could take is the drawing: vertices, fragments, and the look for hidden triangles, which only llvmpipe needs. A model that is kept (\`load()\`) is only drawn, read back and encoded; what
a GPU leaves is the rest of a picture from its file, reading back and the PNG:

${gpuTable(told)}

So a GPU helps large pictures, many samples and dear materials, and less a thumbnail of a model that is decoded for it alone. A GPU that shades a billion fragments a second, which small ones do, takes ${fill} ms for
the most of these pixels, each of their four samples apart; with the model kept, what is left on the CPU is the PNG. Cores feed a GPU: 100 of the first picture a second still take ${cores(coresFor(100, fed.left, settings.busy))} of
them in place of ${cores(coresFor(100, fed.cpu, settings.busy))}.

## Growth

One thing grows, the rest stays; a straight line through five points, each in a process of its own:

${growthTable(told)}

R2 is 1 where the points lie on the line. What limits a stranger's file is in [SECURITY.md](../../SECURITY.md); what a machine of your own can take is the line at its limit. Figures of other parts: [figures.md](figures.md); how far a
picture is from the least that it could cost: \`npm run bench -- floor\`.
`;
}
