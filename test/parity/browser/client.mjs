// What a client of three.js 0.187 does besides applyShot to show a shot: nothing. test/families puts in its place what clients
// of other releases do.

/** @type {import('../../families/browser/client.mjs').Client} */
export const client = {
  prepareRenderer: () => {},
  prepareEnvironment: (texture) => texture,
  prepareScene: () => {},
  finishScene: () => {},
};
