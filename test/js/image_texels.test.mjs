// The texels that telar decodes equal those that Chromium hands to WebGL, file by file.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { imageCorpus } from './image/image_corpus.mjs';
import { imageTool } from './image/image_tool.mjs';

const FLAGS = [
  '--headless=new',
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-gl=angle',
  '--use-angle=gl-egl',
  '--ignore-gpu-blocklist',
];
const CHROMIUM = process.env.TELAR_CHROMIUM ?? '/usr/bin/chromium';

/** Runs in the page: the image as three.js' GLTFLoader uploads it, read back. */
async function texelsInBrowser(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes]), { premultiplyAlpha: 'none', colorSpaceConversion: 'none' });
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const { width, height } = bitmap;
  const pixels = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  if (gl.getError()) throw new Error('WebGL error');
  return { width, height, pixels: btoa(Array.from(pixels, (b) => String.fromCharCode(b)).join('')) };
}

/** First texel that differs, for the message. */
function firstDifference(expected, actual, width) {
  let count = 0,
    max = 0,
    first = -1;
  for (let i = 0; i < expected.length; i++) {
    const d = Math.abs(expected[i] - actual[i]);
    if (d && first < 0) first = i;
    if (d) count++;
    max = Math.max(max, d);
  }
  const texel = first >> 2;
  const at = (bytes) => [...bytes.subarray(texel * 4, texel * 4 + 4)];
  return first < 0
    ? ''
    : `${count} of ${expected.length} bytes differ by up to ${max}; first at x ${texel % width}, ` +
        `y ${Math.floor(texel / width)}: browser ${at(expected)}, telar ${at(actual)}`;
}

let folder, browser, page;
before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'telar-texels-'));
  browser = await chromium.launch({ executablePath: CHROMIUM, args: FLAGS, ignoreDefaultArgs: ['--headless'] });
  page = await browser.newPage();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

test('decoded texels equal what Chromium uploads to WebGL', async (t) => {
  const tool = imageTool();
  for (const [name, file] of await imageCorpus()) {
    await t.test(name, async () => {
      const path = join(folder, 'image');
      writeFileSync(path, file);
      const expected = await page.evaluate(texelsInBrowser, file.toString('base64'));
      const actual = execFileSync(tool, ['decode', path], { maxBuffer: 1 << 28 });
      const [width, height] = [actual.readUInt32LE(0), actual.readUInt32LE(4)];
      assert.deepEqual([width, height], [expected.width, expected.height], 'size');
      assert.equal(firstDifference(Buffer.from(expected.pixels, 'base64'), actual.subarray(8), width), '');
    });
  }
});
