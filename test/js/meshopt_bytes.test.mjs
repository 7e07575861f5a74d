// meshopt buffer views decompress to the bytes that three.js's own decoder gives, for every mode and filter.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { MeshoptEncoder } from 'meshoptimizer';
import { MeshoptDecoder } from '../../node_modules/three/examples/jsm/libs/meshopt_decoder.module.js';
import { compressViews } from '../fixtures/meshopt.mjs';
import { addView, glb, quad } from '../robust/glb.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const TOOL = join(resolve(ROOT, process.env.TELAR_BUILD_DIR ?? 'out/dev'), 'bin/view_tool');

let folder;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'telar-meshopt-'));
  await MeshoptDecoder.ready;
});
after(() => rmSync(folder, { recursive: true, force: true }));

/** Both decoders on one compressed view. */
function checkView(spec, extension) {
  const model = quad();
  const view = addView(model, Buffer.alloc(spec.count * spec.stride));
  compressViews(model, [{ ...spec, view }], { extension });
  const { byteOffset, byteLength } = model.doc.bufferViews[view].extensions[extension];
  const expected = new Uint8Array(spec.count * spec.stride);
  MeshoptDecoder.decodeGltfBuffer(
    expected,
    spec.count,
    spec.stride,
    new Uint8Array(model.bin.subarray(byteOffset, byteOffset + byteLength)),
    spec.mode,
    spec.filter,
  );
  const file = join(folder, 'model.glb');
  writeFileSync(file, glb(model));
  const all = execFileSync(TOOL, [file], { maxBuffer: 64 << 20 });
  assert.deepEqual(new Uint8Array(all.subarray(all.length - expected.length)), expected, `${spec.mode} ${spec.filter} x${spec.count} /${spec.stride}`);
  return expected;
}

const bytes = (length, step) => Uint8Array.from({ length }, (_, i) => ((i * step) >> 3) + (i % 5 === 0 ? i : 0));
const units = (count) =>
  Float32Array.from({ length: count * 4 }, (_, i) => {
    const t = (i >> 2) * 0.7;
    return [Math.sin(t) * Math.cos(3 * t), Math.sin(t) * Math.sin(3 * t), Math.cos(t), i % 8 === 3 ? 1 : -1][i % 4];
  });

for (const extension of ['EXT_meshopt_compression', 'KHR_meshopt_compression']) {
  test(`${extension}: attributes`, () => {
    for (const stride of [4, 8, 12, 16, 20, 48, 256]) {
      for (const count of [1, 15, 16, 17, 256, 257, 1000]) {
        checkView({ count, stride, mode: 'ATTRIBUTES', filtered: bytes(count * stride, stride + 3) }, extension);
      }
    }
  });

  test(`${extension}: indices`, () => {
    for (const stride of [2, 4]) {
      for (const count of [3, 48, 3000]) {
        const list = Uint32Array.from({ length: count }, (_, i) => [i / 3, i / 3 + 1, i / 3 + 7][i % 3] % 60_000);
        const filtered = new Uint8Array((stride === 2 ? Uint16Array.from(list) : list).buffer);
        assert.deepEqual([...checkView({ count, stride, mode: 'INDICES', filtered }, extension)], [...filtered]);
        checkView({ count, stride, mode: 'TRIANGLES', filtered }, extension);
      }
    }
  });

  test(`${extension}: filters`, () => {
    const count = 301;
    for (const stride of [4, 8]) {
      const bits = stride === 4 ? 8 : 12;
      checkView(
        { count, stride, mode: 'ATTRIBUTES', filter: 'OCTAHEDRAL', filtered: MeshoptEncoder.encodeFilterOct(units(count), count, stride, bits) },
        extension,
      );
    }
    const unit = units(count).map((value, i, all) => value / Math.hypot(...all.subarray(i & ~3, (i & ~3) + 4)));
    checkView({ count, stride: 8, mode: 'ATTRIBUTES', filter: 'QUATERNION', filtered: MeshoptEncoder.encodeFilterQuat(unit, count, 8, 14) }, extension);
    for (const stride of [4, 12, 16]) {
      const values = Float32Array.from({ length: (count * stride) / 4 }, (_, i) => Math.sin(i) * 10 ** ((i % 9) - 4));
      checkView({ count, stride, mode: 'ATTRIBUTES', filter: 'EXPONENTIAL', filtered: MeshoptEncoder.encodeFilterExp(values, count, stride, 15) }, extension);
    }
  });
}
