// three.js takes a node's matrix apart into translation, rotation and scale, which moves what it measures by a few 1e-8.
const isNear = (a, b) => a === b || Math.abs(a - b) <= 1e-7 + 1e-6 * Math.abs(a);

const isTree = (value) => typeof value === 'object' && value !== null;

function* leaves(path, ours, theirs) {
  if (!isTree(ours) || !isTree(theirs)) {
    if (!isNear(ours, theirs)) yield { path, ours: JSON.stringify(ours), theirs: JSON.stringify(theirs) };
    return;
  }
  for (const key of new Set([...Object.keys(ours), ...Object.keys(theirs)])) {
    yield* leaves(Array.isArray(ours) ? `${path}[${key}]` : `${path}${path && '.'}${key}`, ours[key], theirs[key]);
  }
}

/**
 * Where the two sides resolved a shot differently by more than rounding: nowhere, unless they measure the model differently. The file that the
 * picture is meant for does not count.
 * @param {object} ours resolved in the browser
 * @param {object} theirs resolved on the server
 * @returns {{path: string, ours: string, theirs: string}[]}
 */
export function shotDifferences({ output: _, ...ours }, { output: __, ...theirs }) {
  return [...leaves('', ours, theirs)];
}
