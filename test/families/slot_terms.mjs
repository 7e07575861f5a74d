// The slots that releases of three.js differ in, and what stands in each by release. Read in their sources; slots_*.mjs have the proofs.
// r is the perceptual roughness, a = r^2, F0 and F90 the reflectances, A and B the two parts of DFG, E = A + B, m = 1 - E.

/**
 * @typedef {object} Term
 * @property {string} [from] - First release that has it; the first that is looked at where it is left out.
 * @property {string} [to] - Last release that has it; the last that is looked at where it is left out.
 * @property {string} what - What it computes.
 *
 * @typedef {object} SlotTerms
 * @property {string} slot
 * @property {string} [key] - Of js/shot/three_terms.mjs, where a shot can choose: left out for what a client sets, and for faults.
 * @property {string} [source] - Paper.
 * @property {Term[]} terms - Oldest first.
 */

const BLUR = `faces of 2^floor(log2(width / 4)) texels with a border of one, each read once from the map, bilinear. Levels halve down to 16, then six more of 16.
  Level i is level i - 1 blurred by a Gaussian of sqrt(s(i)^2 - s(i-1)^2) rad: s = 1 / size, s(0) = 0, for the last six 0.125, 0.215, 0.35, 0.446, 0.526, 0.582. Two passes, about a pole
  and along its meridians, in steps of pi / (2 (size of level i-1 - 1)), weights exp(-x^2 / 2) up to three deviations and 20 steps, in mediump: on Mesa that is half floats, and up to 2/255`;
const READ = `Read between two levels at mip(r), linear between r = 1, 0.8, 0.4, 0.305, 0.21 at -2, -1, 2, 3, 4, and -2 log2(1.16 r) below, at most log2(size); mip 4 is the first level of 16.
  Irradiance is pi times the level of r = 1`;
const CHAIN = `faces and levels as before. Level i of n is level i - 1 under GGX of roughness sqrt(t(i)^2 - t(i-1)^2) k(t(i)), t = i / (n - 1): the mean of 256 Hammersley half vectors of visible
  normals about V = N, each reflected direction read bilinear at level i - 1 and weighed by N.L`;

