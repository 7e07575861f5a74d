import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SpecState, nearestView, nextCode, rounded } from '../../../js/view/page/spec_state.mjs';

const stateOf = () => new SpecState({ callouts: [{ text: 'a' }], measures: [{ code: 'A', description: 'x', tolerance: 1 }] });

test('each step is undone and done again, in order', () => {
  const state = stateOf();
  const seen = [state.lists];
  const steps = [
    () => state.add('callouts', { text: 'b' }),
    () => state.edit('measures', 0, { code: 'B', tolerance: undefined }),
    () => state.remove('callouts', 0),
  ];
  for (const step of steps) {
    step();
    seen.push(state.lists);
  }
  assert.deepEqual(state.lists, { callouts: [{ text: 'b' }], measures: [{ code: 'B', description: 'x' }] });
  for (const lists of seen.slice(0, -1).reverse()) {
    state.undo();
    assert.deepEqual(state.lists, lists);
  }
  assert.deepEqual([state.canUndo, state.canRedo, state.isEdited], [false, true, false]);
  for (const lists of seen.slice(1)) {
    state.redo();
    assert.deepEqual(state.lists, lists);
  }
  assert.deepEqual([state.canUndo, state.canRedo, state.isEdited], [true, false, true]);
});

test('a step after an undo forgets what was undone; an edit that changes nothing is no step', () => {
  const state = stateOf();
  state.add('callouts', { text: 'b' });
  state.undo();
  state.add('callouts', { text: 'c' });
  assert.equal(state.canRedo, false);
  let changes = 0;
  state.addEventListener('change', () => changes++);
  state.edit('callouts', 1, { text: 'c', side: undefined });
  state.redo();
  assert.equal(changes, 0);
});

test('rows that were handed in are never changed', () => {
  const given = Object.freeze({ callouts: Object.freeze([]), measures: Object.freeze([Object.freeze({ code: 'A' })]) });
  const state = new SpecState(given);
  state.edit('measures', 0, { code: 'B' });
  state.add('callouts', { text: 'n' });
  state.remove('measures', 0);
  assert.deepEqual(given, { callouts: [], measures: [{ code: 'A' }] });
  assert.deepEqual(state.lists, { callouts: [{ text: 'n' }], measures: [] });
});

test('what was saved is no edit; an undo of it is one', () => {
  const state = stateOf();
  state.add('callouts', { text: 'b' });
  state.markSaved(state.lists);
  assert.equal(state.isEdited, false);
  state.undo();
  assert.equal(state.isEdited, true);
  state.redo();
  assert.equal(state.isEdited, false);
});

test('codes go through the letters, then again with a number', () => {
  assert.equal(nextCode([]), 'A');
  assert.equal(nextCode([{ code: 'A' }, { code: 'C' }]), 'B');
  const letters = [...'ABCDEFGHIJKLMNOPQRSTUVWXYZ'].map((code) => ({ code }));
  assert.equal(nextCode(letters), 'A2');
  assert.equal(nextCode([...letters, { code: 'A2' }]), 'B2');
});

test('a row belongs to the view that looks most as the camera does, the first of equal ones', () => {
  const views = [
    { name: 'front', back: [0, 0, 1] },
    { name: 'flat', back: [0, 0, 1] },
    { name: 'back', back: [0, 0, -1] },
    { name: 'side', back: [1, 0, 0] },
  ];
  assert.equal(nearestView(views, [0.3, 0.2, 0.9]), 'front');
  assert.equal(nearestView(views, [0.3, 0.2, -0.9]), 'back');
  assert.equal(nearestView(views, [0.9, 0, 0.3]), 'side');
});

test('points are kept to a hundredth of a millimetre, without a negative zero', () => {
  assert.deepEqual(rounded([0.123456789, -0.0000001, -1.000006]), [0.12346, 0, -1.00001]);
});
