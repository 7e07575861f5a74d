/**
 * Write linear radiance as a Radiance picture (.hdr): shared exponent, run-length coded.
 * @param {Float64Array} radiance - Linear-sRGB, RGB triplets, row 0 = +Y, length width * height * 3.
 * @param {number} width - Pixels, 8..32767 (the range in which the run-length form is defined).
 * @param {number} height - Pixels, >= 1.
 * @returns {Buffer} The whole file.
 * @throws {RangeError} Width outside of 8..32767.
 */
export function encodeRgbe(radiance, width, height) {
  if (width < 8 || width > 32767) throw new RangeError(`Expected a width in 8..32767 but received ${width}`);
  const parts = [Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`, 'latin1')];
  const planes = [0, 1, 2, 3].map(() => new Uint8Array(width));
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) packTexel(radiance, (y * width + x) * 3, planes, x);
    parts.push(Buffer.from([2, 2, width >> 8, width & 255]));
    for (const plane of planes) parts.push(runLengths(plane));
  }
  return Buffer.concat(parts);
}

function packTexel(radiance, at, planes, x) {
  const peak = Math.max(radiance[at], radiance[at + 1], radiance[at + 2]);
  const exponent = peak < 1e-32 ? -128 : Math.floor(Math.log2(peak)) + 1;
  // Rounding to nearest may carry the peak to 256; then the next exponent holds it.
  const carry = exponent > -128 && Math.round((peak * 256) / 2 ** exponent) > 255 ? 1 : 0;
  const scale = exponent === -128 ? 0 : 256 / 2 ** (exponent + carry);
  for (let c = 0; c < 3; c++) planes[c][x] = Math.round(radiance[at + c] * scale);
  planes[3][x] = exponent + carry + 128;
}

function runLengths(plane) {
  const out = [];
  let at = 0;
  while (at < plane.length) {
    const run = runAt(plane, at);
    if (run >= 3) {
      out.push(128 + run, plane[at]);
      at += run;
      continue;
    }
    const start = at;
    while (at < plane.length && at - start < 128 && runAt(plane, at) < 3) at++;
    out.push(at - start, ...plane.subarray(start, at));
  }
  return Buffer.from(out);
}

function runAt(plane, at) {
  let end = at + 1;
  while (end < plane.length && end - at < 127 && plane[end] === plane[at]) end++;
  return end - at;
}
