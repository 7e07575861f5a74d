import sharp from 'sharp';
import { tshirtPattern } from './cloth/pattern.mjs';
import { wear } from './cloth/wear.mjs';
import { garmentSurfaces } from './cloth/surface.mjs';
import { cutPieces } from './cloth/pieces.mjs';
import { bakeOcclusion } from './cloth/occlusion.mjs';
import { drawAtlas, packCharts } from './cloth/atlas.mjs';
import { JERSEY, RIB, TILE, knitTile, stitchTile } from './textile/knit.mjs';
import { LABEL, drawLabel } from './textile/label.mjs';
import { textileMaps } from './textile/maps.mjs';
import { writeGarment } from './glb.mjs';

const ATLAS_SIZE = 1024;
const TILE_SIZE = 1024;

const jpeg = ({ pixels, width, height = width, channels = 3 }, quality) =>
  sharp(Buffer.from(pixels), { raw: { width, height, channels } })
    .toColourspace(channels === 1 ? 'b-w' : 'srgb')
    .jpeg({ quality, chromaSubsampling: '4:4:4' })
    .toBuffer();

async function encodeTextile(tile, seed) {
  const { size: width, surfaceSize, ...maps } = textileMaps(tile, { seed });
  return {
    base: await jpeg({ pixels: maps.base, width }, 82),
    normal: await jpeg({ pixels: maps.normal, width }, 86),
    surface: await jpeg({ pixels: maps.surface, width: surfaceSize }, 82),
    extent: [TILE, TILE],
    dyed: true,
  };
}

/**
 * JPEG maps per textile. `extent` is what one repeat covers, in metres; `dyed` textiles take the
 * colourway's factor.
 */
export async function makeTextiles() {
  const jersey = knitTile(JERSEY, TILE_SIZE, 101);
  return {
    jersey: await encodeTextile(jersey, 1),
    stitched: await encodeTextile(stitchTile(jersey), 2),
    rib: await encodeTextile(knitTile(RIB, TILE_SIZE, 103), 3),
    label: { base: await jpeg(drawLabel(), 85), extent: [LABEL.width, LABEL.height], dyed: false },
  };
}

// The lowest point of the hem at y = 0, the garment's middle at x = z = 0.
function standOnOrigin(pieces) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const { positions } of pieces) {
    positions.forEach((value, i) => {
      low[i % 3] = Math.min(low[i % 3], value);
      high[i % 3] = Math.max(high[i % 3], value);
    });
  }
  const shift = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2];
  return pieces.map((piece) => ({ ...piece, positions: piece.positions.map((value, i) => value - shift[i % 3]) }));
}

/** @returns {Promise<Uint8Array>} The bundled T-shirt as GLB. */
export async function makeTshirt() {
  const pattern = tshirtPattern();
  const { garment, positions } = wear(pattern);
  const pieces = standOnOrigin(cutPieces(pattern, garment, garmentSurfaces(garment, positions)));
  const { uv } = packCharts(pieces, ATLAS_SIZE);
  const atlas = drawAtlas(pieces, uv, bakeOcclusion(pieces), ATLAS_SIZE);
  const occlusion = await jpeg({ pixels: Uint8Array.from(atlas, (value) => Math.round(Math.min(1, value) * 255)), width: ATLAS_SIZE, channels: 1 }, 88);
  return writeGarment({ pieces, atlasUv: uv, occlusion, textiles: await makeTextiles() });
}
