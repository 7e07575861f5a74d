import { TelarError } from '../error/index.mjs';
import { pathText, pointerText, wrongValue } from './complain.mjs';
import { cornersOfBox, cross, dot, length, nearPlane, subtract } from './frame.mjs';
import { LIGHTS } from './table/lights.mjs';
import { inOrder, otherwiseOf } from './table/resolved.mjs';
import { arcTangent, tanDegrees } from './trig.mjs';

/**
 * Fits the shadow map of a light to the model: a square map that holds every caster, with biases of the size of a texel, so
 * that they hold at any scale. Metres, doubles, no engine-dependent functions.
 *
 * A map is filtered over `radius` texels about a point, and each tap is bilinear. A surface shadows itself where it rises
 * over that width by more than the bias. A sample moved along the normal by the same width clears it at every slope; the
 * depth bias is for geometry without normals, and for the quantum of the depth buffer.
 *
 * @typedef {import('./frame.mjs').Vec3} Vec3
 * @typedef {import('./frame.mjs').Bounds} Bounds
 */

/** Reach of one bilinear tap, in texels, with room for the corner of a texel. */
const TAP = 1.5;

/** Reach of a tap that reads one texel, in texels: to the texel's far side. */
const NEAREST_TAP = 0.5;

/** Reach of a bilinear tap along the axes of the map, in texels. */
const TEXEL = 1;

/** Largest angle between the two sides of a spot's map, degrees: a projection of 180 has no inverse. */
const WIDEST = 170;

/** Least part of a spot's cone that its map holds, for a model that is a point. */
const NARROWEST = 1e-3;

/** Steps of 32-bit floats that positions lose on the way through the shaders, relative to the largest coordinate. */
const ROUNDING = 2 ** -21;

const largest = (list, f) => list.reduce((most, item) => Math.max(most, f(item)), -Infinity);
const smallest = (list, f) => -largest(list, (item) => -f(item));

/**
 * Axes of a camera at `position` that looks at `target`, as Matrix4.lookAt of three.js 0.187 chooses them for up = +Y.
 * @returns {[Vec3, Vec3, Vec3]} right, up, back
 */
export function lightAxes({ position, target }) {
  const unit = (v) => v.map((x) => x / length(v));
  let back = unit(subtract(position, target));
  let right = cross([0, 1, 0], back);
  if (dot(right, right) === 0) {
    back = unit([back[0], back[1], back[2] + 1e-4]);
    right = cross([0, 1, 0], back);
  }
  right = unit(right);
  return [right, cross(back, right), back];
}

/** How many diagonals of a model are far: as in renderer/pass/plan/world_origin.h. */
const FAR_OUT = 1000;

/** Where renderers count from, for a point that 32-bit floats cannot hold beside the model: the model's centre. */
function nearTo({ min, max }, point) {
  const centre = min.map((low, i) => (low + max[i]) * 0.5);
  return largest(subtract(point, centre), Math.abs) > FAR_OUT * length(subtract(max, min)) ? centre : point;
}

/**
 * What 32-bit floats may lose of these positions, metres.
 * @param {Vec3[]} points
 * @param {Vec3} origin that they are counted from
 */
const roundingOf = (points, origin) => ROUNDING * largest(points, (point) => largest(subtract(point, origin), Math.abs));

/** Where a light stands: one that is parallel stands anywhere. */
const standOf = ({ type, position }, bounds) => (type === 'directional' ? nearTo(bounds, position) : position);

/**
 * Width in texels that the filter looks at to each side; at most a quarter of the map, so that most of it stays. The grid over packed
 * maps is a square: it reaches farthest at its corners.
 */
const reachOf = ({ radius, mapSize }, isPacked) => Math.min(isPacked ? (radius + NEAREST_TAP) * Math.SQRT2 : radius + TAP, mapSize / 4);

/** Depth range of points at these distances along the light's axis, with room for rounding. */
function depthRange(casters, receivers, rounding) {
  const near = smallest(casters, (x) => x);
  const far = Math.max(
    largest(casters, (x) => x),
    largest(receivers, (x) => x),
  );
  const pad = 0.01 * (far - near) + rounding;
  return { near: near - pad, far: far + pad };
}

