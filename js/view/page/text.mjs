/** Names of the shot that are written otherwise. */
const SPELLINGS = { aces: 'ACES', agx: 'AgX', three: 'three.js' };

/** A name of the shot for readers: "three-quarter" as "Three-quarter". */
export const titled = (name) => SPELLINGS[name] ?? name.charAt(0).toUpperCase() + name.slice(1);
