// Where a pass reads the maps of sheer cloth: each pass has a cell of the pixel, and each pixel has a place of its own in it. Threads finer
// than the cells would beat with places that all pixels share: rings as of a fingerprint, which both halves of the passes show. At places
// of their own pixels have noise instead, which the halves tell and denoising takes out. The places of a pixel lie in as many columns, and
// in as many rows, as there are passes.
// src: Chiu, Shirley & Wang 1994, "Multi-Jittered Sampling", Graphics Gems IV
uniform int samplePass;
uniform int cellsAcross;   // cells in a row of a pixel, a power of two (renderer/frame/sample_passes.h)
uniform vec2 cell;         // of this pass, column and row
uniform vec2 shiftInCell;  // of this pass's picture, from the middle of the cell, pixels

vec2 placeInCell(vec2 uv) {
  uvec2 pixel = uvec2(pixelCentre());
  uint ofPixel = mixedBits(pixel.x | (pixel.y << 16));
  uint ofPass = mixedBits(ofPixel ^ uint(samplePass));
  uvec2 order = uvec2(ofPixel, ofPixel >> 16) & uint(cellsAcross - 1);
  vec2 part = vec2(uvec2(cell.yx) ^ order) + vec2(ofPass & 0xffffu, ofPass >> 16) / 65536.0;
  float size = 1.0 / float(cellsAcross);
  vec2 moved = shiftInCell + size * (size * part - 0.5);
  return uv + moved.x * dFdx(uv) + moved.y * dFdy(uv);
}
