import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import type { MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { cube, fingers, NOTHING, rounded, start, wall } from '../../../tests/support/place-kit.ts';
import { type Place, pointer, rayTo } from '../../../tests/support/pointer-kit.ts';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';

describe('objects/place', () => {
  test('hides the objects until a tap, and then places them where its ray meets the floor', () => {
    const { ctx, step, tap } = start();
    expect(step()).toEqual({ ...NOTHING, at: null, object: null });
    expect(tap([0.5, 0, -2])).toEqual({ ...NOTHING, at: [0.5, 0, -2], object: [0.5, 0, -2], placed: [1] });
    expect([ctx.outputs.isPlaced.value, ctx.outputs.scale.value]).toEqual([true, 1]);
    expect(step()).toEqual({ ...NOTHING, at: [0.5, 0, -2], object: [0.5, 0, -2] });
  });

  test('can show them before where they are in the graph', () => {
    const { step, tap } = start({ showBefore: true });
    expect(step()).toMatchObject({ at: null, object: [0, 0, 0] });
    expect(tap([0, 0, -2]).object).toEqual([0, 0, -2]);
  });

  test('brings the origin of the first to the tapped point, from wherever it stood before, and the others along', () => {
    const { ctx, step, tap, posture } = start({ showBefore: true });
    const [list] = ctx.inputs.objects as readonly ObjectList[];
    list?.items[0]?.worldFromObject
      .makeRotationY(0.5)
      .setPosition(-0.2, 0.42, -0.5)
      .scale(new Vector3(2, 2, 2));
    list?.items.push({ ...cube().items[0], key: 'lid', worldFromObject: new Matrix4().makeTranslation(-0.2, 0.92, -0.5) } as ObjectItem);
    if (list) list.version++;
    expect(step().object).toEqual([-0.2, 0.42, -0.5]);
    const atPoint = tap([0.5, 0, -2]);
    expect([atPoint.at, atPoint.object]).toEqual([
      [0.5, 0, -2],
      [0.5, 0, -2],
    ]);
    const lid = ctx.outputs.objects.items[1]?.worldFromObject.elements ?? [];
    expect(rounded(Array.from(lid).slice(12, 15))).toEqual([0.5, 0.5, -2]);
    expect(posture().scale).toBe(2);
  });

  test.each([
    ['once', [0, 0, -2], [1], 0],
    ['move', [1, 0, -3], [1], 1],
    ['replace', [1, 0, -3], [1, 2], 0],
  ] as const)('a second tap, with “%s”', (mode, at, placed, moved) => {
    const { tap } = start({ mode });
    const first = tap([0, 0, -2]);
    const second = tap([1, 0, -3], 2);
    expect([second.at, [...first.placed, ...second.placed], second.moved]).toEqual([at, placed, moved]);
  });

  test('ignores a drag beside the objects, a tap in the air, and a press of another node', () => {
    const { step, tap } = start();
    expect(tap([0, 3, -2]).at).toBe(null);
    expect(step(pointer(1, 'end', rayTo([0, 0, -2]), { tapped: false })).at).toBe(null);
    expect(step(pointer(2, 'end', rayTo([0, 0, -2]), { owner: {} })).at).toBe(null);
    tap([0, 0, -2]);
    const aside = pointer(3, 'start', rayTo([1, 0, -2]));
    step(aside);
    expect(aside.owner).toBe(null);
    step(pointer(3, 'hold', rayTo([1.5, 0, -2])));
    expect(step(pointer(3, 'end', rayTo([1.5, 0, -2]), { tapped: false })).at).toEqual([0, 0, -2]);
  });

  test('drags the objects to where the ray meets the floor, and claims the press', () => {
    const { ctx, step, tap } = start();
    tap([0, 0, -2]);
    const press = pointer(2, 'start', rayTo([0, 0, -2]));
    expect(step(press).at).toEqual([0, 0, -2]);
    expect(press.owner).toBe(ctx);
    const mine = { owner: ctx };
    expect(step(pointer(2, 'hold', rayTo([0.4, 0, -2.5]), mine))).toEqual({ ...NOTHING, at: [0.4, 0, -2.5], object: [0.4, 0, -2.5] });
    expect(step(pointer(2, 'end', rayTo([0.5, 0, -3]), mine))).toMatchObject({ at: [0.5, 0, -3], placed: [], moved: 1 });
    expect(step()).toMatchObject({ at: [0.5, 0, -3], moved: 0 });
  });

  test('keeps the distance at which they were taken, on their body or beside them, and holds still while a hand trembles', () => {
    const { ctx, step, tap } = start();
    tap([0, 0, -2]);
    // 15 cm beside; the top of the cube hides a point of the floor farther away.
    for (const [id, from, to] of [
      [2, [0.15, 0, -2], [0.65, 0, -2]],
      [3, [0.5, 0.2, -2], [0.75, 0.2, -2]],
    ] as const) {
      step(pointer(id, 'start', rayTo(from)));
      const trembling = from.map((x, i) => x + (i === 0 ? 0.005 : 0)) as unknown as Place;
      expect(step(pointer(id, 'hold', rayTo(trembling), { owner: ctx })).at?.[2]).toBe(-2);
      step(pointer(id, 'end', rayTo(to), { owner: ctx }));
    }
    // A ray 0.25 m aside at a height of 0.2 m meets the floor 0.25 · 1.6 / 1.4 m aside.
    expect(step().at).toEqual(rounded([0.5 + (0.25 * 1.6) / 1.4, 0, -2]));
  });

  test('a tap on the objects does nothing, and a canceled drag is undone', () => {
    const { ctx, step, tap } = start();
    tap([0, 0, -2]);
    expect(tap([0, 0.1, -2], 2)).toMatchObject({ at: [0, 0, -2], moved: 0 });
    step(pointer(3, 'start', rayTo([0, 0, -2])));
    expect(step(pointer(3, 'hold', rayTo([1, 0, -2]), { owner: ctx })).at).toEqual([1, 0, -2]);
    expect(step(pointer(3, 'cancel', rayTo([1, 0, -2]), { owner: ctx }))).toMatchObject({ at: [0, 0, -2], moved: 0 });
  });

  test('leaves gestures alone where they are off', () => {
    const { step, tap } = start({ gestures: false });
    tap([0, 0, -2]);
    const press = pointer(2, 'start', rayTo([0, 0, -2]));
    step(press);
    expect(press.owner).toBe(null);
    expect(tap([0.1, 0, -2], 3).at).toEqual([0.1, 0, -2]);
  });

  test('a pinch scales within limits, and a twist rotates counterclockwise about the normal', () => {
    const { step, tap, posture } = start({ maxScale: 2, minScale: 0.5, nearM: 1 });
    tap([0, 0, -2]);
    expect(posture()).toEqual({ turnDeg: 0, scale: 1 });
    step(...fingers('start', 0.2, 0));
    step(...fingers('hold', 0.3, 0.5));
    expect(posture()).toEqual({ turnDeg: 28.6, scale: 1.5 });
    expect(step(...fingers('hold', 0.9, 0.5)).at).toEqual([0, 0, -2]);
    expect(posture().scale).toBe(2);
    step(...fingers('hold', 0.02, -0.2));
    expect(posture()).toEqual({ turnDeg: -11.5, scale: 0.5 });
    expect(step(...fingers('end', 0.02, -0.2))).toMatchObject({ at: [0, 0, -2], moved: 1 });
  });

  test('a twist goes in steps where there are some', () => {
    const { step, tap, posture } = start({ nearM: 1, snapRad: Math.PI / 4 });
    tap([0, 0, -2]);
    step(...fingers('start', 0.2, 0));
    step(...fingers('hold', 0.2, 0.3));
    expect(posture().turnDeg).toBe(0);
    step(...fingers('hold', 0.2, 0.5));
    expect(posture().turnDeg).toBe(45);
  });

  test('two hands scale and rotate by the line between them', () => {
    const { step, tap, posture } = start();
    tap([0, 0, -2]);
    const hands = (phase: 'start' | 'hold', halfM: number, turnRad: number) =>
      (['left-hand', 'right-hand'] as const).map((by, i) => {
        const side = i === 0 ? -halfM : halfM;
        return pointer(20 + i, phase, rayTo([0, 0.1, -2], [side * Math.cos(turnRad), 1, -0.5 - side * Math.sin(turnRad)]), { by });
      });
    step(...hands('start', 0.1, 0));
    step(...hands('hold', 0.2, 0.25));
    expect(posture()).toEqual({ turnDeg: 14.3, scale: 2 });
  });

  test('one finger that stays after a pinch drags on from where it is', () => {
    const { step, tap } = start({ nearM: 2 });
    tap([0, 0, -2]);
    step(...fingers('start', 0.2, 0));
    step(...fingers('hold', 0.2, 0.3));
    const [first, second] = fingers('hold', 0.2, 0.3) as [MutablePointer, MutablePointer];
    step(first, Object.assign(second, { phase: 'end' }));
    expect(step(first).at).toEqual([0, 0, -2]);
    first.worldFromRay.set(rayTo([1.5, 0, -1]));
    expect(step(first).at).not.toEqual([0, 0, -2]);
    expect(step(Object.assign(first, { phase: 'end' }))).toMatchObject({ moved: 1 });
  });

  test.each([
    ['floor', null],
    ['wall', [0, 1.5, -3]],
    ['any', [0, 1.5, -3]],
  ] as const)('stands on %s, when a tap meets a wall', (surfaces, at) => {
    const { ctx, tap } = start({ surfaces }, (frame) => Object.assign(frame, { surfaces: { planes: [wall()], meshes: [] } }));
    expect(tap([0, 1.5, -3]).at).toEqual(at);
    if (at) expect(rounded(ctx.outputs.pose.worldFromPose.slice(4, 7))).toEqual([0, 0, 1]);
  });

  test('a drag goes from the floor up a wall, and tilts the objects with it', () => {
    const { ctx, step, tap } = start({ surfaces: 'any' }, (frame) => Object.assign(frame, { surfaces: { planes: [wall()], meshes: [] } }));
    tap([0, 0, -2]);
    step(pointer(2, 'start', rayTo([0.1, 0, -2])));
    expect(step(pointer(2, 'hold', rayTo([1, 1, -3]), { owner: ctx })).at).toEqual([1, 1, -3]);
    expect(rounded(ctx.outputs.pose.worldFromPose.slice(4, 7))).toEqual([0, 0, 1]);
  });

  test('never stands below the floor', () => {
    const pit = { ...wall(), label: '', orientation: 'horizontal' as const };
    pit.worldFromSurface.set(new Matrix4().setPosition(0, -0.5, -2).elements);
    const { tap } = start({}, (frame) => Object.assign(frame, { surfaces: { planes: [pit], meshes: [] } }));
    expect(tap([0, -0.5, -2]).at).toEqual([0, 0, -2]);
  });

  test('follows its anchor, and leaves none behind', () => {
    const { anchors, spatial, node, ctx, step, tap } = start();
    tap([0, 0, -2]);
    anchors[0]?.worldFromAnchor.set(new Matrix4().makeRotationY(Math.PI / 2).setPosition(3, 0, 1).elements);
    expect(step().at).toEqual([3, 0, 1]);
    expect(tap([1, 0, -2], 2).at).toEqual([1, 0, -2]);
    step(pointer(3, 'start', rayTo([1, 0, -2])));
    step(pointer(3, 'hold', rayTo([0, 0, -2]), { owner: ctx }));
    expect(spatial.counts().anchors).toBe(0);
    step(pointer(3, 'end', rayTo([0, 0, -2]), { owner: ctx }));
    expect(anchors.map(({ state }) => state)).toEqual(['deleted', 'deleted', 'tracked']);
    node.dispose();
    expect(spatial.counts()).toEqual({ hitTests: 0, deviceSources: 0, anchors: 0 });
  });

  test('raises the jumps of its pose at re-centering and at a tap, not in a drag', () => {
    const { ctx, frame, step, tap } = start();
    tap([0, 0, -2]);
    const { jumps } = ctx.outputs.pose;
    step(pointer(2, 'start', rayTo([0, 0, -2])));
    step(pointer(2, 'end', rayTo([1, 0, -2]), { owner: ctx }));
    expect(ctx.outputs.pose.jumps).toBe(jumps);
    frame.jumps++;
    step();
    expect(ctx.outputs.pose.jumps).toBe(jumps + 1);
    tap([0, 0, -4], 3);
    expect(ctx.outputs.pose.jumps).toBe(jumps + 2);
  });

  test('ends the placement by a pulse, and places anew with the next tap', () => {
    const { remove, spatial, step, tap } = start();
    tap([0, 0, -2]);
    remove.emit();
    expect(step()).toEqual({ ...NOTHING, at: null, object: null, removed: 1 });
    expect(step().removed).toBe(0);
    remove.clear();
    expect(spatial.counts().anchors).toBe(0);
    expect(tap([1, 0, -2], 2)).toMatchObject({ at: [1, 0, -2], placed: [2] });
  });

  test('in the next session is not placed, or stands before the visitor as it did', () => {
    const seen = (nextSession: 'unplaced' | 'same-place') => {
      const { session, spatial, frame, step, tap } = start({ nextSession });
      tap([0.5, 0, -2]);
      session.sessions++;
      spatial.leaveSession();
      // Somewhere else, and looking along +x, downwards.
      const view = new Matrix4().makeRotationY(-Math.PI / 2).multiply(new Matrix4().makeRotationX(-0.7));
      frame.views[0]?.worldFromView.set(view.setPosition(10, 1.2, 10).elements);
      const { at, removed } = step();
      return { at, removed, anchors: spatial.counts().anchors };
    };
    expect(seen('unplaced')).toEqual({ at: null, removed: 1, anchors: 0 });
    expect(seen('same-place')).toEqual({ at: [12, 0, 10.5], removed: 0, anchors: 1 });
  });

  test('begins anew after a reset', () => {
    const { node, spatial, step, tap } = start();
    tap([0, 0, -2]);
    node.reset?.();
    expect(step()).toEqual({ ...NOTHING, at: null, object: null });
    expect(spatial.counts().anchors).toBe(0);
    expect(tap([0, 0, -2], 2).placed).toEqual([1]);
  });
});
