/**
 * What a cloth's colour leaves of a sheen that its preset gives for undyed fibres, as renderer/core/dye.h says why.
 * @param {number[]} color - Linear base colour.
 */
export const sheenDye = (color) => transmissionDye(color).map(Math.sqrt);

/** What it leaves of light that passes through an undyed cloth. @param {number[]} color - Linear base colour. */
export const transmissionDye = (color) => color.slice(0, 3).map((c) => Math.min(Math.max(c, 0.001), 1));
