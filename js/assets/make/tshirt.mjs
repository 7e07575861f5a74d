import sharp from 'sharp';
import { tshirtPattern } from './cloth/pattern.mjs';
import { wear } from './cloth/wear.mjs';
import { garmentSurfaces } from './cloth/surface.mjs';
import { cutPieces } from './cloth/pieces.mjs';
import { bakeOcclusion } from './cloth/occlusion.mjs';
import { drawAtlas, packCharts } from './cloth/atlas.mjs';
import { JERSEY, RIB, knitTile, stitchTile } from './textile/knit.mjs';
import { textileMaps } from './textile/maps.mjs';
import { writeGarment } from './glb.mjs';

const ATLAS_SIZE = 1024;
const TILE_SIZE = 1024;

const jpeg = (bytes, size, channels, quality) =>
  sharp(Buffer.from(bytes), { raw: { width: size, height: size, channels } }).jpeg({ quality, chromaSubsampling: '4:4:4' }).toBuffer();

async function encodeTextile(tile, options) {
  const maps = textileMaps(tile, options);
  return {
    base: await jpeg(maps.base, maps.size, 3, 82),
    normal: await jpeg(maps.normal, maps.size, 3, 88),
    surface: await jpeg(maps.surface, maps.size, 3, 80),
  };
}

/** Encoded maps per textile: what the cloth looks like within one tile of 20 mm. */
export async function makeTextiles() {
  const jersey = knitTile(JERSEY, TILE_SIZE, 101);
  return {
    jersey: await encodeTextile(jersey, { seed: 1 }),
    stitched: await encodeTextile(stitchTile(jersey), { seed: 2 }),
    rib: await encodeTextile(knitTile(RIB, TILE_SIZE, 103), { seed: 3 }),
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
  const occlusion = await jpeg(Uint8Array.from(atlas, (value) => Math.round(Math.min(1, value) * 255)), ATLAS_SIZE, 1, 88);
  return writeGarment({ pieces, atlasUv: uv, occlusion, textiles: await makeTextiles() });
}
