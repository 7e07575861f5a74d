import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bestSwaps, closestRelease, rankedSwaps } from '../../../js/analyse/releases.mjs';
import { releaseHints } from '../../../js/cli/release_hint.mjs';
import { families, resolveThree, REVISION, termsOfRevision, THREE_SLOTS } from '../../../js/shot/three_terms.mjs';
import { TONE_MAPPINGS } from '../../../js/shot/table/tone_mappings.mjs';

// A renderer that differs by 1 for each slot that is not the client's, of those that the scene shows.

const everySlot = Object.keys(THREE_SLOTS);
const termsOf = (shading) =>
  shading === 'three' ? termsOfRevision(REVISION) : { ...resolveThree(shading), ...(resolveThree(shading) === 'three' && termsOfRevision(REVISION)) };

function clientOf(terms, shown = everySlot) {
  const drawn = [];
  const distanceOf = async (shading) => {
    drawn.push(shading);
    const own = termsOf(shading);
    return shown.filter((slot) => own[slot] !== terms[slot]).length;
  };
  return { drawn, distanceOf };
}

const toneMapping = 'aces';

test('each family is found among all, whichever the shot names', async () => {
  for (const { from, to } of families()) {
    const { distanceOf } = clientOf(termsOfRevision(to));
    const { best, isBetter, named } = await closestRelease('three', { toneMapping, distanceOf });
    assert.deepEqual(best, { from, to, distance: 0 });
    assert.equal(isBetter, to !== REVISION);
    assert.deepEqual([named.from, named.to], [REVISION, REVISION]);
  }
});

test('families that draw what is looked at alike are told as one', async () => {
  const { distanceOf } = clientOf(termsOfRevision(170), ['sheenEnergy']);
  const { best } = await closestRelease({ base: 'three', revision: 185 }, { toneMapping, distanceOf });
  assert.deepEqual(best, { from: 150, to: 181, distance: 0 });
});

test('a release is no better where it explains less than half, and none is drawn without the tone mapping', async () => {
  const client = { ...termsOfRevision(REVISION), dfg: 'karis', rectCoat: 'none' };
  const { distanceOf, drawn } = clientOf(client);
  const { isBetter } = await closestRelease('three', { toneMapping: 'neutral', distanceOf });
  assert.equal(isBetter, false);
  assert.ok(drawn.every(({ revision = REVISION }) => revision >= TONE_MAPPINGS.neutral.since));
});

test('a term of another family is named in every slot', async () => {
  for (const [slot, terms] of Object.entries(THREE_SLOTS)) {
    const { distanceOf } = clientOf(termsOfRevision(175));
    const wrong = Object.keys(terms).find((term) => term !== termsOfRevision(175)[slot]);
    const ranked = await rankedSwaps({ base: 'three', revision: 175, [slot]: wrong }, distanceOf);
    assert.deepEqual(bestSwaps(ranked), [{ slot, from: wrong, to: termsOfRevision(175)[slot], distance: 0 }]);
  }
});

test('no term is named where none explains the difference', async () => {
  const { distanceOf } = clientOf({ ...termsOfRevision(175), dfg: 'table-16', rectCoat: 'own-lobe', ior0: 'infinite' });
  assert.deepEqual(bestSwaps(await rankedSwaps({ base: 'three', revision: 175 }, distanceOf)), []);
});

/** Grey of as many 255ths as slots differ. */
async function hints(terms, shading, explain) {
  const { distanceOf } = clientOf(terms);
  const image = (grey) => ({ width: 1, height: 1, data: new Uint8Array([grey, grey, grey, 255]) });
  return releaseHints({ expected: image(0), shot: { shading, toneMapping }, draw: async (wanted) => image(await distanceOf(wanted)), explain });
}

test('the hint of telar compare names the release and tells what it cost', async () => {
  const [hint, ...more] = await hints(termsOfRevision(170), 'three');
  assert.deepEqual(more, []);
  assert.deepEqual([hint.cause, hint.from, hint.to], ['release', 167, 180]);
  assert.match(
    hint.message,
    /looks like three\.js 0\.167 to 0\.180: mean difference 0\/255, where it is \d+\/255 as three\.js 0\.187; .*three@180 \(.* \d+ drawn in \d/,
  );
  assert.deepEqual(await hints(termsOfRevision(REVISION), 'three'), []);
  assert.deepEqual(await hints(termsOfRevision(170), 'fabric'), []);
});

test('--explain names the term, of the release that fits', async () => {
  const [release, term] = await hints({ ...termsOfRevision(170), dfg: 'table-16' }, 'three', true);
  assert.equal(release.to, 180);
  assert.deepEqual(term.slots, [{ slot: 'dfg', term: 'table-16' }]);
  const [none, still] = await hints({ ...termsOfRevision(REVISION), dfg: 'karis' }, 'three', true);
  assert.match(none.message, /no other release/);
  assert.deepEqual(still.slots, [{ slot: 'dfg', term: 'karis' }]);
});
