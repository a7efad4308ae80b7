import { describe, expect, test } from '@jest/globals';
import { TEST_LIBRARY as library, readShader } from '../../tests/support/test-library.ts';
import { TestStudio } from '../../tests/support/test-studio.ts';
import { endStep, redo, undo } from './history.ts';

const studio = () => new TestStudio({ library, readShader }).add('sepia-aaaa', 'filter/sepia');

describe('history', () => {
  test('goes back and forth', () => {
    const made = studio().set('sepia-aaaa.amount', 0.5);
    const after = made.save();
    expect(made.undo().project.graphs.main?.nodes['sepia-aaaa']?.params).toEqual({});
    expect(made.redo().save()).toEqual(after);
    expect(made.undo().undo().project.graphs.main?.nodes).toEqual({});
    expect(undo(made.history, made.project)).toBeNull();
  });

  test('a change after an undo forgets what was undone', () => {
    const made = studio().set('sepia-aaaa.amount', 0.5).undo().set('sepia-aaaa.amount', 0.75);
    expect(redo(made.history, made.project)).toBeNull();
  });

  test('a refused command and one that changes nothing leave no step', () => {
    const made = studio();
    made.attempt((p) => ({ project: p, patches: [], inverse: [], diagnostics: [{ code: 'SCR018', severity: 'error', message: '' }] }));
    made.move('sepia-aaaa', 0, 0);
    expect(made.history.past).toHaveLength(1);
  });

  test('a drag is one step, and stays small', () => {
    const made = studio();
    const before = made.save();
    for (let i = 1; i <= 300; i++) made.move('sepia-aaaa', i, 2 * i, 'drag');
    expect(made.history.past).toHaveLength(2);
    expect(made.history.past[1]?.patches.length).toBeLessThan(5);
    const after = made.save();
    expect(made.undo().save()).toEqual(before);
    expect(made.redo().save()).toEqual(after);
    expect(made.project.layout.main?.nodes['sepia-aaaa']).toEqual({ x: 300, y: 600 });
  });

  test('a slider that comes back to its default within a drag undoes to where it began', () => {
    const made = studio().set('sepia-aaaa.amount', 0.5);
    const before = made.save();
    for (const value of [0.6, 1, 0.7, 0.9]) made.set('sepia-aaaa.amount', value, 'slide');
    const after = made.save();
    expect(made.undo().save()).toEqual(before);
    expect(made.redo().save()).toEqual(after);
  });

  test('a drag that has ended is not gone on with', () => {
    const made = studio().move('sepia-aaaa', 1, 1, 'drag');
    made.history = endStep(made.history);
    made.move('sepia-aaaa', 2, 2, 'drag');
    expect(made.history.past).toHaveLength(3);
  });

  test('says when the project is as it was saved', () => {
    const made = studio().set('sepia-aaaa.amount', 0.5);
    const saved = made.history.state;
    made.set('sepia-aaaa.amount', 0.6);
    expect(made.history.state).not.toBe(saved);
    expect(made.undo().history.state).toBe(saved);
    made.set('sepia-aaaa.amount', 0.6).set('sepia-aaaa.amount', 0.7);
    expect(made.undo().undo().history.state).toBe(saved);
  });

  test('keeps as many steps as it may', () => {
    const made = studio();
    made.history = { ...made.history, limit: 10 };
    for (let i = 0; i < 30; i++) made.move('sepia-aaaa', i + 1, 0);
    expect(made.history.past).toHaveLength(10);
  });
});
