import { familyName, familyOf, isRelease, releaseOf, REVISION, revisionRemark, resolveThree } from '../shot/three_terms.mjs';

/** Of the client's module: N of 0.N. A development version such as "188dev" counts as its release. */
export const revisionOf = (THREE) => Number.parseInt(THREE.REVISION, 10);

/** What was warned of on this page: one line each. */
const warned = new Set();

/** A line on the console, once a page. */
export function warnOnce(text) {
  if (warned.has(text)) return;
  warned.add(text);
  console.warn(`telar: ${text}`);
}

/**
 * Holds the release that a shot names against the client's own. THREE.REVISION tells no patch.
 * @param {object} shot - Resolved shot; with `revision` "client" its shading gets the client's release, all terms written out.
 * @param {typeof import('three')} THREE
 * @param {'shot' | 'client'} revision
 */
export function matchRelease(shot, THREE, revision) {
  if (!['shot', 'client'].includes(revision)) throw new Error(`applyShot: expected revision "shot" or "client", got ${revision}`);
  const own = revisionOf(THREE);
  if (!isRelease(shot.shading)) {
    if (familyOf(own).from !== familyOf(REVISION).from) warnOnce(`the shading is made for three.js 0.${REVISION}, and this page has 0.${own}`);
    return;
  }
  if (revision === 'client') {
    shot.shading = resolveThree({ base: 'three', revision: own });
    const remark = revisionRemark(own);
    if (remark) warnOnce(`${remark}, by the server`);
    return;
  }
  const [asked, drawn] = [releaseOf(shot.shading), own].map(familyOf);
  if (asked.from !== drawn.from)
    warnOnce(
      `this page draws with three.js 0.${own} what the shot has the server draw as ${familyName(asked)}, which looks different: ` +
        `ask for shading {base: "three", revision: ${own}}, or give applyShot revision: "client"`,
    );
}
