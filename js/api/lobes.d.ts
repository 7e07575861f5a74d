import type { Vec3 } from '../shot/index.js';
import type { Shot } from '../shot/shot.js';
import type { CallOptions } from './loading.js';
import type { Model } from './model.js';

/** Light by lobe, linear [r, g, b]; `total` is the sum of the other four. */
export type Lobes = Record<'diffuse' | 'specular' | 'sheen' | 'coat' | 'total', Vec3>;

export interface EvaluateShadingOptions extends CallOptions {
  /** A material as glTF writes it, without textures; or the index of one in `model`. */
  material: object | number;
  /**
   * The loaded model that `material` is an index into.
   * @default undefined
   */
  model?: Model;
  /**
   * As the shot has it.
   * @default 'three'
   */
  shading?: Shot['shading'];
  /**
   * Radians from the normal towards the tangent, 0 up to but not including pi / 2.
   * @default 0
   */
  viewAngle?: number;
  /**
   * Unit vectors to the light, at most 65536; z = normal, x = tangent.
   * @default []
   */
  directions?: ReadonlyArray<Readonly<Vec3>>;
  /**
   * Integrates over all directions too.
   * @default false
   */
  albedo?: boolean;
}

/**
 * Evaluates the shading of a material, lobe by lobe, in double and without GL. Textures are left out, as if they were white and
 * normal maps flat.
 * @param options - material, model, shading, viewAngle, directions, albedo, signal.
 * @returns `radiance`: of each direction, under a light that gives the irradiance 1 on a surface that faces it (the BSDF times the
 *   cosine). `albedo`: the part of uniform light that is reflected. `albedoError`: a bound of its error that 999 of 1000 keep.
 * @throws {TelarError} E_OPTION, and what Renderer.load() throws
 * @example
 * const material = { pbrMetallicRoughness: { baseColorFactor: [0.5, 0.1, 0.1, 1], metallicFactor: 0, roughnessFactor: 0.6 } };
 * const { radiance, albedo } = await evaluateShading({ material, shading: 'fabric', directions: [[0, 0, 1]], albedo: true });
 * console.log(radiance[0]?.diffuse, albedo?.total);
 */
export function evaluateShading(options: EvaluateShadingOptions): Promise<{ radiance: Lobes[]; albedo: Lobes | null; albedoError: Lobes | null }>;
