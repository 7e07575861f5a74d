/**
 * A seeded generator (Weyl sequence through a 32-bit mixer), the same numbers on every machine.
 * @param {number} seed - Integer.
 * @returns {() => number} Uniform in [0, 1).
 */
export function seeded(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x9e3779b9) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 16), 0x21f0aaad);
    mixed = Math.imul(mixed ^ (mixed >>> 15), 0x735a2d97);
    return ((mixed ^ (mixed >>> 15)) >>> 0) / 4294967296;
  };
}
