// The page that draws with a release, on the three.js of the development dependencies: its build, its sources, and an edit of them.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { Browser } from '../parity/browser/chromium.mjs';
import { loadInputs } from '../parity/inputs.mjs';
import { CASES } from './cases.mjs';
import { editedFiles } from './edits.mjs';
import { BORDERS } from './slots.mjs';

const THREE = fileURLToPath(new URL('../../node_modules/three/', import.meta.url));

/** The first, whose Chromium the others share. */
let first;
after(() => first?.close());

async function drawn(edited, names) {
  const page = `test/families/browser/page.html?three=${edited ? 'src/Three.js' : 'build/three.module.js'}`;
  const asked = { three: THREE, edited, page };
  const browser = first ? await first.another(asked) : await Browser.start(asked);
  first ??= browser;
  try {
    const images = {};
    for (const item of CASES.filter(({ name }) => names.includes(name))) {
      images[item.name] = Buffer.from((await browser.draw({ shot: item.shot, settings: item.settings, ...(await loadInputs(item)) })).image);
    }
    return images;
  } finally {
    if (browser !== first) await browser.close();
  }
}

test('sources draw as the build does, an older term differently, and only where it stands', async () => {
  const { newer, slots } = BORDERS.at(-1);
  const { edits } = slots.find(({ slot }) => slot === 'least roughness');
  const names = ['clearcoat-sun', 'unlit'];
  const [build, sources, older] = [
    await drawn(undefined, names),
    await drawn(new Map(), names),
    await drawn(
      editedFiles(newer, edits, () => THREE),
      names,
    ),
  ];
  assert.ok(build['clearcoat-sun'].some((value) => value > 0));
  for (const name of names) assert.ok(build[name].equals(sources[name]), name);
  assert.ok(!older['clearcoat-sun'].equals(build['clearcoat-sun']));
  assert.ok(older.unlit.equals(build.unlit));
});