/** @type {SlotTerms[]} */
// biome-ignore format: one row a line, read as a table
export const SLOT_TERMS = [
  {
    slot: 'environment prefilter', key: 'prefilter', source: 'Heitz 2018, "Sampling the GGX Distribution of Visible Normals"; Karis 2013, "Real Shading in Unreal Engine 4"',
    terms: [
      { to: '0.163.0', what: `${BLUR}. The pole of level i is number (i - 1) mod 10 of (1,1,1), (-1,1,1), (1,1,-1), (-1,1,-1), (0,p,q), (0,p,-q), (q,0,p), (-q,0,p), (p,q,0), (-p,q,0), p = 1.618..., q = 1 / p. ${READ}` },
      { from: '0.164.0', to: '0.180.0', what: 'as before; the pole of level i of n is number (n - i - 1) mod 10 of that list from its end' },
      { from: '0.181.0', to: '0.181.0', what: `${CHAIN}, with 512 half vectors and k(t) = 0.05 + 0.95 t, in mediump: on Mesa, whose small integers have 16 bits, the half vectors are wrong and far too bright. Made for the size of the first environment
        of a page: others are read at wrong places` },
      { from: '0.181.1', to: '0.181.1', what: 'as before with 256 half vectors and in highp; other sizes still wrong' },
      { from: '0.181.2', to: '0.181.2', what: "as before, made anew for each size" },
      { from: '0.182.0', to: '0.185.1', what: 'as before with k(t) = 1.25 t' },
      { from: '0.186.0', to: '0.186.1', what: 'as before; texel directions are interpolated from the corners of a face, where they were computed a pixel: another rounding' },
      {
        from: '0.187.0',
        what: `a cube with mip levels: at least 256 texels a face, each the mean of four reads of the map, levels down to 8. Level l of L is for r = 1 - sqrt(1 - l / L), read at L r (2 - r). The last three sum all
          texels of 16 x 16 faces under GGX; the others take 256 visible normals at the mip of their solid angle, half a level up`,
      },
    ],
  },
  {
    slot: 'reflection direction', key: 'reflectionDirection', source: 'Lagarde and de Rousiers 2014, "Moving Frostbite to PBR"',
    terms: [{ to: '0.180.0', what: 'normalize(mix(reflect, normal, r^2))' }, { from: '0.181.0', what: 'normalize(mix(reflect, normal, r^4))' }],
  },
  {
    slot: 'DFG', key: 'dfg', source: 'Karis 2014, "Physically Based Shading on Mobile"; Karis 2013',
    terms: [
      {
        to: '0.180.0',
        what: "fit: v = r (-1, -0.0275, -0.572, 0.022) + (1, 0.0425, 1.04, -0.04); k = min(v.x^2, 2^(-9.28 NoV)) v.x + v.y; A = -1.04 k + v.z, B = 1.04 k + v.w",
      },
      { from: '0.181.0', to: '0.181.2', what: 'table of 32 x 32 half floats, linear, read at (r, NoV) with no half texel, clamped' },
      { from: '0.182.0', what: 'table of 16 x 16, read alike' },
    ],
  },
  {
    slot: 'environment by metalness', key: 'environmentMetal', source: 'Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image Based Lighting"',
    terms: [
      { to: '0.181.2', what: 'one F0, mixed by metalness: single = F0 A + F90 B; multiple = single f / (1 - m f) m, f = F0 + (1 - F0) / 21; diffuse (1 - largest channel of single + multiple)' },
      { from: '0.182.0', what: 'single and multiple for the dielectric F0 and for the base colour, each, then mixed by metalness; diffuse (1 - single - multiple of the dielectric), by channel' },
    ],
  },
  {
    slot: 'direct multiple scattering', key: 'directMultiscatter', source: 'Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models"',
    terms: [
      { to: '0.180.0', what: 'none' },
      { from: '0.181.0', to: '0.181.2', what: 'adds s(V) s(L) f / (1 - m(V) m(L) f^2 + 1e-6) m(V) m(L) to the BRDF, s = F0 A + F90 B, f = F0 + (1 - F0) / 21; without D, so it lights where N.L > 0' },
      { from: '0.182.0', to: '0.185.1', what: 'the same with f in place of f^2, F0 mixed by metalness' },
      { from: '0.186.0', what: 'the BRDF times 1 + F0 (1 / E(V) - 1), equation 16; a coat has none' },
    ],
  },
  {
    slot: 'diffuse under direct light', key: 'directDiffuse',
    terms: [{ to: '0.185.1', what: 'base colour (1 - metalness) / pi' }, { from: '0.186.0', what: 'that times 1 - F, F of Schlick for the dielectric F0 and F90 at V.H' }],
  },
  {
    slot: 'diffuse under ambient light', key: 'ambientDiffuse',
    terms: [{ to: '0.185.1', what: 'base colour (1 - metalness) / pi, for ambient and hemisphere lights' }, { from: '0.186.0', what: 'that times 1 - single - multiple of the dielectric, as under the environment' }],
  },
  {
    slot: 'sheen albedo', key: 'sheenAlbedo', source: 'Estevez and Kulla 2017, "Production Friendly Microfacet Sheen BRDF"',
    terms: [
      {
        to: '0.181.2',
        what: `saturate(x / pi), r >= 0.07: for r < 0.25 x = exp((-339.2 r^2 + 161.4 r - 25.9) NoV + 44 r^2 - 23.7 r + 3.26), else x = exp((-8.48 r^2 + 14.3 r - 9.95) NoV + 1.97 r^2 - 3.27 r + 0.72) + 0.1 (r - 0.25).
          The environment gives irradiance times colour times that`,
      },
      {
        from: '0.182.0',
        what: "saturate(exp(a NoV + b)), r >= 0.0001: a = -1.9362 + 1.0678 r + 0.4573 r^2 - 0.8469 / (r + 0.1), b = -0.6014 + 0.5538 r - 0.4670 r^2 - 0.1255 / (r + 0.1). The environment gives irradiance / pi times colour times that",
      },
    ],
  },
  {
    slot: 'sheen energy', key: 'sheenEnergy', source: 'Estevez and Kulla 2017; Kulla and Conty 2017',
    terms: [
      { to: '0.181.2', what: 'all light of the base, emission too, times 1 - 0.157 max(sheen colour)' },
      { from: '0.182.0', what: 'direct light times 1 - max(colour) max(albedo at N.V, albedo at N.L); the environment and ambient light times 1 - max(colour) albedo at N.V' },
    ],
  },
  { slot: 'sheen under ambient light', key: 'ambientSheen', terms: [{ to: '0.185.1', what: 'none' }, { from: '0.186.0', what: 'ambient irradiance / pi times colour times albedo at N.V' }] },
  {
    slot: 'iridescence by metalness', key: 'filmMetal', source: 'Belcour and Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence"',
    terms: [{ to: '0.181.2', what: 'film over F0 mixed by metalness' }, { from: '0.182.0', what: 'films over the dielectric F0 and over the base colour, mixed by metalness' }],
  },
  {
    slot: 'iridescence in the environment', key: 'filmEnvironment',
    terms: [
      { to: '0.185.1', what: 'the reflectance of the film at N.V stands for F0' },
      { from: '0.186.0', what: 'F0 = (R - x) / (1 - x), x = min((1 - N.V)^5, 0.9999), so that Schlick gives R at N.V' },
    ],
  },
  {
    slot: 'anisotropic visibility', key: 'anisotropicVisibility', source: 'Heitz 2014, "Understanding the Masking-Shadowing Function"',
    terms: [
      { from: '0.153.0', to: '0.181.2', what: 'saturate(0.5 / (gv + gl))' },
      { from: '0.182.0', to: '0.183.2', what: '0.5 / (gv + gl): no number along silhouettes, which is drawn black' },
      { from: '0.184.0', what: '0.5 / max(gv + gl, 1e-6)' },
    ],
  },
  {
    slot: 'anisotropy direction', key: 'anisotropyDirection',
    terms: [
      { to: '0.152.2', what: 'no anisotropy' },
      { from: '0.153.0', to: '0.158.0', what: 't = T x - B y, b = B x + T y for the vector (x, y): turns the wrong way; a vector of length 0 gives no number' },
      { from: '0.159.0', what: 't = T x + B y, b = B x - T y; (1, 0) for a vector of length 0' },
    ],
  },
  { slot: 'least roughness', key: 'roughnessMin', terms: [{ to: '0.186.1', what: 'r and that of the coat are at least 0.0525, before the geometric roughness is added' }, { from: '0.187.0', what: 'at least 0.045' }] },
  {
    slot: 'diffuse roughness', key: 'diffuseRoughness', source: 'Portsmouth, Kutz and Hill 2025, "EON: A Practical Energy-Preserving Rough Diffuse BRDF"',
    terms: [{ to: '0.186.1', what: 'KHR_materials_diffuse_roughness is not read' }, { from: '0.187.0', what: 'EON' }],
  },
  {
    slot: 'occlusion of coat and sheen', key: 'layerOcclusion',
    terms: [{ to: '0.157.0', what: 'the occlusion map dims diffuse light and reflections of the environment' }, { from: '0.158.0', what: 'and, by its plain value, what coat and sheen take of the environment' }],
  },
  {
    slot: 'rect light, F90', key: 'rectF90', source: 'Hill and Heitz 2016, "Real-Time Area Lighting: a Journey from Research to Production"',
    terms: [{ to: '0.182.0', what: 'F0 t2.x + (1 - F0) t2.y' }, { from: '0.183.0', what: 'F0 t2.x + (F90 - F0) t2.y' }],
  },
  { slot: 'rect light on the coat', key: 'rectCoat', terms: [{ to: '0.182.0', what: 'none' }, { from: '0.183.0', what: 'the coat has its own, of its normal and roughness, F0 0.04 and F90 1' }] },
  {
    slot: 'shadow filter', key: 'shadowFilter', source: 'Jimenez 2014, "Next Generation Post Processing in Call of Duty" (noise); Vogel 1979 (disk)',
    terms: [
      {
        to: '0.181.2',
        what: `depth in 8-bit RGBA, nearest. PCF: mean of 17 compares at (x, y) radius texels, x and y of -1, 0, 1 and of -0.5, 0, 0.5, and (0, 0) once. Soft PCF: 4 x 4 compares of single
          texels, the outer ones weighed by the place between texels, over 9, without radius. VSM: mean and deviation of depth, two bytes each.
          Point lights: an atlas of 4 x 2 faces of distance to the light by (length - near) / (far - near), nine compares at the unit direction and at
          the corners of a cube of half side radius / (2 size) about it`,
      },
      {
        from: '0.182.0',
        what: `depth textures. PCF: mean of 5 reads with linear compare on a Vogel disk of radius texels, turned by interleaved gradient noise of the pixel. VSM: half floats. Point lights: a cube of perspective depth of each face,
          5 reads on a disk of radius / size about the direction`,
      },
    ],
  },
  {
    slot: 'packing of shadow depths', key: 'shadowPacking',
    terms: [
      { to: '0.166.0', what: 'a depth of 1, which is that of what point lights see beyond far, is kept as 255 / 256: it shadows what lies nearly as far' },
      { from: '0.167.0', what: 'as 1' },
    ],
  },
  {
    slot: 'intensity of shadows', key: 'shadowIntensity',
    terms: [{ to: '0.165.0', what: 'none: a shadow takes all of the light' }, { from: '0.166.0', what: 'the part of the light that a shadow takes' }],
  },
  {
    slot: 'shadows of point lights', key: 'pointShadow',
    terms: [
      { to: '0.162.0', what: 'points beyond near and far are compared too: dark beyond far' },
      { from: '0.163.0', to: '0.186.1', what: 'points beyond near and far are lit' },
      { from: '0.187.0', what: 'each of the five reads compares with the depth on the face that it falls on, at the distance of the point' },
    ],
  },
  {
    slot: 'precision of samplers', key: 'samplerPrecision', source: 'GLSL ES 3.00, section 4.5.4',
    terms: [
      { to: '0.160.1', what: 'the default of GLSL ES, lowp for sampler2D and samplerCube: what Mesa reads of maps, environments, tables and packed depths is rounded to half floats; GPUs without small floats show nothing of it. What morph targets move vertices by is mediump: it moves silhouettes by less than a pixel, which is not drawn' },
      { from: '0.161.0', what: 'highp, as the rest of the text' },
    ],
  },
  {
    slot: 'background cube', key: 'backgroundCube',
    terms: [{ to: '0.160.1', what: 'a sharp background is looked up in a cube whose faces have half the rows of the map' }, { from: '0.161.0', what: 'as many as the map has rows' }],
  },
  { slot: 'environment rotation', key: 'environmentRotation', terms: [{ to: '0.161.0', what: 'none: a client turns the texels, by as many columns of the map as the angle is, rounded' }, { from: '0.162.0', what: 'a rotation of the direction that is looked up' }] },
  {
    slot: 'soft shadows',
    terms: [
      { to: '0.181.2', what: 'PCFSoftShadowMap has its own filter, above' },
      { from: '0.182.0', to: '0.182.0', what: 'PCFSoftShadowMap draws as BasicShadowMap' },
      { from: '0.183.0', what: 'PCFSoftShadowMap draws as PCFShadowMap' },
    ],
  },
  {
    slot: 'normal offset of shadows', key: 'shadowNormalOffset',
    terms: [
      { to: '0.183.2', what: 'meshes without normals are looked up at a vector of length 0, normalised: lit, but dark where points beyond near and far are compared' },
      { from: '0.184.0', what: 'at their own place' },
    ],
  },
  {
    slot: 'tone mapping neutral', key: 'neutralToneMapping', source: 'Khronos PBR Neutral Tone Mapper',
    terms: [{ to: '0.161.0', what: 'absent' }, { from: '0.162.0', to: '0.162.0', what: 'desaturates towards 1' }, { from: '0.163.0', what: 'desaturates towards the compressed peak' }],
  },
  { slot: 'tone mapping agx', terms: [{ to: '0.159.0', what: 'absent' }, { from: '0.160.0', what: 'as today' }] },
  { slot: 'dispersion', key: 'dispersion', terms: [{ to: '0.163.0', what: 'KHR_materials_dispersion is not read' }, { from: '0.164.0', what: 'three refractions, index ior -+ 0.025 dispersion (ior - 1)' }] },
  {
    slot: 'transmission over a colour', key: 'glassBackground',
    terms: [
      { to: '0.152.2', what: 'the buffer behind glass is cleared to what the canvas is: a colour sRGB-encoded, in linear floats; (0, 0, 0, 0) where there is none' },
      { from: '0.153.0', to: '0.164.1', what: 'cleared to white of alpha 0.5, premultiplied, over any colour: the clear alpha of a see-through canvas is below 1' },
      { from: '0.165.0', what: 'cleared with the linear colour; to white of alpha 0.5 where there is none' },
    ],
  },
  {
    slot: 'back sides behind glass', key: 'glassBackSides',
    terms: [{ to: '0.150.1', what: 'two-sided glass does not see its own far side' }, { from: '0.151.0', what: 'the back sides of two-sided glass are drawn into the buffer behind it' }],
  },
  {
    slot: 'buffer behind glass', key: 'glassBuffer',
    terms: [
      { to: '0.152.2', what: '1024 x 1024 texels whatever the size of the picture' },
      { from: '0.153.0', what: 'as large as the canvas' },
    ],
  },
  {
    slot: 'samples behind glass', key: 'glassSamples',
    terms: [
      { to: '0.153.0', what: 'four a texel with antialias, else one' },
      { from: '0.154.0', to: '0.181.2', what: 'four' },
      { from: '0.182.0', to: '0.183.2', what: 'as many as the canvas has: one without antialias' },
      { from: '0.184.0', what: 'as many as the canvas has, at least four' },
    ],
  },
  {
    slot: 'alpha of glass', key: 'glassAlpha',
    terms: [
      { to: '0.152.2', what: 'alpha t + 0.1, t that of the buffer behind; attenuation does not count' },
      { from: '0.153.0', what: 'alpha 1 - (1 - t) k, k the mean over the channels of base colour times attenuation' },
    ],
  },
  {
    slot: 'texture coordinates', key: 'textureCoordinates',
    terms: [
      { to: '0.150.1', what: `one transform for all maps of a material: that of the first of map, normal, roughness, metalness, emissive, coat (factor, normal, roughness), iridescence, specular (factor, colour), transmission, thickness, sheen;
          occlusion has its own, and the second coordinates where the mesh has such. Other maps have the first coordinates` },
      { from: '0.151.0', what: 'each map has its own transform and coordinates' },
    ],
  },
  { slot: 'nodes of several scenes', terms: [{ to: '0.182.0', what: 'a node that several scenes list is in the last of them alone, which need not be the one that is drawn' }, { from: '0.183.0', what: 'it is in each' }] },
  { slot: 'animated weights', terms: [{ to: '0.183.2', what: "those of a node move the morph targets of all nodes beneath it too" }, { from: '0.184.0', what: "those of its own mesh" }] },
  { slot: 'sparse normalized accessors', terms: [{ to: '0.168.0', what: 'what the sparse part gives is normalized twice' }, { from: '0.169.0', what: 'once' }] },
  {
    slot: 'KTX2 beside Basis Universal',
    terms: [
      { to: '0.176.0', what: 'of KHR_texture_basisu, ETC1S and UASTC as today; of what the extension does not allow, raw 8-bit, half and float formats alone, without mip levels of their own. A texture that is not read is left out' },
      { from: '0.177.0', to: '0.179.1', what: 'and BC1, BC3, BC5, BC7' },
      { from: '0.180.0', to: '0.181.2', what: 'and BC4, ETC2, ASTC 4 x 4 in sRGB, floats of 5, 9 to 11 bits' },
      { from: '0.182.0', to: '0.183.2', what: 'and EAC' },
      { from: '0.184.0', what: 'and 16-bit RGBA' },
    ],
  },
  { slot: 'index of refraction of 0', terms: [{ to: '0.183.2', what: 'as it is: where light passes through, the surface has no number and is not drawn' }, { from: '0.184.0', what: 'as 1000' }] },
  { slot: 'unlit', terms: [{ to: '0.155.0', what: 'as today' }, { from: '0.156.0', to: '0.156.0', what: 'GLTFLoader fails at a colour of an unlit material' }, { from: '0.156.1', what: 'as today' }] },
  { slot: 'sorting', key: 'sorting', terms: [{ to: '0.151.3', what: "by depth of the object's origin, z / w" }, { from: '0.152.0', to: '0.165.0', what: 'by z / w of the middle of its bounding sphere; that of a skinned or instanced mesh before it moves, to 0.152.2: what lies behind the camera counts as the farthest' }, { from: '0.166.0', what: 'by z of that in clip space' }] },
  { slot: 'bump maps', key: 'bump', terms: [{ to: '0.158.0', what: 'EXT_materials_bump is not read' }, { from: '0.159.0', what: 'read' }] },
  { slot: 'colours of instances', key: 'instanceColor', terms: [{ to: '0.157.0', what: '_COLOR_0 of EXT_mesh_gpu_instancing is not read' }, { from: '0.158.0', what: 'a factor on the colour' }] },
  { slot: 'tangents of instances', key: 'instanceTangents', terms: [{ to: '0.158.0', what: 'those of the mesh, which do not turn with the instance' }, { from: '0.159.0', what: 'turned by its matrix' }] },
  { slot: 'tangents of back sides', key: 'flippedTangents', terms: [{ to: '0.184.0', what: 'back sides that are drawn as front sides, of blended and of transmissive two-sided surfaces, have the tangent turned round' }, { from: '0.185.0', what: 'as the mesh has it' }] },
  {
    slot: 'normal maps of flat faces', key: 'flatFrames',
    terms: [
      { to: '0.150.1', what: 'tangent and bitangent turn round on the back of a two-sided face' },
      { from: '0.151.0', to: '0.184.0', what: 'on flat faces they do not' },
      { from: '0.185.0', what: 'on any face they do' },
    ],
  },
  {
    slot: 'vertex colours that morph', key: 'morphColors',
    terms: [
      { to: '0.182.0', what: 'as today' },
      { from: '0.183.0', to: '0.186.1', what: 'the program does not compile: the mesh is not drawn, but casts its shadow' },
      { from: '0.187.0', what: 'the sum of the weighed targets' },
    ],
  },
  { slot: 'maps of lines', key: 'lineMap', terms: [{ to: '0.150.1', what: 'lines show no base colour texture' }, { from: '0.151.0', what: 'they do' }] },
  {
    slot: 'colour management',
    terms: [
      { to: '0.151.3', what: 'off: a client gives linear colours to lights and materials, sRGB ones to the background, and writes outputEncoding; what GLTFLoader gives is the same as today' },
      { from: '0.152.0', what: 'on: linear working colours, outputColorSpace sRGB' },
    ],
  },
  {
    slot: 'light units', source: 'Lagarde and de Rousiers 2014 (window of the range)',
    terms: [
      { to: '0.154.0', what: 'legacy by default: all lights but rect ones times pi, and a point or spot light falls off as saturate(1 - d / range)^decay, not at all without a range. With useLegacyLights = false as today' },
      { from: '0.155.0', what: 'lux, candela, nit; d^-2 saturate(1 - (d / range)^4)^2' },
    ],
  },
  {
    slot: 'texture transform', key: 'textureTransform',
    terms: [{ to: '0.185.1', what: 'KHR_texture_transform turns before it scales: T S R' }, { from: '0.186.0', what: 'as glTF says: T R S' }],
  },
  { slot: 'ior 0', key: 'ior0', terms: [{ to: '0.183.2', what: 'F0 = ((0 - 1) / (0 + 1))^2 = 1 before the specular factor, refraction by 0' }, { from: '0.184.0', what: 'an index of 1000' }] },
];
