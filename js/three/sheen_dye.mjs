/**
 * What a cloth's colour leaves of a sheen that its preset gives for undyed fibres, as renderer/core/sheen_dye.h says why.
 * @param {number[]} color - Linear base colour.
 */
export const sheenDye = (color) => color.slice(0, 3).map((c) => Math.sqrt(Math.min(Math.max(c, 0.001), 1)));
