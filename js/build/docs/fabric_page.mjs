import { readFileSync } from 'node:fs';
import { fieldRows } from './tables.mjs';

const json = (file) => JSON.parse(readFileSync(new URL(`../../assets/${file}`, import.meta.url), 'utf8'));

const INTRODUCTION = `# Cloth in glTF

The shading \`fabric\` reads the material of glTF 2.0 and its KHR_materials_* extensions, and two more:

- \`KHR_materials_diffuse_transmission\`: light that passes through thin cloth. The shading \`three\` does not draw it, as three.js does
  not, and warns with \`W_EXT_IGNORED\`.
- \`TELAR_materials_fabric\`, telar's own, on this page. The other shadings leave it out without a word, but for \`flatness\`, which
  \`disney-2012\` reads as its subsurface. Its JSON Schema is \`js/assets/TELAR_materials_fabric.schema.json\`.

\`\`\`json
{
  "pbrMetallicRoughness": { "baseColorFactor": [0.05, 0.07, 0.16, 1] },
  "normalTexture": { "index": 0 },
  "doubleSided": true,
  "extensions": {
    "TELAR_materials_fabric": {
      "preset": "denim",
      "weave": { "threadsPerUv": [8, 8], "weaveTexture": { "index": 1 } }
    }
  }
}
\`\`\`

Tools that drop extensions which they do not know keep \`extras\`: the same object may stand there,
\`"extras": { "TELAR_materials_fabric": { "preset": "denim" } }\`. Where a material has both, the extension counts alone. Textures belong
into the extension: a tool that sorts textures anew knows nothing of indices in extras.
Values out of their range are kept in it with \`W_RANGE\`; wrong types and indices of textures that do not exist are errors.`;

const ON_A_MODEL = `## On a model

\`materials\` of a shot shows parts of a model in a cloth, without a change to its file:

\`\`\`js
await renderer.render('shirt.glb', {
  shading: 'fabric',
  materials: { 'Body*': { preset: 'denim', color: '#23324f' }, Collar: { color: 'white' }, Pocket: { preset: 'denim', rotation: 45 } },
});
\`\`\`

\`\`\`sh
telar thumbnail shirt.glb -o shirt.png --shading fabric --material 'Body*=denim:#23324f' --material 'Collar=:white'
\`\`\`

- **A part** goes by the name of a material, or of a node with all beneath it; \`telar inspect\` lists the materials. \`*\` stands for any characters,
  digits alone for the index of a material. What nothing is called is the error \`E_CLOTH\`.
- **A preset** brings everything but occlusion, sides and name of the part, with maps of its construction: js/assets/cloths/PRESET.glb, a square of 10 cm. [All of them](cloths.md) in a picture.
- **The size** is true: metres that a unit of the part's texture coordinates (TEXCOORD_0) covers are measured on the model, as medians by area, along u and v
  apart. \`metresPerUv\` states them in their place, one number or [u, v], for a model that is not in metres or was laid out unevenly:
  \`--set 'materials.Body*.metresPerUv=0.5'\`, \`--set 'materials.Body*.metresPerUv=[0.5,0.4]'\`. The warp runs along v; \`rotation\` turns it. A part without texture coordinates wears the cloth without its maps (\`W_CLOTH_UV\`).
- **What a model may wear** \`telar inspect\` says of each material: \`preset\`, the cloth that its file names, \`metresPerUv\` as measured, and \`proposedPreset\`,
  the cloth that the words of its name suggest (\`Body_Denim_v2\`, \`jeans\`, \`terciopelo\`), else null. A proposal is put on by nobody but the caller.
- **\`color\`** is the mean of what the cloth shows, also where its yarns differ. Without it the part keeps its own colour, and its picture where the cloth has none.
  \`color\` alone leaves the material and takes its picture away, unless that cuts the part's shape out.
- **In the browser** \`applyShot\` does the same; it asks for the files: \`cloths: (preset) => loader.loadAsync('/cloths/' + preset + '.glb')\`, which the package exports as
  \`telar/cloths/PRESET.glb\`.`;