function fitDirectional(light, shadow, casters, receivers, { bounds, origin, isPacked }) {
  const [right, up, back] = lightAxes(light);
  const along = (points, axis) => points.map((point) => dot(subtract(point, light.position), axis));
  const rounding = roundingOf([...casters, ...receivers, standOf(light, bounds)], origin);
  const [x, y] = [along(casters, right), along(casters, up)];
  const middle = (list) => (largest(list, (v) => v) + smallest(list, (v) => v)) / 2;
  const extent = (list) => largest(list, (v) => v) - smallest(list, (v) => v);
  // The filter may not reach over the border, whose texels would be repeated.
  const width = Math.max(extent(x), extent(y), rounding) / (1 - (2 * reachOf(shadow, isPacked)) / shadow.mapSize);
  const { near, far } = depthRange(
    along(casters, back).map((d) => -d),
    along(receivers, back).map((d) => -d),
    rounding,
  );
  return {
    near,
    far,
    left: middle(x) - width / 2,
    right: middle(x) + width / 2,
    bottom: middle(y) - width / 2,
    top: middle(y) + width / 2,
  };
}

/** Depth range of a perspective map, by distances along its axis: of casters from nearest to `casterDepth`, and of all points to `farthest`. */
function perspectiveRange({ range }, nearest, casterDepth, farthest) {
  const far = range || 1.01 * farthest;
  // A wide ground pushes far alone: what casts the shadow is as near as it was.
  return { near: Math.min(nearPlane(0.9 * nearest, Math.min(far, 1.01 * casterDepth)), far / 2), far };
}

function fitSpot(light, shadow, casters, receivers, { origin, isPacked }) {
  const [right, up, back] = lightAxes(light);
  const depth = (point) => dot(subtract(light.position, point), back);
  const slope = (point) => {
    const v = subtract(point, light.position);
    return Math.max(Math.abs(dot(v, right)), Math.abs(dot(v, up))) / depth(point);
  };
  const least = roundingOf([...casters, light.position], origin);
  const nearest = smallest(casters, depth);
  // As narrow as the casters allow; the whole cone where the light stands in their midst.
  const cone = widestFocus(light);
  const border = nearest > 0 ? largest(casters, slope) / (1 - (2 * reachOf(shadow, isPacked)) / shadow.mapSize) : Infinity;
  const casterDepth = Math.max(largest(casters, depth), least);
  return {
    ...perspectiveRange(light, nearest, casterDepth, Math.max(largest(receivers, depth), casterDepth)),
    focus: border < Infinity ? Math.min(cone, Math.max(arcTangent(border) / light.angle, NARROWEST)) : cone,
    casterDepth,
  };
}

/** The part of a spot's cone that a map can hold. */
const widestFocus = ({ angle }) => Math.min(1, ((WIDEST / 2) * (Math.PI / 180)) / angle);

function fitPoint(light, shadow, casters, receivers, { origin, isPacked }) {
  // A face of the cube measures depth along its own axis: the largest component of the distance. A packed one measures the distance.
  const depth = (point) => (isPacked ? length(subtract(point, light.position)) : largest(subtract(point, light.position), Math.abs));
  const least = roundingOf([...casters, light.position], origin);
  const [min, max] = [casters[0], casters[7]];
  const toBox = largest(
    light.position.map((p, i) => Math.max(min[i] - p, p - max[i], 0)),
    (x) => x,
  );
  const casterDepth = Math.max(largest(casters, depth), least);
  return { ...perspectiveRange(light, toBox, casterDepth, Math.max(largest(receivers, depth), casterDepth)), casterDepth };
}

/** Slope of the map's border against its axis. */
function slopeOf({ type, angle }, { focus }) {
  return type === 'point' ? 1 : tanDegrees(Math.min(angle * focus * (180 / Math.PI), WIDEST / 2));
}

