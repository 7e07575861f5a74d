import { row } from '../../js/build/docs/tables.mjs';

// js/docs/scale.md from what was measured: arithmetic and words, no measuring.

const MS_AN_HOUR = 3_600_000;
const RATES = [1, 100, 10_000];

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

const short = (value) => value.toFixed(value < 10 ? 1 : 0);
const pair = ({ wall, cpu }) => `${short(wall)}, ${short(cpu)} ms`;

const gpuTable = ({ pictures }) =>
  table(
    ['picture', 'from its file, GPU', 'llvmpipe', 'kept, GPU', 'llvmpipe', 'largest difference, mean', 'FLIP', 'gates passed'],
    pictures.map(({ name, file, kept, max, mean, flip, gates }) => [
      name,
      ...[file.here, file.llvmpipe, kept.here, kept.llvmpipe].map(pair),
      `${max}, ${mean.toFixed(1)}`,
      flip.toFixed(3),
      gates.join(', ') || 'none',
    ]),
  );

/**
 * The part of the page on GPUs.
 * @param {object} gpu - gpu.json: what `node test/bench/gpu.mjs --json FILE`, with and without `--cases gate`, wrote where a GPU was; `telarDraw`: CPU milliseconds of
 *   the T-shirt at 512 x 512 by telar_draw, as it is, with `--buffer always` and with `--hidden always`, and the drawing of the large one: frame upon frame, and with
 *   a PNG between
 */
export function gpuPart({ machine, here, llvmpipe, pictures, cases, telarDraw }) {
  const { draw, read, encode } = pictures[0].stages;
  const [[fresh, again], [freshThere, againThere]] = [here, llvmpipe].map(({ starts }) => starts);
  return `## What a GPU changes

Measured by \`npm run bench -- gpu\` on ${here.gl.renderer.split('/')[0]}, ${here.gl.version}, with ${machine.cores} cores (${machine.cpu}), Node ${machine.node}; beside it ${/Mesa [\d.]+/.exec(llvmpipe.gl.version)[0]}
llvmpipe on all of the same cores, where its threads cost more CPU together than on two. Wall and CPU time, medians; "kept": of a model that \`load()\` keeps. Differences are from llvmpipe's picture, in 1/255.

${gpuTable({ pictures })}

- Of the ${short(pictures[0].kept.here.wall)} ms of the first picture of a kept model the drawing takes ${draw.toFixed(1)}, reading back ${read.toFixed(1)} and the PNG ${encode.toFixed(1)}. From its file, decoding is most. So cores feed a GPU: a pool with
  ${here.rate.workers} workers draws ${grouped(here.rate.rate)} of it a second from its file, ${grouped(llvmpipe.rate.rate)} by llvmpipe, with ${here.rate.cores.toFixed(0)} cores busy either way.
- A process has its first picture after ${grouped(fresh.sinceStart)} ms (${grouped(freshThere.sinceStart)} by llvmpipe), ${grouped(fresh.compile)} ms of it for programs; ${grouped(again.sinceStart)} ms (${grouped(againThere.sinceStart)}) where the driver has kept them on the disk. Its memory then:
  ${grouped(fresh.memory.VmHWM)} and ${grouped(freshThere.memory.VmHWM)} MiB.
- What spares llvmpipe work is left out by itself: the look for hidden triangles and the buffer of what is seen, both on the CPU. Forced there, a frame of the T-shirt takes ${telarDraw.hidden.toFixed(0)} and
  ${telarDraw.buffer.toFixed(0)} ms of CPU in place of ${telarDraw.asIs}.
- A worker of a pool takes every step of [pool.md](pool.md) there, with the driver open, and its picture has the bytes of the renderer's.
- Drawing 2048 x 2048 takes ${telarDraw.large.draw} ms frame upon frame, ${telarDraw.large.between.toFixed(0)} ms with a PNG between two; a GPU that waits lowers its clock, which may be why.
- ${cases.drawn} cases of the parity gate were drawn by it, ${cases.failed.length === 0 ? 'none with an error' : `${cases.failed.length} with an error`} (those of models that the device had not are left out): ${cases.within.parity} are within \`parity\`
  of llvmpipe, ${cases.within['other-gl']} within \`other-gl\`; FLIP ${cases.flip.median.toFixed(3)} in the median, at most ${cases.flip.ninetyFive.toFixed(3)} in 95 of 100. ${cases.beyond.length} are beyond. What was looked at of these shows the same things, with maps that are
  much finer than the pixels or that have odd sizes: the GPU reads another mip level by a fraction, and makes the smaller levels otherwise.

<details><summary>Cases beyond \`other-gl\`</summary>

${cases.beyond.map((name) => `\`${name}\``).join(', ')}

</details>`;
}

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
 * @param {object} told - `peers`: what test/bench/peers.mjs writes; `growth`: test/bench/scale.mjs; `pictures`: by name, `bytes` of the PNG and `mib` of the process;
 *   `gpu`: gpu.json; `machine`
 * @param {{price: number, busy: number, command: string}} settings
 * @returns {string} js/docs/scale.md
 */
export function scalePage(told, settings) {
  const { machine } = told;
  const ratios = warm(told).map(({ telar, browser }) => browser.cpu / telar.cpu);
  const first = told.pictures[warm(told)[0].name];
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

${gpuPart(told.gpu)}

## Growth

One thing grows, the rest stays; a straight line through five points, each in a process of its own:

${growthTable(told)}

R2 is 1 where the points lie on the line. What limits a stranger's file is in [SECURITY.md](../../SECURITY.md); what a machine of your own can take is the line at its limit. Figures of other parts: [figures.md](figures.md); how far a
picture is from the least that it could cost: \`npm run bench -- floor\`.
`;
}
