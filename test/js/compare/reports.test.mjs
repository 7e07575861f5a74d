import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { build } from 'esbuild';
import { compareImages } from '../../../js/compare/compare.mjs';
import { judge } from '../../../js/compare/gates.mjs';
import { htmlReport } from '../../../js/compare/html_report.mjs';
import { junitReport } from '../../../js/compare/junit_report.mjs';
import { square, withPixel } from './support.mjs';

const comparison = compareImages(square(32), withPixel(square(32), 16, 16, [255, 0, 0, 255]));

test('JUnit: a case for each check, a failure for each that is over, names escaped', () => {
  const xml = junitReport([
    { name: '<a> & "b"\u0001', verdict: judge(comparison, 'parity') },
    { name: 'same', verdict: judge(compareImages(square(32), square(32)), 'exact') },
  ]);
  assert.match(xml, /^<\?xml version="1.0" encoding="UTF-8"\?>\n<testsuites>/);
  assert.match(xml, /<testsuite name="&#60;a&#62; &#38; &#34;b&#34;\ufffd \(parity\)" tests="3" failures="2">/);
  assert.match(xml, /name="interior max">\n +<failure message="155\/255, at most 2\/255"\/>/);
  assert.match(xml, /<testsuite name="same \(exact\)" tests="1" failures="0">\n +<testcase classname="same" name="frame max"\/>/);
  assert.equal(xml.match(/<testcase/g).length, 4);
});

test('HTML: the verdict, the pictures and every region', () => {
  const html = htmlReport(comparison, judge(comparison, 'parity'), { expected: 'e.png', actual: 'a.png', heatMap: 'h.png', title: '<shirt>' });
  assert.match(html, /<h1>&#60;shirt&#62;: over the gate &#34;parity&#34;<\/h1>/);
  assert.deepEqual(
    [...html.matchAll(/<img src="([^"]+)" alt="[^"]+"/g)].map(([, file]) => file),
    ['e.png', 'a.png', 'h.png'],
  );
  for (const region of ['frame', 'object', 'interior', 'edge']) assert.match(html, new RegExp(`<th scope="row">${region}</th>`));
  assert.doesNotMatch(html, /<script|https?:/, 'a page without a network');
});

test('a browser can bundle all but the reading of files', async () => {
  const folder = new URL('../../../js/compare/', import.meta.url);
  const modules = readdirSync(folder).filter((file) => file.endsWith('.mjs') && !['index.mjs', 'files.mjs'].includes(file));
  assert.ok(modules.length > 10);
  const contents = modules.map((file) => `import './${file}';`).join('\n');
  await build({ stdin: { contents, resolveDir: folder.pathname }, bundle: true, write: false, platform: 'browser', format: 'esm', logLevel: 'silent' });
});

test('the page of the documentation names each gate with its figures', () => {
  const page = readFileSync(new URL('../../../js/docs/compare.md', import.meta.url), 'utf8');
  for (const line of ['| `exact` |', '| `parity` |', '| `standard` |', '| `other-gl` |', '| `draft` |']) assert.ok(page.includes(line), line);
});
