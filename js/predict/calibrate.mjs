import { fileURLToPath } from 'node:url';

/** Two small pictures of the bundled drape: how fast a machine draws, for the raster and for the tracer. */

const DRAPE = fileURLToPath(new URL('../assets/fabrics.glb', import.meta.url));
const SHOT = { camera: { azimuth: 25, elevation: 22 }, shading: 'fabric', variant: 'wool', environment: 'studio', output: { format: 'raw' } };
const SHOTS = {
  raster: { ...SHOT, size: { width: 384, height: 384 }, quality: 'standard' },
  tracer: { ...SHOT, size: { width: 48, height: 48 }, quality: { preset: 'reference', transport: 'direct', samples: 64 } },
};

/** Programs are compiled and the environment is prefiltered with the first; the least of the others counts. */
const RUNS = 4;

/**
 * @param {(source: string, shot: object) => Promise<unknown>} draw
 * @param {{tracer: boolean}} has whether the tracer is there
 * @returns {Promise<import('./choose.mjs').Machine>} CPU milliseconds; tracer 0 where it is not there
 */
export async function calibrate(draw, { tracer }) {
  const leastOf = async (shot) => {
    let least = Infinity;
    for (let run = 0; run < RUNS; run++) {
      const before = process.cpuUsage();
      await draw(DRAPE, shot);
      const { user, system } = process.cpuUsage(before);
      if (run > 0) least = Math.min(least, (user + system) / 1000);
    }
    return least;
  };
  return { raster: await leastOf(SHOTS.raster), tracer: tracer ? await leastOf(SHOTS.tracer) : 0 };
}
