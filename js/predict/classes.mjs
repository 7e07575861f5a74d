/** Kinds of surface of which few pixels tell little: what is wrong there is wrong by far. */
const SPARSE = ['cut', 'facets'];

/**
 * Classes of scenes, from the narrowest to all: what is predicted of a scene is what was measured of others of its class.
 * @param {import('./features.mjs').Features} features
 * @returns {string[]}
 */
export const classesOf = ({ shading, surface, environment, shadows }) => {
  // The raster's shadows are wrong by far more than the rest of its light: at each level they are a class of their own.
  const lamp = shadows ? ' with a lamp' : '';
  return [
    `${shading}, ${surface}, ${environment}${lamp}`,
    `${shading}, ${surface}${lamp}`,
    `${shading}, ${SPARSE.includes(surface) ? 'holes or glitter' : 'plain'}${lamp}`,
    `${shading}${lamp}`,
    'all',
  ];
};

/** Scenes that a class needs to be gone by. */
export const FEWEST = 5;

/**
 * The narrowest class of a scene that was measured often enough.
 * @template T
 * @param {Record<string, T & {count: number}>} byClass
 * @param {import('./features.mjs').Features} features
 * @returns {(T & {name: string, count: number}) | undefined}
 */
export function narrowest(byClass, features) {
  const name = classesOf(features).find((each) => byClass[each]?.count >= FEWEST);
  return name === undefined ? undefined : { name, ...byClass[name] };
}
