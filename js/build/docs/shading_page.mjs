import { BASES, SLOTS } from '../../shot/shading_terms.mjs';
import { heading, row } from './tables.mjs';

/** js/docs/shading.md: the slots and terms of the principled shadings, and how they read glTF. */

const BURLEY = 'Burley 2012, "Physically-Based Shading at Disney"';
const R115 = 'three.js r115';

/** slot: [what it decides, {term: [what it is, source]}] */
const TEXTS = {
  parameters: [
    "How glTF's parameters become those of the model; see the table below",
    {
      'three-r115': ['Normal reflectance 0.16 reflectivity^2, white; roughness held in [0.04, 1]', `${R115}, listing 6.1`],
      'disney-2012': ['specular with specularTint, up to a reflectance of 0.08; roughness as authored, alpha = roughness^2 >= 0.001', BURLEY],
    },
  ],
  diffuse: [
    'The diffuse lobe',
    {
      lambert: ['The same in every direction, of all the light: no share is taken for the gloss', `${R115}, listing 6.3`],
      'disney-2012': ['Retro-reflective with F_D90 = 1/2 + 2 cos^2 roughness; by flatness, the flatter lobe after Hanrahan and Krueger', BURLEY],
      frostbite: [
        'The same renormalised, so that it reflects no more than arrives',
        'Lagarde & de Rousiers 2014, "Moving Frostbite to Physically Based Rendering 3.0"',
      ],
      eon: ["Energy-preserving Oren-Nayar of the surface's roughness; reciprocal", 'Portsmouth, Kutz & Hill 2025, "EON", JCGT 14(1)'],
      'disney-2015-thin': [
        'A thin sheet: that of 2012 by flatness, and what goes through it (KHR_materials_diffuse_transmission)',
        'Burley 2015, "Extending the Disney BRDF to a BSDF with Integrated Subsurface Scattering"',
      ],
    },
  ],
  distribution: [
    'D of the base gloss, and whether it is stretched',
    {
      ggx: ['Isotropic Trowbridge-Reitz: a stretched highlight is not stretched', 'Walter et al. 2007; listing 6.5'],
      'gtr2-anisotropic': ['The same with two widths, alpha / aspect and alpha aspect', BURLEY],
    },
  ],
  visibility: [
    'V = G / (4 NoL NoV) of the base gloss',
    {
      'smith-correlated': ['Masking and shadowing correlated by height', 'Heitz 2014; Lagarde & de Rousiers 2014; listing 6.7'],
      'smith-separable': ['One factor for each side: darker where the surface is rough and seen at grazing', `Smith 1967; ${BURLEY}`],
    },
  ],
  fresnel: [
    'F of the base gloss',
    {
      'schlick-exp2': ['Schlick by a power of 2: at most 0.0038 off', 'Karis 2013, "Real Shading in Unreal Engine 4"; listing 6.6'],
      schlick: ['Schlick by the fifth power', 'Schlick 1994'],
    },
  ],
  sheen: [
    'The fuzz (KHR_materials_sheen)',
    {
      'charlie-neubelt': [
        "Charlie distribution of alpha = the base's roughness, not squared; visibility of Neubelt and Pettineo. sheenRoughness is not read",
        `Estevez & Kulla 2017; Neubelt & Pettineo 2013; ${R115}, listing 6.13`,
      ],
      'disney-2012': ['(1 - LoH)^5, tinted, on dielectrics: a rim where the light comes from behind. sheenRoughness is not read', BURLEY],
      'ashikhmin-velvet': [
        'Inverted Gaussian on a floor: some light returns to the viewer from the front',
        'Ashikhmin & Premoze 2007; Neubelt & Pettineo 2013',
      ],
      'charlie-estevez-kulla': [
        "Charlie distribution with its own masking, terminator softened on the light's side",
        'Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF"',
      ],
      zeltner: [
        'Scattering in a volume of fibres as a transformed cosine; it reflects its albedo by construction',
        'Zeltner, Burley & Chiang 2022, "Practical Multiple-Scattering Sheen Using Linearly Transformed Cosines"',
      ],
      'uncharted-4': [
        "Fuzz by the viewer's angle alone: a rim, an outer and an inner part, as bright as the light on the cloth. It conserves nothing and is not reciprocal " +
          '([analysis.md](analysis.md) has the figures); weights and exponents, which the talk leaves to artists, are ours by sheenRoughness; detail is the texture of the sheen colour, where a file has one',
        'Jiang 2016, "The Process of Creating Volumetric-based Materials in Uncharted 4"',
      ],
    },
  ],
  clearcoat: [
    'The coat (KHR_materials_clearcoat)',
    {
      'three-r115': ['GGX of index 1.5, correlated Smith, Schlick by a power of 2', `${R115}, listings 6.8 to 6.11`],
      'disney-2012': ['A quarter of GTR1, whose tail is long; Smith of alpha 0.25: 5 to 9 times weaker', BURLEY],
    },
  ],
  layering: [
    'Who covers whom',
    {
      'three-r115': [
        "The coat leaves 1 - weight DHR to what lies beneath: by the light's angle, and for the environment by the viewer's and of single scattering alone. " +
          'In the light of lamps the sheen stands in place of the base gloss; in that of the environment, ambient and hemisphere lights it is absent; it takes nothing from the diffuse lobe',
        `${R115}, listing 6.12`,
      ],
      'disney-2012': ['A plain sum of all lobes, in all light', BURLEY],
    },
  ],
  scattering: [
    'What the gloss sends back of the environment',
    {
      'fdez-aguera': [
        'Single scattering whose Fresnel rises no higher than 1 - roughness, multiple scattering by the mean radiance; the diffuse lobe gets what is left',
        `Fdez-Aguera 2019, JCGT 8(1), as in ${R115}`,
      ],
      single: ['Single scattering: F0 A + B; the diffuse lobe gets all the light', BURLEY],
    },
  ],
  environment: [
    '(A, B) of the split sum, by which the prefiltered environment is read',
    {
      karis: ['A fit for phones', `Karis 2014, "Physically Based Shading on Mobile"; ${R115}`],
      'three-table': ['The table of three.js 0.187, 16 x 16', 'three.js 0.187'],
      lazarov: ['An earlier fit, of another game', 'Lazarov 2013, "Getting More Physical in Call of Duty: Black Ops II"'],
    },
  ],
};

