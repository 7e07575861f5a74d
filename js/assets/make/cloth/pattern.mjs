/**
 * The flat pattern of a T-shirt, size M, in metres: pattern x to the wearer's left, y up, the hem of the
 * body at y = 0; a sleeve has the top of its cap at (0, 0). Outlines run counter-clockwise and
 * consist of named segments, so that seams can say what is sewn to what.
 */
const SIZE_M = {
  length: 0.72,
  halfChest: 0.272,
  halfHem: 0.266,
  underarm: 0.478,
  shoulder: [0.226, 0.678],
  halfNeck: 0.092,
  frontNeckDrop: 0.134,
  backNeckDrop: 0.022,
  halfBicep: 0.205,
  halfSleeveHem: 0.184,
  sleeveUnderarm: 0.118,
  ribHeight: 0.02,
  ribStretch: 0.9,
  hemHeight: 0.02,
};

const CURVE_STEPS = 200;

function bezier(p0, p1, p2, p3) {
  return Array.from({ length: CURVE_STEPS + 1 }, (_, i) => {
    const t = i / CURVE_STEPS;
    const [a, b, c, d] = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
    return [a * p0[0] + b * p1[0] + c * p2[0] + d * p3[0], a * p0[1] + b * p1[1] + c * p2[1] + d * p3[1]];
  });
}

const mirror = (points) => points.map(([x, y]) => [-x, y]).reverse();

/** Length of a polyline of [x, y] points. */
export function lengthOf(points) {
  let sum = 0;
  for (let i = 1; i < points.length; i++) sum += Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
  return sum;
}

function bodyPanel(size, name) {
  const { length, halfChest, halfHem, underarm, shoulder, halfNeck } = size;
  const front = name === 'front';
  const drop = front ? size.frontNeckDrop : size.backNeckDrop;
  const side = [
    [halfHem, 0],
    [halfChest, underarm],
  ];
  // The front armhole is scooped deeper than the back one, to clear the arm's forward swing.
  const scoop = front ? 0.036 : 0.024;
  const [sx, sy] = shoulder;
  const armhole = bezier([halfChest, underarm], [halfChest - 0.045, underarm + 0.006], [sx - scoop, underarm + 0.075], [sx, sy]);
  const neckPoint = [halfNeck, length];
  const neckSide = front ? [halfNeck - 0.006, length - drop * 0.62] : [halfNeck - 0.014, length - drop * 0.9];
  const neckFlat = [front ? halfNeck * 0.55 : halfNeck * 0.5, length - drop];
  const halfCurve = bezier(neckPoint, neckSide, neckFlat, [0, length - drop]);
  const segments = {
    hem: [
      [-halfHem, 0],
      [halfHem, 0],
    ],
    sideLeft: side,
    armholeLeft: armhole,
    shoulderLeft: [shoulder, neckPoint],
    neck: [...halfCurve, ...mirror(halfCurve).slice(1)],
    shoulderRight: mirror([shoulder, neckPoint]),
    armholeRight: mirror(armhole),
    sideRight: mirror(side),
  };
  return { name, segments };
}

function capCurve(size, height) {
  const { halfBicep } = size;
  return bezier([halfBicep, -height], [halfBicep * 0.62, -height * 0.86], [halfBicep * 0.52, 0], [0, 0]);
}

// The cap's height is what makes its edge as long as the armhole it is sewn into.
function capHeightFor(size, armholeLength) {
  let [low, high] = [0.02, 0.3];
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    if (2 * lengthOf(capCurve(size, middle)) < armholeLength) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

function sleevePanel(size, name, capHeight) {
  const { halfBicep, halfSleeveHem, sleeveUnderarm } = size;
  const cap = capCurve(size, capHeight);
  const hemY = -capHeight - sleeveUnderarm;
  const under = [
    [halfSleeveHem, hemY],
    [halfBicep, -capHeight],
  ];
  const segments = {
    hem: [
      [-halfSleeveHem, hemY],
      [halfSleeveHem, hemY],
    ],
    underPlus: under,
    capPlus: cap,
    capMinus: mirror(cap),
    underMinus: mirror(under),
  };
  return { name, segments, capHeight };
}

/**
 * Seams as [panel, segment, panel, segment, reversed]. Seen from outside, x of the left sleeve grows
 * towards the back and x of the right sleeve towards the front.
 */
const SEAMS = [
  ['front', 'sideLeft', 'back', 'sideLeft', false],
  ['front', 'sideRight', 'back', 'sideRight', false],
  ['front', 'shoulderLeft', 'back', 'shoulderLeft', false],
  ['front', 'shoulderRight', 'back', 'shoulderRight', false],
  ['back', 'armholeLeft', 'sleeve_left', 'capPlus', false],
  ['front', 'armholeLeft', 'sleeve_left', 'capMinus', true],
  ['front', 'armholeRight', 'sleeve_right', 'capPlus', true],
  ['back', 'armholeRight', 'sleeve_right', 'capMinus', false],
  ['sleeve_left', 'underPlus', 'sleeve_left', 'underMinus', true],
  ['sleeve_right', 'underPlus', 'sleeve_right', 'underMinus', true],
];

/**
 * @param {typeof SIZE_M} [size] - Measures in metres.
 * @returns {{panels: object[], seams: Array, size: object}} Panels with named outline segments.
 */
export function tshirtPattern(size = SIZE_M) {
  const front = bodyPanel(size, 'front');
  const back = bodyPanel(size, 'back');
  const armhole = lengthOf(front.segments.armholeLeft) + lengthOf(back.segments.armholeLeft);
  const capHeight = capHeightFor(size, armhole);
  const panels = [front, back, sleevePanel(size, 'sleeve_left', capHeight), sleevePanel(size, 'sleeve_right', capHeight)];
  return { panels, seams: SEAMS, size, capHeight };
}
