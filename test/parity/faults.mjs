// Faults that a renderer may have, each planted for real: in the shaders that telar compiles, or in the shot that it draws.

/**
 * @typedef {object} Fault
 * @property {string} name
 * @property {string} item - Name of the gate's case that catches it.
 * @property {{file: string, find: string, replace: string}[]} [edits] - Of the text in shaders/; each `find` stands there once.
 * @property {(shot: object) => object} [shot] - The shot that telar draws in place of the case's.
 * @property {string | null} first - Quantity that the trace of the worst pixel names; null beside the object.
 */

/** Moves an orthographic camera to its right by a part of a pixel. */
function shiftCamera(shot, pixels) {
  const { position, target, up, height } = shot.camera;
  const metres = (pixels * height) / shot.size.height;
  const forward = target.map((c, i) => c - position[i]);
  const right = [forward[1] * up[2] - forward[2] * up[1], forward[2] * up[0] - forward[0] * up[2], forward[0] * up[1] - forward[1] * up[0]];
  const length = Math.hypot(...right);
  const move = (point) => point.map((c, i) => c + (right[i] / length) * metres);
  return { ...shot, camera: { ...shot.camera, position: move(position), target: move(target) } };
}

const turnEnvironment = (shot, degrees) => ({
  ...shot,
  environment: { ...shot.environment, rotation: shot.environment.rotation + degrees },
});

