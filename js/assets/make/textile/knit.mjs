import { seeded } from '../random.mjs';

/**
 * Knitted cloth as a height field, loop by loop. One tile is `TILE` metres wide and repeats without a
 * seam. Rows run down the picture as v does; wales stand upright.
 */

export const TILE = 0.02;

/**
 * Loop counts per tile and lengths in units of one wale's width. The counts are powers of two: then a
 * loop fills whole texels on every smaller level of the texture, and no beat shows from afar.
 */
export const JERSEY = { wales: 32, courses: 32, yarnRadius: 0.2, overhang: 0.23, reach: 0.8, depth: 0.2, ribs: 0, ribDepth: 0 };
export const RIB = { wales: 32, courses: 32, yarnRadius: 0.2, overhang: 0.21, reach: 0.8, depth: 0.2, ribs: 8, ribDepth: 0.95 };

const LOOP_STEPS = 72;

// The classic plane loop: a foot, a leg, a head that overhangs, a leg. On the face the legs lie on top.
function loopPoint(knit, wale, course, t, drift) {
  const width = TILE / knit.wales;
  const height = TILE / knit.courses;
  const x = (wale + t / (2 * Math.PI)) * width + knit.overhang * width * Math.sin(2 * t);
  const y = (course + drift) * height - knit.reach * height * Math.cos(t);
  const rib = knit.ribs ? knit.ribDepth * width * (0.5 - 0.5 * Math.cos((2 * Math.PI * knit.ribs * (x - width / 2)) / TILE)) : 0;
  return [x, y, -knit.depth * width * Math.cos(2 * t) - rib];
}

/**
 * @param {object} knit - As JERSEY.
 * @param {number} size - Texels along one edge.
 * @param {number} seed - Of the yarn's variation.
 * @returns {{height: Float64Array, tone: Float64Array, size: number}} Height in metres; tone is the yarn's relative brightness
 *   around 1.
 */
export function knitTile(knit, size, seed) {
  const random = seeded(seed);
  const height = new Float64Array(size * size).fill(-TILE);
  const tone = new Float64Array(size * size).fill(1);
  const texel = TILE / size;
  const radius = (knit.yarnRadius * TILE) / knit.wales;
  for (let course = 0; course < knit.courses; course++) {
    const yarnTone = 1 + (random() - 0.5) * 0.012;
    for (let wale = 0; wale < knit.wales; wale++) {
      const loop = { drift: (random() - 0.5) * 0.07, thick: radius * (1 + (random() - 0.5) * 0.14), tone: yarnTone + (random() - 0.5) * 0.06 };
      layLoop({ knit, wale, course, loop }, { height, tone, size, texel });
    }
  }
  return { height, tone, size };
}

function layLoop({ knit, wale, course, loop }, tile) {
  let before = loopPoint(knit, wale, course, 0, loop.drift);
  for (let step = 1; step <= LOOP_STEPS; step++) {
    const t = (step / LOOP_STEPS) * 2 * Math.PI;
    const here = loopPoint(knit, wale, course, t, loop.drift);
    const [dx, dy] = [here[0] - before[0], here[1] - before[1]];
    const length = Math.hypot(dx, dy) || 1;
    stampYarn(tile, here, { across: [-dy / length, dx / length], loop, twist: course * 2.1 + wale * 0.7 + t * 5 });
    before = here;
  }
}

function stampYarn({ height, tone, size, texel }, [x, y, z], { across, loop, twist }) {
  const reach = Math.ceil(loop.thick / texel);
  const [cx, cy] = [Math.round(x / texel), Math.round(y / texel)];
  for (let j = cy - reach; j <= cy + reach; j++) {
    for (let i = cx - reach; i <= cx + reach; i++) {
      const [ox, oy] = [(i + 0.5) * texel - x, (j + 0.5) * texel - y];
      const off = (ox * ox + oy * oy) / loop.thick ** 2;
      if (off >= 1) continue;
      // Staple fibres wind around the yarn: fine ridges, slanted against its run.
      const side = (ox * across[0] + oy * across[1]) / loop.thick;
      const fibre = Math.sin(twist + side * 4.2) * Math.sqrt(1 - off);
      const top = z + loop.thick * (Math.sqrt(1 - off) + 0.06 * fibre);
      const at = ((((size - 1 - j) % size) + size) % size) * size + (((i % size) + size) % size);
      if (top <= height[at]) continue;
      height[at] = top;
      tone[at] = loop.tone + 0.025 * fibre;
    }
  }
}

/** The two needle lines of a hem, metres above its edge, and how the thread lies in them. */
const STITCH = { lines: [0.0135, 0.0172], perTile: 8, radius: 0.00023, groove: 0.00042, grooveWidth: 0.0007 };

/**
 * Sew two lines of straight stitches into a tile, with the dimples that the thread pulls.
 * @param {{height, tone, size}} tile - From `knitTile`; not changed.
 */
export function stitchTile(tile) {
  const { size } = tile;
  const height = tile.height.slice();
  const tone = tile.tone.slice();
  const pitch = TILE / STITCH.perTile;
  for (let row = 0; row < size; row++) {
    const above = (1 - (row + 0.5) / size) * TILE;
    for (let column = 0; column < size; column++) {
      const along = ((column + 0.5) / size) * TILE;
      STITCH.lines.forEach((line, n) => {
        const phase = ((along / pitch + n * 0.5) % 1) - 0.5;
        const at = row * size + column;
        const hole = 0.55 + 0.45 * Math.cos(2 * Math.PI * phase + Math.PI);
        height[at] -= STITCH.groove * hole * Math.exp(-(((above - line) / STITCH.grooveWidth) ** 2));
        const thread = threadHeight(phase * pitch, above - line, pitch);
        if (thread > height[at]) {
          height[at] = thread;
          tone[at] = 1.03 + 0.04 * Math.sin((phase * pitch * 2 * Math.PI) / 0.0004 + (above - line) * 9000);
        }
      });
    }
  }
  return { height, tone, size };
}

// One stitch: a capsule whose ends dive into the needle holes.
function threadHeight(along, off, pitch) {
  const half = pitch * 0.43;
  const past = Math.max(0, Math.abs(along) - half + STITCH.radius);
  const distance = Math.hypot(past, off);
  if (distance >= STITCH.radius) return -Infinity;
  const arch = 0.0003 * (1 - (along / half) ** 4);
  return arch + Math.sqrt(STITCH.radius ** 2 - distance ** 2) - 0.00012;
}
