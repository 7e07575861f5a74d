import { layerOutput } from './layers.mjs';
import { boolean, choice, literal, number, object } from './rows.mjs';

/** Rows of `output`. */

/**
 * The encoders: endings of their files, media type, bits a channel that they hold, the default first, whether they hold ppi and an ICC profile, whether
 * they have transparency, and whether browsers (and js/compare's readImage) show them.
 */
export const FORMATS = Object.freeze({
  png: { extensions: ['.png'], mediaType: 'image/png', bitDepths: [8, 16], ppi: true, icc: true, alpha: true, shown: true },
  jpeg: { extensions: ['.jpg', '.jpeg'], mediaType: 'image/jpeg', bitDepths: [8], ppi: true, icc: true, alpha: false, shown: true },
  webp: { extensions: ['.webp'], mediaType: 'image/webp', bitDepths: [8], ppi: false, icc: false, alpha: true, shown: true },
  tiff: { extensions: ['.tif', '.tiff'], mediaType: 'image/tiff', bitDepths: [8, 16], ppi: true, icc: true, alpha: true, shown: false },
  exr: { extensions: ['.exr'], mediaType: 'image/x-exr', bitDepths: [16, 32], ppi: false, icc: false, alpha: true, shown: false },
  raw: { extensions: ['.raw'], mediaType: 'application/octet-stream', bitDepths: [8, 32], ppi: false, icc: false, alpha: true, shown: false },
});

/** Names of the formats that browsers show. */
export const SHOWN_FORMATS = Object.keys(FORMATS).filter((format) => FORMATS[format].shown);

export const output = object(
  'The encoded file',
  {
    format: choice('File format', Object.keys(FORMATS), { name: 'Format', default: 'png' }),
    quality: number('Quality of JPEG and WebP', { what: 'a whole number', unit: 'quality', min: 1, max: 100, integer: true, default: 90 }),
    alphaQuality: number('Quality of the transparency of WebP below quality 100; 100 = exact', {
      what: 'a whole number',
      unit: 'quality',
      min: 0,
      max: 100,
      integer: true,
      default: 100,
    }),
    effort: number(
      'Work of the encoder for a smaller file: 0 the fastest (png, tiff and exr are not compressed), 9 the smallest; lossy WebP alone has other pixels. ' +
        'jpeg is progressive from 5 on; raw has none',
      { what: 'a whole number', unit: 'effort', min: 0, max: 9, integer: true, default: 1 },
    ),
    bitDepth: literal(
      'Bits a channel: png and tiff 8 or 16, jpeg and webp 8, exr 16 or 32 (float), raw 8 or 32 (float); default the first',
      [8, 16, 32],
      '8, 16 or 32 bits a channel',
      { unit: 'bits a channel', optional: true },
    ),
    ppi: number('Pixels per inch written to the file; 0 = none', { unit: 'pixels per inch', min: 0, max: 65535, default: 0 }),
    icc: boolean('Embed an sRGB profile: png, tiff, jpeg', { default: false }),
    layers: layerOutput,
  },
  { name: 'Output', default: {} },
);
