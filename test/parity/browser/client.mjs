// What a client sets beside applyShot: nothing. test/families puts in its place what clients of other releases may set.

/** @type {import('../../families/browser/client.mjs').Client} */
export const client = {
  finishScene: () => {},
};
