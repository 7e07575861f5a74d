import { boolean, choice, list, literal, object } from './rows.mjs';

/**
 * Images of one shot beside its colour. All of them show what lies at the centre of a pixel, without antialiasing, but for `coverage`
 * and `line`.
 * C++ has them as an enum in this order.
 *
 * `doc`: what its values are. `channels`: names in an EXR file; their number is that of the image.
 */
export const LAYERS = Object.freeze({
  depth: { doc: 'distance from the plane through the camera, along the view, metres', channels: ['Z'] },
  normal: { doc: 'shading normal with its maps, world space, unit', channels: ['X', 'Y', 'Z'] },
  partId: { doc: 'number of the node, `info.layers.partId.legend`', channels: ['id'] },
  materialId: { doc: 'number of the material, `info.layers.materialId.legend`', channels: ['id'] },
  ao: { doc: 'ambient occlusion: part of the hemisphere above the surface that is open, weighted by the cosine, 0..1', channels: ['Y'] },
  albedo: { doc: 'base colour, linear Rec.709; in PNG sRGB', channels: ['R', 'G', 'B'] },
  shadow: { doc: 'part of the light of lights with `castShadow` that does not arrive, 0..1; on the `ground` too', channels: ['Y'] },
  coverage: { doc: 'part of the pixel that the model covers, 0..1, antialiased as the colour', channels: ['A'] },
  line: { doc: 'the technical flat, antialiased: 0 on its lines, 1 on the paper', channels: ['Y'] },
});

const NAMES = Object.keys(LAYERS);
const EXPECTED = ['beauty', ...NAMES].map((name) => JSON.stringify(name)).join(', ');
const DOCS = Object.entries(LAYERS).map(([name, { doc }]) => `"${name}": ${doc}`);

export const layers = list(
  `Images to draw: "beauty", the colour, which is always there, and beside it ${DOCS.join('; ')}. Where nothing is seen they hold 0, "line" 1`,
  choice('', ['beauty', ...NAMES], { expected: EXPECTED }),
  `a list of ${EXPECTED}`,
  { default: ['beauty'], drawn: false },
);

/** Formats of the files of layers: bits a channel, the default first. */
export const LAYER_FORMATS = Object.freeze({ png: [16, 8], exr: [32, 16], raw: [32] });

export const layerOutput = object(
  'How layers are encoded',
  {
    format: choice('"png": whole numbers; "exr" and "raw": floats', Object.keys(LAYER_FORMATS), { name: 'Format', default: 'png' }),
    bitDepth: literal(
      'Bits a channel: png 16 or 8, exr 32 or 16 (numbers are 32 always), raw 32; default the first',
      [16, 8, 32],
      '8, 16 or 32 bits a channel',
      {
        unit: 'bits a channel',
        optional: true,
      },
    ),
    together: boolean('All in the one EXR file of the colour, as channels "depth.Z" and so on; needs format "exr" of both', { default: false }),
  },
  { name: 'LayerOutput', default: {} },
);