/** [glTF, three-r115, disney-2012] */
const MAPPING = [
  ['baseColor, metallic', 'the same: diffuse colour = base (1 - metallic), reflectance mixed to the base colour by metallic', 'the same'],
  ['roughness', 'clamp(roughness, 0.04, 1); nothing added for curvature', 'roughness; nothing added for curvature'],
  [
    'ior, specular, specularColor',
    'reflectivity^2 = brightness of the normal reflectance / 0.16, in [0, 1]; the colour is lost; f90 = 1',
    'specular = brightness of the normal reflectance / 0.08, in [0, 1] (an index up to 1.79); specularTint below; f90 = 1',
  ],
  ['sheenColor', "its colour, with the base's roughness", 'sheen = brightness of the colour; sheenTint below'],
  ['sheenRoughness', 'not read', 'not read; the further sheen terms read it'],
  [
    'anisotropyStrength, rotation',
    'not read',
    "anisotropic = min((1 - alpha / alphaT) / 0.9, 1), alphaT = mix(alpha, 1, strength^2): the highlight is as many times longer than wide as glTF's, up to 10 times, of the area that roughness has; the same directions",
  ],
  ['clearcoat', 'clearcoat', 'clearcoat'],
  [
    'clearcoatRoughness',
    'clamp(clearcoatRoughness, 0.04, 1)',
    "gloss = (0.1 - clearcoatRoughness^2) / 0.099, in [0, 1]: the same width, as far as Disney's 0.001 to 0.1 goes",
  ],
  ['clearcoatNormal', "the coat's normal", "the coat's normal (Disney's coat has none of its own)"],
  ['flatness (TELAR_materials_fabric)', 'not read', 'subsurface; flatness of disney-2015-thin'],
  ['diffuseTransmission', 'not read', "not read; disney-2015-thin: diffTrans / 2, times the extension's colour"],
  ['diffuseRoughness, iridescence', 'not read', 'not read'],
  ['transmission, volume', 'drawn as in the shading three', 'the same'],
];

function slotSection(slot, terms) {
  const [what, texts] = TEXTS[slot] ?? [];
  const untold = terms.filter((term) => !texts?.[term]);
  if (untold.length > 0) throw new Error(`js/build/docs/shading_page.mjs says nothing of ${slot}: ${untold.join(', ')}`);
  const rows = terms.map((term, i) => row([`\`${term}\``, BASES[i] ? `\`${BASES[i]}\`` : '', ...texts[term]]));
  return [`### \`${slot}\``, '', `${what}.`, '', ...heading(['term', 'of', 'what it is', 'source']), ...rows, ''];
}