const MAPS = `## Maps

**Normal maps.** A weave is finer than a pixel in a picture of a garment. Averaged normals lose their spread, and cloth seen from far
would gloss like varnish and shimmer. For the shading \`fabric\` each normal map (also that of a clearcoat) is made anew once a model, on the
GPU, into a map of relief whose mip levels hold the mean of its unit normals and of how flat they lie. The length of a mean normal tells what
light the texels lose that turn away from it: diffuse light, gloss and sheen each take their mean over the texels (shaders/brdf/relief.glsl;
Toksvig 2005, Han et al. 2007). Normals that lean away from the viewer reflect more, and leave less to the layers below.
Cords, ribs and twills lean across their lines and hardly along them: 1024 places of the map tell how much more (once a map, below a millisecond), and diffuse light and sheen depend on whether light and viewer stand across the lines or along them. How flat most of them lie widens the highlight: \`alpha² + variance\` (Olano & Baker 2010, LEAN mapping),
and a few steep edges do not. A single texel has neither: from near, nothing changes. The roughness texture may have another size, UV
set, transform or sampler: the relief travels with the normals.
On polished metal (\`metallicFactor\` of at least 0.5, \`roughnessFactor\` of 0.3 at most; sequins) the map holds the slopes of what lies flat in
place of all normals, and is read one level sharper: flat facets keep a sharp highlight, and the edges between them have a wide one of their own
(shaders/brdf/facets.glsl; a mixture of lobes, Han et al. 2007). Woven, stretched and cut-out materials have one highlight as before.
Where a weave map lies on the normal map, a second map, of a quarter of its side, holds how flat the warp and the weft lie, each along itself and across
it, as normal map and weave map have them together: a yarn is round across and straight along, so that relief widens its highlight across it more.
Set a sampler that reads mip levels (glTF's default does); with \`minFilter\` LINEAR or NEAREST there is nothing to read it from.
Materials without a normal map and other shadings pay nothing. The map of relief takes 8 bytes of GPU memory a texel, beside the image.

**Metal and the rest in one pixel**, as gold yarns on silk. Means of base colour and of metalness by themselves do not tell whose colour the metal
has. Where a material has both textures in one place (set and transform) and is not cut out, a map of 4 bytes a texel holds the mean of base colour
times metalness; with a weave map in the same place also how much of the metal lies in the warp. A metalness without metal costs one texel. Of
other materials the metal has the mean colour, as before.

**Holes** (\`alphaMode\` MASK with a base colour texture): lace, tulle, mesh. Mip levels hold the share of a texel that is there, and the
colour of that part alone; the edge of level 0 is drawn as wide as a pixel. From far the share of a pixel is the mean of its quarters, each read
1.5 levels finer than the sampler reads colours, so that threads about as wide as a pixel are seen. What is there in part is blended over
what lies behind it: two layers of a net that covers 0.36 cover 0.59, three cover 0.74. Where a part of the model transmits, through which
nothing blended is seen, the share becomes halves of the pixel's samples, by a noise that is even over 2 x 2 pixels; with \`samples: 1\`, or on a
GPU without sample masks, it becomes whole pixels. Layers over each other have noises of their own then (Enderton et al. 2010, Wyman & McGuire
2017), told apart by their distance from the camera where it differs by more than 1/8192; more \`samples\` average the grain. A
texture whose alpha nowhere reaches \`alphaCutoff\` draws nothing. Its shadow is that of the plain image, as in three.js.

**Shadows** of sheer cloth (BLEND) let through what its alpha leaves: so many texels of the shadow map are left out, which its filter averages; in one pass some grain is left. Each layer takes its part of the light
where their depths from the light differ by more than 1/256 of the map's range. Nearer ones take together what one does. Alpha of vertices has no part in it.

**Folds** of nets, and of sheer cloth (BLEND), show what lies behind them: the triangles of a mesh are drawn far to near, by their middles, on the server and in
the browser, which puts them in order anew where mesh or camera has moved. Meshes go one after the other, as in three.js; instances are drawn as the file has their triangles.

**Weave maps.** Where less than a quarter of a thread falls into a pixel, the yarn on top gives the highlight; from half a thread on both sets
of yarns do, as they lie on average, so that nothing shimmers. Without \`threadsPerUv\` the map's own mip levels decide. What a leaning yarn
sends below the surface comes back mirrored at it; a yarn that leans away from the viewer is seen as if it just faced him.

**Gaps** (coverages that sum to less than 1) have no highlight. In the gaps of a dielectric light meets the diffuse lobe without an interface
over it: it comes back as diffuse light, or goes through by KHR_materials_diffuse_transmission, and white cloth stays white. A metal has no
diffuse light: what falls into its gaps is gone, so that a white metal whose yarns cover 0.6 reflects 0.6 of the light. What lies behind
the cloth is not seen through gaps; holes that show it belong in the alpha of the base colour.

**The back** is what is seen of a \`doubleSided\` material where its triangles run clockwise.`;

