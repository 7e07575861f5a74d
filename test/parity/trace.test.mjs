// What a trace says of the values that it was given.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { QUANTITY_NAMES } from './quantities.mjs';
import { causeOf, compareTerm, traceText } from './trace.mjs';

/** Steps of a pixel where both sides have 0.5 everywhere, but for `changes` by name: [browser, telar]. */
const stepsOf = (changes = {}) =>
  QUANTITY_NAMES.map((name) =>
    compareTerm(
      name,
      ...(changes[name] ?? [
        [0.5, 0.5, 0.5],
        [0.5, 0.5, 0.5],
      ]),
    ),
  );

test('the first quantity that differs is the cause, not those that follow from it', () => {
  const { first, cause } = causeOf(
    stepsOf({
      radiance: [
        [1, 1, 1],
        [1, 1.1, 1],
      ],
      linear: [
        [1, 1, 1],
        [1, 2, 1],
      ],
    }),
  );
  assert.equal(first, 'radiance');
  assert.match(cause, /^radiance .* level of detail/);
});

test('rounding is no cause', () => {
  const { first, cause } = causeOf(
    stepsOf({
      radiance: [
        [100, 1, 1],
        [100.05, 1, 1],
      ],
      n: [
        [0, 0, 1],
        [0, 0.00005, 1],
      ],
    }),
  );
  assert.equal(first, null);
  assert.match(cause, /^nothing differs/);
});

test('light is judged by its own size, so that a wrong dark value counts', () => {
  assert.equal(compareTerm('linear', [0.001, 0.001, 0.001], [0.002, 0.001, 0.001]).differs, true);
  assert.equal(compareTerm('linear', [10, 0.001, 0.001], [10.001, 0.001, 0.001]).differs, false);
});

test('not a number on one side differs, on both it does not', () => {
  assert.equal(compareTerm('indirect', [NaN, 0, 0], [0, 0, 0]).differs, true);
  assert.equal(compareTerm('indirect', [0, 0, 0], [NaN, 0, 0]).differs, true);
  assert.equal(compareTerm('indirect', [NaN, 0, 0], [NaN, 0, 0]).differs, false);
});

test('a quantity that one side lacks is the cause, and says which side draws it', () => {
  const { first, cause } = causeOf(stepsOf({ n: [null, [0, 0, 1]] }));
  assert.equal(first, 'n');
  assert.match(cause, /^only telar draws/);
  assert.match(causeOf(QUANTITY_NAMES.map((name) => compareTerm(name, null, null))).cause, /^nothing is drawn/);
});

test('the table marks what differs and leaves out what neither side has', () => {
  const terms = stepsOf({
    n: [null, null],
    direct: [
      [1, 1, 1],
      [2, 1, 1],
    ],
  });
  const text = traceText({ pixel: [3, 4], terms, ...causeOf(terms) });
  assert.match(text, /^pixel 3 4$/m);
  assert.match(text, /^> direct .* 1\.00e\+0$/m);
  assert.doesNotMatch(text, /^. n /m);
});