/** @returns {string} */
export function shadingPage() {
  const example = JSON.stringify({ shading: { base: 'three-r115', diffuse: 'disney-2012', sheen: 'zeltner' } });
  return [
    '# Shadings made of terms',
    '',
    'The shadings `three-r115` and `disney-2012` are two columns of one table. Each row is a slot, a question that a shading answers by',
    'one of a few terms; `shot.shading` may take any term in any slot:',
    '',
    '```json',
    example,
    '```',
    '',
    '`info.shot.shading` has every slot written out. Programs have only the terms in them that are chosen.',
    'The text is `shaders/shading/principled_terms.glsl` and `principled.glsl`; the renderer, the browser and the path tracer run it.',
    'Listings are those of the thesis that telar grew from.',
    'This page is generated from js/shot/shading_terms.mjs and js/build/docs/shading_page.mjs by `node js/build/docs/generate.mjs`.',
    '',
    '## Slots and terms',
    '',
    ...Object.entries(SLOTS).flatMap(([slot, terms]) => slotSection(slot, terms)),
    '## glTF as the models have it',
    '',
    'Decided by the slot `parameters`, for anisotropy by `distribution`, for the widths of coat and sheen by their slots.',
    '',
    ...heading(['glTF', ...BASES]),
    ...MAPPING.map(row),
    '',
    "Brightness is 0.3 R + 0.6 G + 0.1 B, as in Disney's tint; the tint nearest to a colour c of brightness 1 is the t in [0, 1] for which",
    'mix(1, base / brightness of the base, t) is closest to it: brightness is kept exactly, hue as far as the line from white to the base',
    'colour reaches. Both shadings are lit in physical units as three.js 0.187 is: no factor of PI, which r115 had unless',
    '`physicallyCorrectLights` was set. The index of a dielectric beyond 2.33 (r115) or 1.79 (Disney) is the highest each has.',
    "Where the viewer or the light is at or below the horizon the cosines are 0: r115's sheen had the values of negative cosines.",
    '',
    '## Where the listings err',
    '',
    '- The formula of D lacks the square of n.m; its code (listing 6.5) has it, and so has telar.',
    '- The diffuse formula of Disney has its parentheses displaced, names theta_t what is theta_l, and does not define F_D90: 1/2 + 2 cos^2(theta_d) roughness.',
    "- The exponent of Disney's sheen stands inside of the cosine: it is (1 - cos theta_d)^5.",
    '- Listings 6.1 and 6.2 lack a parenthesis and an #endif; 6.4 has a comma in its signature; 6.12, of clearcoatDHRApprox, is empty: three.js r115 has 0.04 + 0.96 (1 - cos)^5 (1 - roughness)^2.',
    '- Clearcoat, sheen and base are said to accumulate: where a material had sheen, r115 left the base gloss out.',
    '- The G of listing 6.7 is V = G / (4 NoL NoV). The anisotropic, metallic base of Disney has its like in r115 for metals: by f0.',
    '- It has nothing of indirect light: the slots `scattering` and `environment` of `three-r115` are from the source of three.js r115.',
    '',
    '## The environment',
    '',
    'It is prefiltered and read as in three.js 0.187, whatever the shading. The diffuse lobe reads the irradiance times its directional albedo: in closed',
    'form for `disney-2012`, `frostbite`, `disney-2015-thin` and `eon`. Sheen, where the layering has it, reads the same times the albedo of its lobe:',
    '`disney-2012` within 1e-4, `zeltner` and `uncharted-4` exactly, `charlie-neubelt` within 0.012, `ashikhmin-velvet` 0.03, `charlie-estevez-kulla` 0.06. With',
    "`smith-separable` the split sum is reduced as the lobe is, within 0.05. Disney's coat reads the environment at the width of its lobe times its albedo, within 0.005.",
    '',
    "Quality `reference`, and `high` where it asks for directions of the environment, light a surface from each of them as a lamp does: there r115's",
    'sheen is in the environment too, and its coat takes by the angle of each direction.',
    '',
    'How far the raster is from the path tracer with the same text (leather, wool, towel and velvet under the studio, no maps, nothing hidden; mean difference in',
    'linear radiance, sign included): `disney-2012` -1.1 % to +0.8 %; `three` -1.4 % to +4.0 %; `three-r115` -2.9 % leather, -6.3 % to -7.0 % wool and towel, -30 %',
    'velvet: the sheen that its prefiltered environment lacks.',
    '',
  ].join('\n');
}
