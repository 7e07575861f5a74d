import * as z from '../dist/zod.mjs';
import { PRESETS, SAMPLE_COUNTS } from './schema.mjs';
import { BASES, SLOTS, WITHOUT_TERMS } from './shading_terms.mjs';

/**
 * What resolveShot returns, for types and tests; the renderer reads these keys and has no defaults of its own.
 * Lengths in metres, camera and environment angles in degrees, spot cones in radians, colours linear Rec.709.
 */
const vec3 = z.tuple([z.number(), z.number(), z.number()]);
const rgb = z.tuple([z.number().min(0), z.number().min(0), z.number().min(0)]);
const object = (shape) => z.strictObject(shape);

const placed = { position: vec3, target: vec3, up: vec3 };
const planes = { near: z.number(), far: z.number() };
const lit = { color: rgb, intensity: z.number() };

const map = {
  mapSize: z.int(), radius: z.number(), intensity: z.number(), bias: z.number(), normalBias: z.number(), near: z.number(), far: z.number(),
};
const extent = { left: z.number(), right: z.number(), bottom: z.number(), top: z.number() };
/** `shadow` is there where castShadow is true. */
const shadowed = (shape) => ({ castShadow: z.boolean(), shadow: object({ ...map, ...shape }).optional() });

export const resolvedShotSchema = object({
  size: object({ width: z.int(), height: z.int() }),
  camera: z.discriminatedUnion('projection', [
    object({ projection: z.literal('perspective'), ...placed, fovY: z.number(), ...planes }),
    object({ projection: z.literal('orthographic'), ...placed, height: z.number(), ...planes }),
  ]),
  lens: object({
    aperture: z.number(), shutter: z.number().nullable(), iso: z.number().nullable(), focusDistance: z.number().nullable(),
  }).nullable(),
  environment: object({
    map: z.union([z.string(), z.custom((value) => value instanceof Uint8Array).meta({ tsType: 'Uint8Array' })]),
    intensity: z.number(),
    rotation: z.number(),
  }),
  lights: z.array(z.discriminatedUnion('type', [
    object({ type: z.literal('ambient'), ...lit }),
    object({ type: z.literal('hemisphere'), ...lit, groundColor: rgb }),
    object({ type: z.literal('directional'), ...lit, position: vec3, target: vec3, ...shadowed(extent) }),
    object({ type: z.literal('point'), ...lit, position: vec3, range: z.number(), ...shadowed({}) }),
    object({
      type: z.literal('spot'), ...lit, position: vec3, target: vec3, range: z.number(), angle: z.number(), penumbra: z.number(),
      ...shadowed({ focus: z.number() }),
    }),
    object({ type: z.literal('rect'), ...lit, position: vec3, target: vec3, width: z.number(), height: z.number() }),
    object({ type: z.literal('disk'), ...lit, position: vec3, target: vec3, radius: z.number() }),
  ])),
  modelLights: z.boolean(),
  background: z.union([z.enum(['transparent', 'environment']), rgb, object({ type: z.literal('environment'), blur: z.number() })]),
  ground: z.union([z.literal('none'), object({ shadow: z.literal(true), opacity: z.number(), position: vec3, size: z.tuple([z.number(), z.number()]) })]),
  shading: z.union([
    z.enum(WITHOUT_TERMS),
    object({ base: z.enum(BASES), ...Object.fromEntries(Object.entries(SLOTS).map(([slot, terms]) => [slot, z.enum(terms)])) }),
  ]),
  toneMapping: z.enum(['neutral', 'none', 'linear', 'reinhard', 'cineon', 'aces', 'agx']),
  exposure: z.number(),
  quality: z.union([
    object({
      preset: z.enum(Object.keys(PRESETS)).optional(),
      samples: z.literal(SAMPLE_COUNTS),
      resolve: z.enum(['encoded', 'linear']),
      noise: z.number(),
      environmentSamples: z.int(),
    }),
    object({
      preset: z.literal('reference'), samples: z.int(), seed: z.int(), transport: z.enum(['global', 'occlusion', 'direct']), bounces: z.int(), threads: z.int(),
    }),
  ]),
  variant: z.string(),
  pose: object({ animation: z.int(), time: z.number() }).nullable(),
  layers: z.array(z.literal('beauty')),
  output: object({
    format: z.enum(['png', 'jpeg', 'webp', 'tiff', 'exr', 'raw']),
    quality: z.int(),
    bitDepth: z.literal([8, 16, 32]),
    ppi: z.number(),
    icc: z.boolean(),
  }),
});
