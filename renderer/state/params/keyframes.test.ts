import { describe, expect, test } from '@jest/globals';
import type { Track } from '../../../export/graph/project.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { endGesture, undo } from '../document/apply.ts';
import { nodeOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { editParam } from './edit-params.ts';
import { animatedParams, editAt, isAnimatable, keyAt, moveKey, removeKey, setEasing, setRepeat, toggleKey, valueAt } from './keyframes.ts';

/** A blur, whose radius is 4. */
async function blur() {
  const { editor } = await openTestEditor();
  const definition = editor.document.getState().library.definition('filter/gaussian-blur');
  const id = definition ? addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null) : null;
  if (id === null) throw new Error('The blur was not added.');
  editParam(editor, id, 'radius', 4);
  endGesture(editor);
  return { editor, id };
}

const trackOf = (editor: Editor): Track => {
  const [only] = animatedParams(editor.document.getState());
  if (!only) throw new Error('Nothing is animated.');
  return only.track;
};
const timesOf = (editor: Editor) => trackOf(editor).keys.map(({ timeS }) => timeS);

describe('keyframes', () => {
  test('begin with the value there is, and changing it later sets another', async () => {
    const { editor, id } = await blur();
    toggleKey(editor, id, 'radius', 1);
    editAt(editor, id, 'radius', 3, 8);
    expect(trackOf(editor)).toEqual({
      repeat: 'once',
      keys: [
        { timeS: 1, value: 4, easing: 'ease-in-out' },
        { timeS: 3, value: 8, easing: 'ease-in-out' },
      ],
    });
    expect(animatedParams(editor.document.getState())[0]?.label).toBe('Gaussian blur · Radius');
  });

  test('are dragged within those beside them, in one step', async () => {
    const { editor, id } = await blur();
    for (const timeS of [1, 2, 3]) toggleKey(editor, id, 'radius', timeS);
    const before = filesOf(editor);
    for (const timeS of [2.1, 2.5, 9]) moveKey(editor, id, 'radius', 1, timeS);
    endGesture(editor);
    const [first, moved, last] = timesOf(editor);
    expect([first, last]).toEqual([1, 3]);
    expect(moved).toBeLessThan(3);
    expect(moved).toBeGreaterThan(2.9);
    moveKey(editor, id, 'radius', 0, -5);
    expect(timesOf(editor)[0]).toBe(0);
    undo(editor);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('are taken away by the same button; the last leaves its value', async () => {
    const { editor, id } = await blur();
    toggleKey(editor, id, 'radius', 1);
    editAt(editor, id, 'radius', 2, 7);
    toggleKey(editor, id, 'radius', 1.001);
    expect(timesOf(editor)).toEqual([2]);
    removeKey(editor, id, 'radius', 0);
    expect(nodeOf(editor.document.getState(), id)?.params.radius).toEqual({ value: 7 });
  });

  test('go on as they are told, and keep that when their value changes', async () => {
    const { editor, id } = await blur();
    toggleKey(editor, id, 'radius', 0);
    setEasing(editor, id, 'radius', 0, 'step');
    setRepeat(editor, id, 'radius', 'mirror');
    editAt(editor, id, 'radius', 0, 9);
    expect(trackOf(editor)).toEqual({ repeat: 'mirror', keys: [{ timeS: 0, value: 9, easing: 'step' }] });
  });

  test('have handles that are dragged in one step', async () => {
    const { editor, id } = await blur();
    toggleKey(editor, id, 'radius', 0);
    for (const x of [0.2, 0.3, 0.4]) setEasing(editor, id, 'radius', 0, [x, 0, 0.5, 1.5]);
    endGesture(editor);
    expect(trackOf(editor).keys[0]?.easing).toEqual([0.4, 0, 0.5, 1.5]);
    undo(editor);
    expect(trackOf(editor).keys[0]?.easing).toBe('ease-in-out');
  });

  test('stand only where there is something between two values', async () => {
    const { editor } = await openTestEditor();
    const params = (type: string) => editor.document.getState().library.definition(type)?.params ?? {};
    const { positionM } = params('objects/transform');
    const { shadows, ambient } = params('layer/scene');
    expect([positionM, ambient, shadows].map((param) => param && isAnimatable(param))).toEqual([true, true, false]);
  });
});

const NUMBER = { type: 'number', stage: 'uniform', label: 'N', doc: '', default: 0 } as const;
const VECTOR = { type: 'vector3', stage: 'uniform', label: 'V', doc: '', default: [0, 0, 0] } as const;

describe('the value at a time', () => {
  const track = (more: Partial<Track> = {}): Track => ({
    repeat: 'once',
    keys: [
      { timeS: 1, value: 10, easing: 'linear' },
      { timeS: 3, value: 20, easing: 'ease-in-out' },
      { timeS: 4, value: 0, easing: 'linear' },
    ],
    ...more,
  });

  test('goes from key to key and rests at both ends', () => {
    expect([0, 1, 2, 3, 3.5, 4, 99].map((timeS) => valueAt(NUMBER, track(), timeS))).toEqual([10, 10, 15, 20, 10, 0, 0]);
  });

  test('begins anew, or turns round', () => {
    expect(valueAt(NUMBER, track({ repeat: 'loop' }), 5)).toBe(15);
    expect(valueAt(NUMBER, track({ repeat: 'mirror' }), 6)).toBe(15);
  });

  test('goes by handles beyond the keys, but never beyond what the param allows', () => {
    const back = track({
      keys: [
        { timeS: 0, value: 0, easing: [0.34, 1.56, 0.64, 1] },
        { timeS: 1, value: 10, easing: 'linear' },
      ],
    });
    expect(Number(valueAt(NUMBER, back, 0.5))).toBeGreaterThan(10.5);
    expect(valueAt({ ...NUMBER, max: 10 }, back, 0.5)).toBe(10);
  });

  test('of a vector is that of its parts', () => {
    const keys = [
      { timeS: 0, value: [0, 2, 4], easing: 'linear' as const },
      { timeS: 2, value: [2, 2, 0], easing: 'linear' as const },
    ];
    expect(valueAt(VECTOR, track({ keys }), 1)).toEqual([1, 2, 2]);
    expect(keyAt(track({ keys }), 2.004)).toBe(1);
    expect(keyAt(track({ keys }), 1)).toBe(-1);
  });
});
