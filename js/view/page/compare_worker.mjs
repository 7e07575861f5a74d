import { compareImages } from '../../compare/compare.mjs';
import { judge } from '../../compare/gates.mjs';
import { heatMap } from '../../compare/heat_map.mjs';
import { scaledDifference } from './pixels.mjs';

self.addEventListener('message', ({ data: { id, expected, actual, mask, gate } }) => {
  const { flipMap, ...comparison } = compareImages(expected, actual, { mask });
  const { width, height } = comparison;
  const flip = new Uint8ClampedArray(heatMap({ flipMap, width, height }).data.buffer);
  const difference = scaledDifference(expected, actual);
  self.postMessage({ id, comparison, verdict: judge(comparison, gate), flip, difference }, [flip.buffer, difference.buffer]);
});
