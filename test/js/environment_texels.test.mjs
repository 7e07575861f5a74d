// The texels of environments equal, half by half, those of three.js' HDRLoader and EXRLoader.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { DataUtils } from 'three';
import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';
import { imageTool } from './image/image_tool.mjs';

const WIDTH = 256;
const HEIGHT = 64;

let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'telar-environment-'));
});
after(() => rmSync(folder, { recursive: true, force: true }));

/** Every red mantissa, in steps of four exponents 0..252; green and blue differ. */
function rgbeTexels(width) {
  const texels = Buffer.alloc(width * HEIGHT * 4);
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < width; x++) {
      texels.set([x & 255, (x * 7 + y) & 255, 255 - (x & 255), 4 * y], (y * width + x) * 4);
    }
  }
  return texels;
}

/** One row run-length encoded channel by channel: a run where four bytes agree, else literals. */
function encodeRow(row, width) {
  const out = [2, 2, width >> 8, width & 255];
  for (let c = 0; c < 4; c++) {
    const bytes = Array.from({ length: width }, (_, x) => row[x * 4 + c]);
    for (let x = 0; x < width; ) {
      let run = 1;
      while (run < 127 && x + run < width && bytes[x + run] === bytes[x]) run++;
      const literals = bytes.slice(x, x + Math.min(100, width - x));
      if (run >= 4) {
        out.push(128 + run, bytes[x]);
        x += run;
      } else {
        out.push(literals.length, ...literals);
        x += literals.length;
      }
    }
  }
  return Buffer.from(out);
}

function hdrFile(texels, width, { rle, header = '' }) {
  const size = `-Y ${HEIGHT} +X ${width}`;
  const head = Buffer.from(`#?RADIANCE\n# made by a test\n${header}FORMAT=32-bit_rle_rgbe\n\n${size}\n`);
  const rows = Array.from({ length: HEIGHT }, (_, y) => texels.subarray(y * width * 4, (y + 1) * width * 4));
  return Buffer.concat([head, ...(rle ? rows.map((row) => encodeRow(row, width)) : rows)]);
}

/** @returns {{width: number, height: number, rgb: number[]}} as telar reads it, row 0 on top. */
function readWithTelar(file) {
  const path = join(folder, 'map');
  writeFileSync(path, file);
  const out = execFileSync(imageTool(), ['environment', path], { maxBuffer: 1 << 28 });
  const floats = new Float32Array(out.buffer.slice(out.byteOffset + 8, out.byteOffset + out.length));
  return { width: out.readUInt32LE(0), height: out.readUInt32LE(4), rgb: floats.filter((_, i) => i % 4 !== 3) };
}

/** @returns as readWithTelar; three.js gives halves, EXRLoader with row 0 at the bottom. */
function readWithThree(Loader, file, bottomFirst) {
  const { width, height, data } = new Loader().parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.length));
  const rgb = new Float32Array(width * height * 3);
  for (let y = 0; y < height; y++) {
    const row = bottomFirst ? height - 1 - y : y;
    for (let i = 0; i < width * 3; i++) {
      rgb[y * width * 3 + i] = DataUtils.fromHalfFloat(data[(row * width + Math.floor(i / 3)) * 4 + (i % 3)]);
    }
  }
  return { width, height, rgb };
}

function assertSame(expected, actual) {
  assert.deepEqual([actual.width, actual.height], [expected.width, expected.height]);
  const different = expected.rgb.reduce((sum, v, i) => sum + (v !== actual.rgb[i]), 0);
  const first = expected.rgb.findIndex((v, i) => v !== actual.rgb[i]);
  assert.equal(different, 0, `value ${first}: three.js ${expected.rgb[first]}, telar ${actual.rgb[first]}`);
  assert.ok(new Set(expected.rgb).size > 1000, 'the file holds many different values');
}

for (const [name, width, options] of [
  ['run-length encoded', WIDTH, { rle: true }],
  ['flat', WIDTH, { rle: false }],
  ['of seven columns', 7, { rle: false }],
  ['with GAMMA and EXPOSURE', WIDTH, { rle: true, header: 'GAMMA=2.2\nEXPOSURE=2\n' }],
]) {
  test(`.hdr ${name}`, () => {
    const texels = width === 7 ? Buffer.from(rgbeTexels(WIDTH).subarray(0, 7 * HEIGHT * 4)) : rgbeTexels(width);
    if (width === 7) for (let i = 0; i < texels.length; i += 4) texels[i + 3] = 110 + ((i / 4) % 30);
    const file = hdrFile(texels, width, options);
    assertSame(readWithThree(HDRLoader, file, false), readWithTelar(file));
  });
}

for (const bits of [16, 32]) {
  test(`.exr of ${bits} bit`, () => {
    const values = new Float32Array(WIDTH * HEIGHT * 4);
    for (let i = 0; i < values.length; i++) values[i] = i % 4 === 3 ? 1 : 2 ** (((i * 37) % 9000) / 250 - 22) * 1.00003;
    const path = join(folder, 'frame');
    writeFileSync(path, Buffer.from(values.buffer));
    const file = execFileSync(imageTool(), ['encode', `frame=${path}`, `width=${WIDTH}`, `height=${HEIGHT}`, 'format=exr', `bits=${bits}`], {
      maxBuffer: 1 << 28,
    });
    assertSame(readWithThree(EXRLoader, file, true), readWithTelar(file));
  });
}
