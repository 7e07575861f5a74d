import { compareImages } from '../../js/compare/index.mjs';

/** Light that arrives directly and the environment, nothing hidden: what the raster computes, path traced. */
const reference = (samples) => ({ preset: 'reference', transport: 'direct', samples });

/**
 * How far a quality of the raster is from the path tracer on the model's own pixels.
 * @param {object} renderer
 * @param {Uint8Array} model - GLB.
 * @param {object} shot - Without quality and output.
 * @param {object[]} qualities
 * @param {number} samples - Of the reference, a pixel.
 * @returns {Promise<{flip: number, deltaE: number, cpuMs: number}[]>} FLIP mean, CIEDE2000 95th percentile, one for each quality
 */
export async function errorsOf(renderer, model, shot, qualities, samples) {
  const draw = async (quality) => {
    const before = process.cpuUsage();
    const { data } = await renderer.render(model, { ...shot, quality, output: { format: 'raw' } });
    const { user, system } = process.cpuUsage(before);
    return { data, cpuMs: (user + system) / 1000 };
  };
  const picture = ({ data }) => ({ ...shot.size, data });
  const truth = await draw(reference(samples));
  const errors = [];
  for (const quality of qualities) {
    await draw(quality); // programs are compiled, the environment is prepared
    const drawn = await draw(quality);
    const { flip, deltaE } = compareImages(picture(truth), picture(drawn)).object;
    errors.push({ flip: flip.mean, deltaE: deltaE.p95, cpuMs: drawn.cpuMs });
  }
  return errors;
}