/** Biases of one filter's width: {bias} of the depth range 0..1, {normalBias} metres. */
function biasesOf(light, shadow, { casterDepth, rounding, isPacked }) {
  const { near, far, mapSize } = shadow;
  const biases = (texel, depthPerMetre) => ({
    bias: Math.max(-1, -(texel + rounding) * depthPerMetre),
    normalBias: reachOf(shadow, isPacked) * texel + rounding,
  });
  if (light.type === 'directional') return biases((shadow.right - shadow.left) / mapSize, 1 / (far - near));
  // Texels are widest and depth is coarsest at the farthest caster: depth runs as -far near / ((far - near) distance), or with the
  // distance.
  const depth = Math.min(far, casterDepth);
  const isDistance = isPacked && light.type === 'point';
  return biases((2 * depth * slopeOf(light, shadow)) / mapSize, isDistance ? 1 / (far - near) : (far * near) / ((far - near) * depth * depth));
}

/**
 * How far the filter of a light's shadow reaches, metres along the two axes of its map.
 * @param {object} light resolved
 * @param {number} depth along the map's axis, metres
 * @returns {[number, number]}
 */
export function spreadOf(light, depth) {
  const { mapSize, left, right, bottom, top } = light.shadow;
  const extents = light.type === 'directional' ? [right - left, top - bottom] : Array(2).fill(2 * Math.max(depth, 0) * slopeOf(light, light.shadow));
  return extents.map((extent) => ((light.shadow.radius + TEXEL) * extent) / mapSize);
}

function needBounds({ bounds }, path) {
  if (bounds) return bounds;
  const at = [...path, 'castShadow'];
  throw new TelarError('E_NO_GEOMETRY', `${pathText(at)}: the model has nothing that could cast a shadow; leave castShadow out`, {
    pointer: pointerText(at),
  });
}

/** The row of a light's `shadow`. */
const rowOf = ({ type }) => LIGHTS[type].shape.shadow;

const FIT = { directional: fitDirectional, spot: fitSpot, point: fitPoint };

/** Settings that need no model, of a light that casts a shadow. */
export const filterOf = (light) => ({ ...otherwiseOf(rowOf(light)), ...light.shadow });

/**
 * Every setting of a light's shadow, as three.js's LightShadow has them.
 * @param {object} light of the shot, resolved but for its shadow
 * @param {(string | number)[]} path of the light in the shot
 * @param {{bounds?: Bounds}} facts
 * @param {Vec3[]} receivers corners of what receives shadows beside the model
 * @param {boolean} isPacked whether maps are those of three.js before 0.182
 * @returns {object} near, far, normalBias and the extents in metres, radius in texels, bias as part of the depth 0..1
 */
export function resolveShadow(light, path, facts, receivers, isPacked) {
  const keys = Object.keys(rowOf(light).shape);
  const shadow = filterOf(light);
  if (keys.some((key) => shadow[key] === undefined)) {
    const bounds = needBounds(facts, path);
    const [casters, origin] = [cornersOfBox(bounds), nearTo(bounds, [0, 0, 0])];
    const { casterDepth, ...fitted } = FIT[light.type](light, shadow, casters, receivers, { bounds, origin, isPacked });
    Object.assign(shadow, { ...fitted, ...shadow });
    check(light, shadow, path);
    const rounding = roundingOf([...casters, standOf(light, bounds)], origin);
    Object.assign(shadow, { ...biasesOf(light, shadow, { casterDepth, rounding, isPacked }), ...shadow });
  }
  check(light, shadow, path);
  return inOrder(rowOf(light), shadow);
}

function check(light, shadow, path) {
  const wrong = (key, expected) => wrongValue([...path, 'shadow', key], expected, shadow[key]);
  const { near, far, left, right, bottom, top, focus } = shadow;
  if (light.range > 0 && far !== light.range) throw wrong('far', `${light.range}, as three.js ends the map at the light's range`);
  if (light.type !== 'directional' && !(near > 0)) throw wrong('near', 'a distance above 0');
  if (!(far > near)) throw wrong('far', `a distance beyond near (${near})`);
  if (light.type === 'directional' && !(right > left)) throw wrong('right', `a number above left (${left})`);
  if (light.type === 'directional' && !(top > bottom)) throw wrong('top', `a number above bottom (${bottom})`);
  if (light.type === 'spot' && focus > widestFocus(light)) throw wrong('focus', `at most ${widestFocus(light)} with this angle`);
}
