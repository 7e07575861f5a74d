import { checkObject, checkSignal, isObject, wrongOption } from './options.mjs';

const DIRECTIONS_MAX = 65536;
/** How far a direction's length may be from 1. */
const UNIT_TOLERANCE = 1e-6;

const isDirection = (value) =>
  Array.isArray(value) && value.length === 3 && value.every(Number.isFinite) && Math.abs(Math.hypot(value[0], value[1], value[2]) - 1) <= UNIT_TOLERANCE;

function checkDirections(directions) {
  if (!Array.isArray(directions) || directions.length > DIRECTIONS_MAX) {
    throw wrongOption('options.directions', `a list of at most ${DIRECTIONS_MAX} unit vectors`, Array.isArray(directions) ? directions.length : directions);
  }
  const wrong = directions.findIndex((direction) => !isDirection(direction));
  if (wrong >= 0) throw wrongOption(`options.directions[${wrong}]`, 'a unit vector [x, y, z]', directions[wrong]);
}

function checkMaterial({ model, material }, isModel) {
  if (model === undefined) {
    if (!isObject(material)) throw wrongOption('options.material', 'a material as glTF writes it', material);
    return;
  }
  if (!isModel(model)) throw wrongOption('options.model', 'a loaded model', model);
  const count = model.facts.materials.length;
  if (!(Number.isSafeInteger(material) && material >= 0 && material < count)) {
    throw wrongOption('options.material', `the index of one of the model's ${count} materials`, material);
  }
}

/**
 * Options of evaluateShading with every default written out.
 * @param {object} options see there
 * @param {(value: unknown) => boolean} isModel
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function lobesOptions(options, isModel) {
  checkObject('options', options, ['model', 'material', 'shading', 'viewAngle', 'directions', 'albedo', 'signal']);
  const { model, material, shading = 'three', viewAngle = 0, directions = [], albedo = false, signal } = options;
  checkMaterial({ model, material }, isModel);
  if (!(viewAngle >= 0 && viewAngle < Math.PI / 2)) throw wrongOption('options.viewAngle', 'radians from 0 up to but not including pi / 2', viewAngle);
  checkDirections(directions);
  if (typeof albedo !== 'boolean') throw wrongOption('options.albedo', 'true or false', albedo);
  return { model, material, shading, viewAngle, directions, albedo, signal: checkSignal(signal) };
}