const PRESETS = `## Presets

A preset is part of a glTF material. What the material leaves out, at any depth, is taken from it, in the shading \`fabric\` alone; what glTF
gives a default to counts as left out when the file does not write it (metallicFactor, roughnessFactor). The base colour, textures,
\`doubleSided\` and \`alphaMode\` stay the material's own. A sheen that comes from the preset is that of undyed fibre:
it is multiplied by the root of the base colour factor, for light that leaves near the ends of fibres has crossed about half of the dye (reasoned), and light that passes
through is multiplied by the factor itself. An unknown name costs \`W_ENUM\`. js/assets/fabric_presets.json is the one table of
them, for the server and the browser.

Where a number is measured the source is named; the others are reasoned from the construction of the cloth, which is said. Threads or other units a centimetre,
relief, cover and weight are those of js/assets/make/cloths; a test holds each to what the maps have. "Usual" is the range in which such cloth is sold,
as mills and shops state it: no one source was measured for it. "Geometry" follows from the numbers beside it: grams a square metre are
threads a centimetre times their tex, over 10. A repeat holds as many threads as keep its irregular yarns from showing, and has no other source.

The classes are those that fashion shops have filters for or name in titles, one for each way in which cloth meets light: wefts and warps with a highlight each
(denim, twill, satin, silk, shell), knits by their loops, pile and nap, skins and films, nets and sheers, metal. Left out of what shops list:
vinyl, which is patent leather with another back; faux fur, whose strands need geometry of their own; reflective tape, which needs a lobe that sends light back.

| source | |
|---|---|
| Morton-Hearle | Morton & Hearle 2008, Physical Properties of Textile Fibres, 4th edition, table 24.1: refractive indices along and across the fibre. The mean is that of the three axes. |
| Sadeghi 2013 | Sadeghi, Bisker, De Deken & Jensen 2013, A Practical Microcylinder Appearance Model for Cloth Rendering, ACM TOG 32(2), table II: coverages and lobe widths fitted to measured cloth |
| Zeltner 2022 | Zeltner, Burley & Chiang 2022, Practical Multiple-Scattering Sheen Using Linearly Transformed Cosines |`;

/** One preset: what it is, its numbers as a glTF material, where they come from. */
function presetSection([name, { summary, threadsPerCm, construction, why, material }]) {
  const threads = threadsPerCm ? ` ${threadsPerCm[0]} x ${threadsPerCm[1]} threads a centimetre.` : '';
  return [
    `### ${name}`,
    '',
    `${summary[0].toUpperCase()}${summary.slice(1)}.${threads}`,
    '',
    ...[...construction, ...why].map((line) => `- ${line}`),
    '',
    '```json',
    JSON.stringify({ extensions: { TELAR_materials_fabric: { preset: name } } }),
    '```',
    '',
    'stands for',
    '',
    '```json',
    JSON.stringify(material),
    '```',
  ].join('\n');
}

/** @returns {string} js/docs/fabric.md */
export function fabricPage() {
  const schema = json('TELAR_materials_fabric.schema.json');
  return `${[
    INTRODUCTION,
    'This page is generated by `node js/build/docs/generate.mjs`.',
    '## Properties',
    fieldRows(schema).join('\n'),
    ON_A_MODEL,
    MAPS,
    PRESETS,
    ...Object.entries(json('fabric_presets.json')).map(presetSection),
  ].join('\n\n')}\n`;
}
