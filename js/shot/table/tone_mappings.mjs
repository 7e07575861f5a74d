/**
 * The tone mappings, the default first. `three`: the constant of three.js and, with that name too, its GLSL function; `glsl`: telar's
 * function in shaders/brdf/tone_mapping.glsl, `vec3 f(vec3 color, float exposure)`. "none" is no function: colours stay as they are.
 * `since`: N of the release 0.N of three.js that brought it, where that is later than the oldest of js/shot/three_terms.mjs.
 */
export const TONE_MAPPINGS = Object.freeze({
  neutral: { three: 'NeutralToneMapping', glsl: 'toneMapNeutral', since: 162 },
  none: { three: 'NoToneMapping' },
  linear: { three: 'LinearToneMapping', glsl: 'toneMapLinear' },
  reinhard: { three: 'ReinhardToneMapping', glsl: 'toneMapReinhard' },
  cineon: { three: 'CineonToneMapping', glsl: 'toneMapCineon' },
  aces: { three: 'ACESFilmicToneMapping', glsl: 'toneMapAces' },
  agx: { three: 'AgXToneMapping', glsl: 'toneMapAgx', since: 160 },
});
