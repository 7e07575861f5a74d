/** How far a picture is off by its noise alone. */

/**
 * FLIP of a picture whose pixels have a standard error of 1/255, at most, and how it grows: FLIP maps a difference of colour e to e^0.7 and filters it before, so that the
 * noise of single pixels counts less than its own. The least that none of the measured pictures passes: js/docs/trade.md, "Where a goal ends a picture".
 */
const FLIP_OF_ONE = 0.019;
const POWER = 0.7;

/** @param {number} error mean standard error of the pixels, 1/255 @returns {number} mean FLIP that it makes, at most */
export const flipOfError = (error) => FLIP_OF_ONE * error ** POWER;

/** @param {number} flip mean FLIP @returns {number} standard error, 1/255, that makes no more */
export const errorOfFlip = (flip) => (flip / FLIP_OF_ONE) ** (1 / POWER);
