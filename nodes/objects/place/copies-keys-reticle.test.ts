import { describe, expect, test } from '@jest/globals';
import { InstancedMesh, Matrix4, type Mesh, type MeshBasicMaterial } from 'three';
import type { MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import type { MutableFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fingers, rounded, start, wall } from '../../../tests/support/place-kit.ts';
import { EYES, pointer, rayTo } from '../../../tests/support/pointer-kit.ts';
import type { ObjectItem } from '../../kit/scene-lists.ts';

describe('objects/place', () => {
  describe('places one more per tap', () => {
    /** Where the copies stand, of instances or of items. */
    function copiesOf(items: readonly ObjectItem[]): number[][] {
      const matrix = new Matrix4();
      return items
        .filter(({ hidden }) => !hidden)
        .flatMap(({ root, worldFromObject }) => {
          const [instances] = root.children;
          if (!(instances instanceof InstancedMesh)) return [rounded(worldFromObject.elements.slice(12, 15))];
          return Array.from({ length: instances.count }, (_, i) => {
            instances.getMatrixAt(i, matrix);
            return rounded(matrix.elements.slice(12, 15));
          });
        });
    }

    test('up to the largest number, as instances of one item', () => {
      const { ctx, tap, step } = start({ mode: 'add', maxCopies: 2 });
      step();
      const { items } = ctx.outputs.objects;
      expect([items.length, copiesOf(items)]).toEqual([1, []]);
      expect(tap([0, 0, -2])).toMatchObject({ placed: [1], at: [0, 0, -2] });
      expect(tap([1, 0, -2], 2)).toMatchObject({ placed: [2], at: [1, 0, -2] });
      expect(tap([2, 0, -2], 3)).toMatchObject({ placed: [], at: [1, 0, -2] });
      expect(copiesOf(items)).toEqual([
        [0, 0, -2],
        [1, 0, -2],
      ]);
      expect([items.length, ctx.outputs.count.value]).toEqual([1, 2]);
    });

    test('a drag moves the copy under it alone, whose key stays', () => {
      const { ctx, tap, step } = start({ mode: 'add', maxCopies: 3 });
      for (const x of [0, 1, 2]) tap([x, 0, -2], x + 1);
      step(pointer(9, 'start', rayTo([1, 0, -2])));
      step(pointer(9, 'hold', rayTo([1, 0, -3]), { owner: ctx }));
      expect(step(pointer(9, 'end', rayTo([1, 0, -3]), { owner: ctx })).at).toEqual([1, 0, -3]);
      expect(ctx.outputs.moved.at(0).bodyKey).toBe(`${ctx.node}/1`);
      expect(copiesOf(ctx.outputs.objects.items)).toEqual([
        [0, 0, -2],
        [1, 0, -3],
        [2, 0, -2],
      ]);
    });

    test('a removed copy leaves the others, and the next tap gets its key', () => {
      const { ctx, tap, type, undo, step } = start({ mode: 'add', maxCopies: 3 });
      tap([0, 0, -2]);
      tap([1, 0, -2], 2);
      step(pointer(9, 'start', rayTo([0, 0, -2])));
      step(pointer(9, 'end', rayTo([0, 0, -2]), { owner: ctx }));
      expect(type('Delete')).toMatchObject({ removed: 1, at: [1, 0, -2] });
      expect(copiesOf(ctx.outputs.objects.items)).toEqual([[1, 0, -2]]);
      tap([0, 0, -4], 3);
      expect(copiesOf(ctx.outputs.objects.items)).toEqual([
        [0, 0, -4],
        [1, 0, -2],
      ]);
      undo.emit();
      undo.emit();
      step();
      expect(copiesOf(ctx.outputs.objects.items)).toEqual([
        [0, 0, -2],
        [1, 0, -2],
      ]);
    });

    test('transparent objects are one item per copy, whose keys stay', () => {
      const { ctx, tap, step } = start({ mode: 'add', maxCopies: 2 });
      for (const { items } of ctx.inputs.objects)
        for (const { root } of items) ((root as Mesh).material as MeshBasicMaterial).transparent = true;
      step();
      tap([0, 0, -2]);
      tap([1, 0, -2], 2);
      const { items } = ctx.outputs.objects;
      expect(items.map(({ key }) => key)).toEqual(['0/cube/0', '0/cube/1']);
      expect(copiesOf(items)).toEqual([
        [0, 0, -2],
        [1, 0, -2],
      ]);
    });
  });

  test('keeps what is not placed in the list, hidden, so that its materials are compiled before the first tap', () => {
    const { ctx, node } = start();
    node.prepare?.();
    expect(ctx.outputs.objects.items.map(({ key, hidden }) => [key, hidden])).toEqual([['0/cube/0', true]]);
  });

  test('undoes step by step: a drag, a move by a tap, a placement', () => {
    const { ctx, undo, step, tap } = start();
    const back = () => {
      undo.emit();
      const seen = step();
      undo.clear();
      return seen;
    };
    tap([0, 0, -2]);
    tap([1, 0, -2], 2);
    step(pointer(3, 'start', rayTo([1, 0, -2])));
    step(pointer(3, 'end', rayTo([1, 0, -3]), { owner: ctx }));
    expect(back()).toMatchObject({ at: [1, 0, -2], moved: 1 });
    expect(back()).toMatchObject({ at: [0, 0, -2], moved: 1 });
    expect(back()).toMatchObject({ at: null, object: null, removed: 1 });
    expect(back()).toMatchObject({ at: null, removed: 0 });
  });

  test('undoes a removal', () => {
    const { remove, undo, step, tap } = start();
    tap([0, 0, -2]);
    remove.emit();
    step();
    remove.clear();
    undo.emit();
    expect(step()).toMatchObject({ at: [0, 0, -2], placed: [1] });
  });

  test.each([
    ['ArrowLeft', {}, [-0.05, 0, -2]],
    ['ArrowUp', {}, [0, 0, -2.05]],
    ['ArrowRight', { shift: true }, [0.01, 0, -2]],
    ['ArrowDown', { shift: true }, [0, 0, -1.99]],
  ] as const)('key %s moves it as the viewer sees it', (key, more, at) => {
    const { type, tap } = start();
    expect(type(key, more)).toMatchObject({ at: null, moved: 0 });
    tap([0, 0, -2]);
    expect(type(key, more)).toMatchObject({ at, moved: 1 });
    expect(type('z', { control: true })).toMatchObject({ at: [0, 0, -2] });
  });

  test('on a wall, arrow up moves up', () => {
    const { type, tap } = start({ surfaces: 'any' }, (frame) => Object.assign(frame, { surfaces: { planes: [wall()], meshes: [] } }));
    tap([0, 1.5, -3]);
    expect(type('ArrowUp').at).toEqual([0, 1.55, -3]);
    expect(type('ArrowRight').at).toEqual([0.05, 1.55, -3]);
  });

  test('Q and E rotate, + and − scale within limits, X removes, Escape gives the keys back', () => {
    const { frame, type, tap, posture } = start({ maxScale: 1.2 });
    tap([0, 0, -2]);
    type('q');
    expect(posture()).toEqual({ turnDeg: 15, scale: 1 });
    type('e', { shift: true });
    expect(posture()).toEqual({ turnDeg: 14, scale: 1 });
    type('+');
    expect(posture().scale).toBe(1.1);
    type('+');
    type('+');
    expect(posture().scale).toBe(1.2);
    expect(type('x')).toMatchObject({ at: null, removed: 1 });
    expect(type('z', { control: true }).at).toEqual([0, 0, -2]);
    type('Escape');
    expect(frame.input.keyOwner).toBe(null);
    expect(type('ArrowUp').at).toEqual([0, 0, -2]);
  });

  test('Escape cancels a drag', () => {
    const { ctx, type, step, tap } = start();
    tap([0, 0, -2]);
    step(pointer(2, 'start', rayTo([0, 0, -2])));
    expect(step(pointer(2, 'hold', rayTo([1, 0, -2]), { owner: ctx })).at).toEqual([1, 0, -2]);
    expect(type('Escape')).toMatchObject({ at: [0, 0, -2], moved: 0 });
  });

  test('stands on the points of a grid, in taps, drags and by keys', () => {
    const { ctx, step, tap, type } = start({ gridM: 0.25 });
    expect(tap([0.3, 0, -2.1]).at).toEqual([0.25, 0, -2]);
    step(pointer(2, 'start', rayTo([0.25, 0, -2])));
    expect(step(pointer(2, 'hold', rayTo([0.6, 0, -2.2]), { owner: ctx })).at).toEqual([0.5, 0, -2.25]);
    expect(step(pointer(2, 'end', rayTo([0.6, 0, -2.2]), { owner: ctx })).at).toEqual([0.5, 0, -2.25]);
    expect(type('ArrowRight').at).toEqual([0.75, 0, -2.25]);
  });

  test('a grid on a wall is horizontal and vertical', () => {
    const planes = { surfaces: { planes: [wall()], meshes: [] } };
    const { tap } = start({ surfaces: 'any', gridM: 0.5 }, (frame) => Object.assign(frame, planes));
    expect(tap([0.7, 1.3, -3]).at).toEqual([0.5, 1.5, -3]);
  });

  test('a hand that is lost in a pinch or a drag cancels it', () => {
    const { ctx, step, tap, posture } = start({ nearM: 1 });
    tap([0, 0, -2]);
    step(...fingers('start', 0.2, 0));
    step(...fingers('hold', 0.3, 0.5));
    const [first] = fingers('hold', 0.3, 0.5) as [MutablePointer];
    expect(step(first)).toMatchObject({ at: [0, 0, -2], moved: 0 });
    expect(posture()).toEqual({ turnDeg: 0, scale: 1 });
    step(pointer(3, 'start', rayTo([0, 0, -2]), { by: 'right-hand' }));
    expect(step(pointer(3, 'hold', rayTo([1, 0, -2]), { by: 'right-hand', owner: ctx })).at).toEqual([1, 0, -2]);
    expect(step()).toMatchObject({ at: [0, 0, -2], moved: 0 });
  });

  test('ignores rays that are no poses, and frames without a view', () => {
    const { frame, ctx, step, tap } = start({ reticle: true });
    for (const bad of [Number.NaN, 0, Number.POSITIVE_INFINITY]) {
      const press = pointer(1, 'start', new Array(16).fill(bad));
      step(press);
      expect(step(Object.assign(press, { phase: 'end', tapped: true }))).toMatchObject({ at: null, placed: [] });
    }
    tap([0, 0, -2]);
    for (const bad of [Number.NaN, 0]) {
      step(pointer(4, 'start', new Array(16).fill(bad)));
      step(pointer(5, 'start', rayTo([0, 0, -2])));
      expect(step(pointer(5, 'hold', new Array(16).fill(bad), { owner: ctx })).at).toEqual([0, 0, -2]);
      step(pointer(5, 'cancel', new Array(16).fill(bad), { owner: ctx }));
    }
    frame.viewCount = 0;
    expect(step().at).toEqual([0, 0, -2]);
  });

  describe('reticle', () => {
    const shownOf = (items: readonly ObjectItem[]) => items.filter(({ hidden }) => !hidden).map(({ key }) => key);
    const look = (frame: MutableFrame, pitchRad: number) => {
      const view = new Matrix4().makeRotationX(pitchRad).setPosition(...EYES);
      frame.views[0]?.worldFromView.set(view.elements);
      frame.views[0]?.viewFromWorld.set(view.invert().elements);
    };

    test('lies where the view meets the floor, until all copies are placed', () => {
      const { ctx, frame, step, tap } = start({ reticle: true, mode: 'add', maxCopies: 2 });
      look(frame, -Math.atan(1.6 / 2));
      step();
      const { items } = ctx.outputs.objects;
      expect(shownOf(items)).toEqual(['reticle']);
      const ring = items.find(({ key }) => key === 'reticle');
      expect(rounded(ring?.worldFromObject.elements.slice(12, 15) ?? [])).toEqual([0, expect.closeTo(0.01, 2), -2]);
      tap([0, 0, -2]);
      expect(shownOf(items)).toEqual(['0/cube', 'reticle']);
      tap([1, 0, -2], 2);
      expect(shownOf(items)).toEqual(['0/cube']);
    });

    test('shows arcs before the visitor while there is no surface, and follows the mouse where one hovers', () => {
      const { ctx, frame, step } = start({ reticle: true });
      look(frame, 0.2);
      step();
      const { items } = ctx.outputs.objects;
      expect(shownOf(items)).toEqual(['reticle-searching']);
      step(pointer(1, 'hover', rayTo([0.5, 0, -1]), { by: 'mouse' }));
      expect(shownOf(items)).toEqual(['reticle']);
      const ring = items.find(({ key }) => key === 'reticle');
      expect(rounded(ring?.worldFromObject.elements.slice(12, 15) ?? [])).toEqual([0.5, expect.closeTo(0.01, 2), -1]);
    });
  });
});
