/** telar/compare: how far two pictures are apart, and whether that is within a gate. */
export { compareImages } from './compare.mjs';
export { ciede2000 } from './ciede2000.mjs';
export { embedShot, readEmbeddedShot } from './embedded_shot.mjs';
export { encodePng, readImage } from './files.mjs';
export { foldersReport } from './folders_report.mjs';
export { GATES, judge } from './gates.mjs';
export { heatMap } from './heat_map.mjs';
export { explainDifference, sizeFactor } from './hints.mjs';
export { htmlReport } from './html_report.mjs';
export { junitReport } from './junit_report.mjs';
export { shrinkImage } from './resize.mjs';
export { TelarError } from '../error/index.mjs';
