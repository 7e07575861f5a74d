import { compareImages, encodePng, explainDifference, heatMap, judge, readImage, shrinkImage, sizeFactor } from '../compare/index.mjs';

/** `compare` of a pool, in a worker: pictures of strangers are decoded there, and figures may take seconds. */

/**
 * @param {{source: string | Buffer, others: {expected: string | Buffer}, args: [{gate?: string, thresholds: object, resize: boolean, heatMap: boolean}],
 *   limits: object, parts: Buffer[], signal: AbortSignal}} job
 * @returns {Promise<object>} comparison, verdict and hints as JSON; the heat map goes to the parts
 */
export async function compareJob({ source, others, args: [{ gate, thresholds, resize, heatMap: isMapped }], limits, parts, signal }) {
  const [expected, actual] = await Promise.all([others.expected, source].map((file) => readImage(file, { limits, signal })));
  const larger = resize ? sizeFactor(expected, actual)?.larger : undefined;
  const images = [larger === 'expected' ? shrinkImage(expected, actual) : expected, larger === 'actual' ? shrinkImage(actual, expected) : actual];
  const comparison = compareImages(...images);
  const verdict = judge(comparison, gate, thresholds);
  const hints = verdict.pass ? [] : explainDifference(...images);
  if (isMapped) parts.push(await encodePng(heatMap(comparison), { signal }));
  const { flipMap, ...figures } = comparison;
  return { comparison: figures, verdict, hints };
}
