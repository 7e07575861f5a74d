/** Largest number that a half float holds, and its bits. */
export const HALF_MAX = 65504;
export const HALF_MAX_BITS = 0x7bff;