/** @type {Fault[]} */
export const FAULTS = [
  {
    name: 'swapped channels: roughness from blue, metalness from green',
    item: 'metallic-roughness-map-env',
    edits: [
      { file: 'material/material_inputs.glsl', find: 'roughnessFactor * metallicRoughness.g;', replace: 'roughnessFactor * metallicRoughness.b;' },
      { file: 'material/material_inputs.glsl', find: 'metallicFactor * metallicRoughness.b;', replace: 'metallicFactor * metallicRoughness.g;' },
    ],
    first: 'metallic',
  },
  {
    name: 'r instead of r squared: alpha is the roughness itself',
    item: 'sweep-sun',
    edits: [
      {
        file: 'brdf/roughness.glsl',
        find: 'return pow2(max(perceptualRoughness, PERCEPTUAL_ROUGHNESS_MIN));',
        replace: 'return max(perceptualRoughness, PERCEPTUAL_ROUGHNESS_MIN);',
      },
    ],
    first: 'direct',
  },
  {
    name: 'a lost PI: Lambert without 1/PI',
    item: 'light-directional',
    edits: [{ file: 'brdf/diffuse.glsl', find: 'return RECIPROCAL_PI * diffuse;', replace: 'return diffuse;' }],
    first: 'direct',
  },
  {
    name: 'V without its 1/4',
    item: 'sweep-sun',
    edits: [{ file: 'brdf/visibility.glsl', find: 'return 0.5 / max(gv', replace: 'return 2.0 / max(gv' }],
    first: 'direct',
  },
  {
    name: 'a mip bias of one',
    item: 'sweep-gradient',
    edits: [
      {
        file: 'light/indirect_inputs.glsl',
        find: 'textureLod(environmentMap, viewToEnvironment * direction, lod)',
        replace: 'textureLod(environmentMap, viewToEnvironment * direction, lod + 1.0)',
      },
    ],
    first: 'radiance',
  },
  {
    name: 'a wrong tone curve constant: compression from 0.8 on, not from 0.76',
    item: 'tone-neutral',
    edits: [{ file: 'brdf/tone_mapping.glsl', find: 'startCompression = 0.8 - 0.04;', replace: 'startCompression = 0.8;' }],
    first: 'encoded',
  },
  {
    name: 'a missing sheen scaling: the layers below keep all their light',
    item: 'sheen-env',
    edits: [
      {
        file: 'shading/three.glsl',
        find: 'float underSheen = underSheenTerm(s, sheenE);',
        replace: 'float underSheen = 1.0;',
      },
    ],
    first: 'indirect',
  },
  {
    name: 'linear instead of sRGB: a base colour texture that is not decoded',
    item: 'base-color-map-env',
    edits: [
      {
        file: 'material/base_color.glsl',
        find: 'color *= texture(baseColorMap, vBaseColorUv);',
        replace: 'vec4 texel = texture(baseColorMap, vBaseColorUv); color *= vec4(srgbFromLinear(texel.rgb), texel.a);',
      },
    ],
    first: 'baseColor',
  },
  {
    name: 'linear instead of sRGB: a picture that is not encoded',
    item: 'light-directional',
    edits: [{ file: 'output.glsl', find: 'srgbFromLinear(displayLight(', replace: '(displayLight(' }],
    first: 'encoded',
  },
  {
    name: 'a rect light that shines from below the horizon too',
    item: 'rect-horizon',
    edits: [{ file: 'brdf/area.glsl', find: 'return max((l * l + f.z) / (l + 1.0), 0.0);', replace: 'return l;' }],
    first: 'direct',
  },
  {
    name: 'alpha instead of roughness in the tables of rect lights',
    item: 'rect-sweep',
    edits: [{ file: 'brdf/area.glsl', find: 'vec2(perceptualRoughness, sqrt', replace: 'vec2(perceptualRoughness * perceptualRoughness, sqrt' }],
    first: 'direct',
  },
  {
    name: 'a background blurred by levels in proportion',
    item: 'background-blur-0.3',
    edits: [
      {
        file: 'environment/background.frag',
        find: 'lodFromRoughness(backgroundBlur, backgroundMaxLod)',
        replace: 'backgroundBlur * backgroundMaxLod',
      },
    ],
    first: null,
  },
  {
    name: 'shadow maps that are read half a texel aside',
    item: 'shadow-directional',
    edits: [{ file: 'shadow/filter.glsl', find: 'coord.z += settings.z;', replace: 'coord.xy += 0.5 / settings.y; coord.z += settings.z;' }],
    first: 'direct',
  },
  {
    name: 'a cube of shadows that is compared by distance instead of depth',
    item: 'shadow-point-room',
    edits: [{ file: 'shadow/filter.glsl', find: 'max(max(along.x, along.y), along.z)', replace: 'length(towards)' }],
    first: 'direct',
  },
  {
    name: 'a bump map whose heights change upwards only',
    item: 'bump-map-sun',
    edits: [{ file: 'material/layers.glsl', find: 'rise.x * alongRight + rise.y * cross(n, right)', replace: 'rise.y * cross(n, right)' }],
    first: 'n',
  },
  {
    name: 'a ground that forgets its opacity',
    item: 'ground-tshirt',
    edits: [{ file: 'shadow/ground.frag', find: 'opacity * (1.0 - visible)', replace: '1.0 - visible' }],
    first: null,
  },
  {
    name: 'a coat of r115 that takes nothing from below',
    item: 'r115-clearcoat-sun',
    edits: [{ file: 'shading/principled.glsl', find: 'color *= underCoat(s, coatNoL);', replace: '' }],
    first: 'direct',
  },
  {
    name: 'a retro-reflection of 2012 that forgets its roughness',
    item: 'disney-sweep-sun',
    edits: [{ file: 'brdf/disney.glsl', find: 'float fd90 = 0.5 + 2.0 * pow2(LoH) * perceptualRoughness;', replace: 'float fd90 = 0.5 + 2.0 * pow2(LoH);' }],
    first: 'direct',
  },
  {
    name: 'an open part of the hemisphere that is taken for that of the other side',
    item: 'visibility-env',
    edits: [{ file: 'material/surface_info.glsl', find: 'bool front = frontFacing() == seenSide;', replace: 'bool front = frontFacing() != seenSide;' }],
    first: 'indirect',
  },
  {
    name: 'a sun that baked occlusion does not reach',
    item: 'fabric-sunny-sky-occlusion',
    edits: [
      {
        file: 'surface.frag',
        find: 'suns = sunLight(s);',
        replace: 'Reflected lit = sunLight(s);\n  direct.diffuse += lit.diffuse;\n  direct.specular += lit.specular;',
      },
    ],
    first: 'direct',
  },
  {
    name: 'another D in cloth: alpha for alpha squared',
    item: 'fabric-sweep-sun',
    edits: [{ file: 'brdf/cloth.glsl', find: 'float k = alpha / (NxH2 + pow2(NoH * alpha));', replace: 'float k = alpha / (NxH2 + pow2(NoH) * alpha);' }],
    first: 'direct',
  },
  {
    name: 'a sheen of cloth that takes another share from below than it gives',
    item: 'fabric-sheen-env',
    edits: [{ file: 'shading/fabric.glsl', find: '(1.0 - max3(s.sheenColor) * s.sheenAlbedo)', replace: '(1.0 - max3(s.sheenColor) * sqrt(s.sheenAlbedo))' }],
    first: 'linear',
  },
  {
    name: 'a diffuse lobe of cloth that is not coupled to the gloss above it',
    item: 'fabric-sweep-sun',
    edits: [{ file: 'shading/fabric.glsl', find: 'diffuseLobe(s, l, NoL) * s.passing * passingShare(s, albedo)', replace: 'diffuseLobe(s, l, NoL)' }],
    first: 'direct',
  },
  {
    name: 'cloth whose normal maps lose their variance from far',
    item: 'cloth-satin-far',
    edits: [
      {
        file: 'material/normal.glsl',
        find: 'return vec2(1.0 - inversesqrt(1.0 + lean2), max(squares - mean2, 0.0) * scale2);',
        replace: 'return vec2(0.0);',
      },
    ],
    first: 'perceptualRoughness',
  },
  {
    name: 'cut-out cloth that is cut at its mean alpha from far',
    item: 'cloth-tulle-studio',
    edits: [{ file: 'material/coverage.glsl', find: ': all, share);', replace: ': all, step(0.5, share));' }],
    first: 'n',
  },
  {
    name: 'holes of a net that count in its mean normal',
    item: 'cloth-tulle-studio',
    edits: [{ file: 'material/normal.glsl', find: 'share = max(share, 0.02);', replace: 'share = 1.0;' }],
    first: 'n',
  },
  { name: 'a camera shift of 0.5 px', item: 'camera-ortho', shot: (shot) => shiftCamera(shot, 0.5), first: 'n' },
  { name: 'an environment rotated by 1 degree', item: 'environment-rotated', shot: (shot) => turnEnvironment(shot, 1), first: 'radiance' },
  {
    name: 'cloth lit from behind lies in its own shadow',
    item: 'shadow-cloth-spot',
    edits: [{ file: 'shadow/offset.glsl', find: 'if (dot(offset, toLight) < 0.0) offset = -offset;', replace: '' }],
    first: 'direct',
  },
  {
    name: 'sheer cloth casts a full shadow',
    item: 'ground-sheer',
    edits: [{ file: 'shadow/layer_threshold.glsl', find: 'return float(threshold >> 8)', replace: 'return 0.0 * float(threshold >> 8)' }],
    first: null,
  },
  {
    name: 'the colour of holes in the mean of a sheer cloth',
    item: 'cloth-sheer-far',
    edits: [
      {
        file: 'texture/coverage.glsl',
        find: 'return cutoff > 0.0 ? step(cutoff, alpha) : alpha;',
        replace: 'return cutoff > 0.0 ? step(cutoff, alpha) : 1.0;',
      },
    ],
    first: 'n',
  },
];
