import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { addPointer, createPointer, type MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { createSessionFrame, type MutableFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import type { Anchor } from '../../kit/anchors.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;
type Place = readonly [x: number, y: number, z: number];

const EYES: Place = [0, 1.6, 0];

/** From the eyes, or from a place, to a place. */
function rayTo(to: Place, from: Place = EYES): number[] {
  const origin = new Vector3(...from);
  return new Matrix4().lookAt(origin, new Vector3(...to), new Vector3(0, 1, 0.001)).setPosition(origin).elements;
}

function pointer(id: number, phase: MutablePointer['phase'], ray: readonly number[], more: Partial<MutablePointer> = {}): MutablePointer {
  const made = Object.assign(createPointer(), { id, phase, tapped: phase === 'end', ...more });
  made.worldFromRay.set(ray);
  return made;
}

const rounded = (place: ArrayLike<number>) => Array.from(place, (x) => Math.round(x * 1e4) / 1e4 + 0);

/** A cube of 20 cm on the floor, 5 m behind the visitor until it is placed. */
function cube(): ObjectList {
  const root = new Mesh(new BoxGeometry(0.2, 0.2, 0.2).translate(0, 0.1, 0), new MeshBasicMaterial());
  const item = { key: 'cube', root, role: 'virtual' as const, castsShadow: true, receivesShadow: true };
  return { version: 1, items: [{ ...item, worldFromObject: new Matrix4() }] };
}

/** A wall at z = -3, 4 m wide and high. */
function wall() {
  const worldFromSurface = new Float32Array(new Matrix4().makeRotationX(Math.PI / 2).setPosition(0, 2, -3).elements);
  const outlineXZ = Float32Array.of(-2, -2, 2, -2, 2, 2, -2, 2);
  return { id: 'wall', version: 1, label: 'wall', worldFromSurface, orientation: 'vertical' as const, outlineXZ };
}

function start(params: Params = {}, prepare: (frame: MutableFrame) => void = () => {}) {
  const spatial = createSpatial({ gl: {} as never, held: true });
  const anchors: Anchor[] = [];
  const session = {
    sessions: 1,
    openHitTest: spatial.openHitTest,
    castRay: spatial.castRay,
    anchors: {
      create: (at: Parameters<typeof spatial.anchors.create>[0]) => {
        const anchor = spatial.anchors.create(at);
        anchors.push(anchor);
        return anchor;
      },
    },
  };
  const remove = createPulseQueue();
  const fake = fakeContext(definition, { params, inputs: { objects: [cube()], remove }, services: { session: session as never } });
  const node = create(fake.ctx);
  const frame = createSessionFrame();
  frame.viewCount = 1;
  frame.views[0]?.worldFromView.set(new Matrix4().setPosition(...EYES).elements);
  prepare(frame);
  const { outputs } = fake.ctx;
  const step = (...pointers: readonly MutablePointer[]) => {
    frame.input.pointerCount = 0;
    for (const each of pointers) addPointer(frame.input, each);
    frame.index++;
    fake.tick(1 / 60);
    spatial.enterFrame(frame);
    node.update(frame);
    const [item] = outputs.objects.items;
    return {
      at: outputs.pose.valid ? rounded(outputs.pose.worldFromPose.slice(12, 15)) : null,
      object: item ? rounded(new Vector3().setFromMatrixPosition(item.worldFromObject).toArray()) : null,
      placed: pulseNumbers(outputs.placed),
      moved: outputs.moved.count,
      removed: outputs.removed.count,
    };
  };
  const tap = (to: Place, id = 1) => {
    const press = pointer(id, 'start', rayTo(to));
    step(press);
    const seen = step(Object.assign(press, { phase: 'end', tapped: true }));
    step();
    return seen;
  };
  /** Degrees from the x axis to that of the objects, and their size. */
  const posture = () => {
    const m = outputs.objects.items[0]?.worldFromObject ?? new Matrix4();
    const x = new Vector3().setFromMatrixColumn(m, 0);
    return { turnDeg: Math.round((Math.atan2(-x.z, x.x) * 1800) / Math.PI) / 10 + 0, scale: Math.round(x.length() * 1e4) / 1e4 };
  };
  return { ...fake, node, spatial, session, anchors, remove, frame, step, tap, posture };
}

const NOTHING = { placed: [], moved: 0, removed: 0 };

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

  /** Two fingers around the cube at (0, 0, -2), as far apart and turned as the second says. */
  function fingers(phase: 'start' | 'hold' | 'end', apart: number, turnRad: number): MutablePointer[] {
    // In a plane that faces the eyes, so that its angles are those of the screen.
    const ahead = new Vector3(0, 0, -1);
    return [1, -1].map((side, i) => {
      const to = ahead.clone().add(new Vector3(Math.cos(turnRad), Math.sin(turnRad), 0).multiplyScalar((side * apart) / 2));
      // The view looks along -z, and the fingers point 40° down.
      to.y -= Math.tan((40 * Math.PI) / 180);
      return pointer(10 + i, phase, rayTo([to.x, to.y + EYES[1], to.z]), { tapped: false });
    });
  }

  test('a pinch scales within limits, and a twist rotates counter-clockwise about the normal', () => {
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
