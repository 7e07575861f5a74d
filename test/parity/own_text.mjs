import { withinCoverage } from './metrics.mjs';

/**
 * Stands in telar's place: three.js again, but shaded by telar's text of stock three.js. What then differs comes of the way in
 * which js/three puts a shading into three.js, and of no shading.
 * @param {import('./browser/chromium.mjs').Browser} browser
 * @returns {import('./server.mjs').Server}
 */
export const openOwnText = (browser) => ({
  draw: async (input) => {
    const { image, facts } = await browser.draw({ ...input, ownText: true });
    if (facts.left > 0) throw new Error(`${facts.left} meshes are not shaded by telar's text`);
    return withinCoverage(image);
  },
  debug: (input, terms) => browser.terms({ ...input, ownText: true, terms }),
  close: async () => {},
});
