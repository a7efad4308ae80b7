import { describe, expect, test } from '@jest/globals';
import { BoxGeometry, Matrix4, Mesh, MeshBasicMaterial } from 'three';
import { createPointer, type MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { frameOfEyes, nextFrame, type Place, rayTo } from '../../../tests/support/pointer-kit.ts';
import type { HitRecord, HitSource } from '../../kit/hit-test.ts';
import { claimPointer } from '../../kit/pointers.ts';
import { createPose, writePose } from '../../kit/pose.ts';
import type { PulseList } from '../../kit/runtime.ts';
import type { ObjectItem, ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;

/** A pointer of a mouse, over several frames. */
function mouse(id = 1, more: Partial<MutablePointer> = {}) {
  const pointer = Object.assign(createPointer(), { id, by: 'mouse', ...more });
  const show = (to: Place, phase: MutablePointer['phase'], tapped: boolean) => {
    pointer.phase = phase;
    pointer.tapped = tapped;
    pointer.worldFromRay.set(rayTo(to));
    return pointer;
  };
  return {
    pointer,
    at: (to: Place, phase: MutablePointer['phase'] = 'hover') => show(to, phase, false),
    taps: (to: Place) => show(to, 'end', true),
  };
}

/** Cubes of 20 cm. */
function cubes(places: Readonly<Record<string, Place>>, more: Partial<ObjectItem> = {}): ObjectList {
  const items = Object.entries(places).map(([key, place]): ObjectItem => {
    const root = Object.assign(new Mesh(new BoxGeometry(0.2, 0.2, 0.2), new MeshBasicMaterial()), { name: `part of ${key}` });
    const worldFromObject = new Matrix4().makeTranslation(...place);
    return { key, root, worldFromObject, role: 'virtual', castsShadow: true, receivesShadow: true, ...more };
  });
  return { version: 1, items };
}

const A: Place = [-1, 1.6, -2];
const B: Place = [1, 1.6, -2];
const AIR: Place = [0, 3, -2];

function texts(list: PulseList): string[] {
  return Array.from({ length: list.count }, (_, i) => list.at(i).text);
}

interface More {
  readonly inputs?: Partial<Parameters<typeof create>[0]['inputs']>;
  readonly castRay?: (ray: ArrayLike<number>, out: HitRecord, sources?: readonly HitSource[]) => boolean;
}

function start(params: Params = {}, objects: readonly ObjectList[] = [cubes({ a: A, b: B })], { inputs = {}, castRay }: More = {}) {
  const frame = frameOfEyes();
  const services = { session: { frame, castRay } as never };
  const fake = fakeContext(definition, { params, inputs: { objects, ...inputs }, services });
  const node = create(fake.ctx);
  const { outputs } = fake.ctx;
  /** Before the frame, so that the reader sees what the node gives in the frame after. */
  const step = (...pointers: readonly MutablePointer[]) => {
    nextFrame(frame, pointers);
    fake.tick(1 / 60);
    node.update(frame);
    const seen = {
      over: outputs.isOver.value ? outputs.key.value : null,
      entered: texts(outputs.entered),
      left: texts(outputs.left),
      pressed: texts(outputs.pressed),
      tapped: texts(outputs.tapped),
    };
    node.remember?.();
    return seen;
  };
  return { ...fake, node, frame, step };
}

const NOTHING = { over: null, entered: [], left: [], pressed: [], tapped: [] };

describe('input/pick', () => {
  test('tells in the next frame what a mouse is over, and when it enters and leaves', () => {
    const { ctx, step } = start();
    const { at } = mouse();
    expect(step(at(A))).toEqual(NOTHING);
    expect(step(at(A))).toEqual({ ...NOTHING, over: 'a', entered: ['a'] });
    const { outputs } = ctx;
    expect([outputs.part.value, outputs.wire.value, outputs.distanceM.value]).toEqual(['part of a', 0, expect.closeTo(2.125, 2)]);
    // The front face of the box, at z = -1.9.
    expect(outputs.pose.worldFromPose[14]).toBeCloseTo(-1.9, 5);
    expect([...outputs.normal.value]).toEqual([0, 0, 1].map((x) => expect.closeTo(x, 5)));
    expect(step(at(B))).toEqual({ ...NOTHING, over: 'a' });
    expect(step(at(AIR))).toEqual({ ...NOTHING, over: 'b', entered: ['b'], left: ['a'] });
    expect(step()).toEqual({ ...NOTHING, left: ['b'] });
    expect([outputs.pose.valid, outputs.wire.value, outputs.key.value, outputs.distanceM.value]).toEqual([false, -1, '', 0]);
  });

  test('tells of a press and a tap, and claims the press', () => {
    const { ctx, step } = start();
    const { pointer, at, taps } = mouse();
    step(at(A, 'start'));
    expect(pointer.owner).toBe(ctx);
    expect(step(at(A, 'hold'))).toEqual({ ...NOTHING, over: 'a', entered: ['a'], pressed: ['a'] });
    expect(ctx.outputs.isPressed.value).toBe(true);
    expect(step(taps(A))).toEqual({ ...NOTHING, over: 'a', tapped: ['a'] });
    expect([ctx.outputs.isPressed.value, ctx.outputs.tapped.at(0).worldFromPose?.[14]]).toEqual([false, expect.closeTo(-1.9, 5)]);
  });

  test('tells of a tap of two frames, and of none that ends as a drag or is canceled', () => {
    const { step } = start();
    const first = mouse();
    step(first.at(A, 'start'));
    expect(step(first.taps(A))).toMatchObject({ pressed: ['a'], tapped: ['a'] });
    for (const phase of ['end', 'cancel'] as const) {
      const { at } = mouse(2);
      step(at(B, 'start'));
      expect([step(at(B, phase)), step()]).toMatchObject([{ pressed: ['b'], tapped: [] }, { tapped: [] }]);
    }
  });

  test('tells of no tap where the ray has turned by more than 3° in between, as in a drag that WebXR calls a selection', () => {
    const { step } = start();
    const { at, taps } = mouse();
    step(at(A, 'start'));
    step(at(B, 'hold'));
    expect(step(taps(A)).tapped).toEqual([]);
  });

  test('tells of a press beside the objects nothing, also where it moves onto them', () => {
    const { ctx, step } = start();
    const { pointer, at, taps } = mouse();
    step(at(AIR, 'start'));
    step(at(A, 'hold'));
    expect(step(at(A, 'hold'))).toEqual({ ...NOTHING, over: 'a', entered: ['a'] });
    expect(step(taps(A)).tapped).toEqual([]);
    expect([pointer.owner, ctx.outputs.isPressed.value]).toEqual([null, false]);
  });

  test('tells of two fingers on two objects', () => {
    const { step } = start();
    const [left, right] = [mouse(1, { by: 'screen' }), mouse(2, { by: 'screen' })];
    step(left.at(A, 'start'), right.at(B, 'start'));
    expect(step(left.at(A, 'hold'), right.at(B, 'hold')).pressed).toEqual(['a', 'b']);
    expect(step(left.at(A, 'hold'), right.taps(B)).tapped).toEqual(['b']);
  });

  test('two Pick nodes on one tap: the nearer object has it, whichever node runs first', () => {
    for (const [first, second] of [
      [1, 2],
      [2, 1],
    ] as const) {
      const nodes = [first, second].map((distanceM) => start({}, [cubes({ [`at ${distanceM}`]: [0, 1.6, -distanceM] })]));
      const { at, taps } = mouse();
      const ahead: Place = [0, 1.6, -1];
      for (const node of nodes) node.step(at(ahead, 'start'));
      const seen = nodes.map((node) => node.step(taps(ahead))).flatMap(({ pressed, tapped }) => [...pressed, ...tapped]);
      expect(seen).toEqual(['at 1', 'at 1']);
    }
  });

  test('leaves a press that another node claimed, unless that node moves the object', () => {
    const mover = {};
    const { ctx, step } = start({}, [cubes({ a: A }), cubes({ b: B }, { claimant: mover })]);
    for (const [place, tapped] of [
      [A, []],
      [B, ['b']],
    ] as const) {
      const { pointer, at, taps } = mouse();
      at(place, 'start');
      claimPointer(pointer, mover, 0);
      step(pointer);
      expect(step(taps(place)).tapped).toEqual(tapped);
      expect(pointer.owner).toBe(mover);
      step();
    }
    expect(ctx.outputs.isPressed.value).toBe(false);
  });

  test('claims nothing where it is set so, and still tells', () => {
    const { step } = start({ claims: false });
    const { pointer, at, taps } = mouse();
    step(at(A, 'start'));
    expect([step(taps(A)).tapped, pointer.owner]).toEqual([['a'], null]);
  });

  test('meets nothing behind a phantom', () => {
    const wall = cubes({ wall: [-0.5, 1.6, -1] }, { role: 'phantom' });
    const { step } = start({}, [cubes({ a: A, b: B }), wall]);
    step(mouse().at(A));
    expect(step(mouse().at(B)).over).toBe(null);
    expect(step().over).toBe('b');
  });

  test('meets nothing that the room hides by more than the tolerance, where depth is connected', () => {
    let roomM = 1;
    const asked: unknown[] = [];
    const castRay = (_: ArrayLike<number>, out: HitRecord, sources?: readonly HitSource[]) => {
      asked.push(sources);
      out.distanceM = roomM;
      return roomM > 0;
    };
    const seen = (more: More, depthM: number) => {
      roomM = depthM;
      const { step } = start({}, undefined, more);
      step(mouse().at(A));
      return step().over;
    };
    const depth = { inputs: { depth: { views: [] } }, castRay };
    // The face of the box is 2.12 m away.
    expect([seen(depth, 1), seen(depth, 2.05), seen(depth, 2.1), seen(depth, 5), seen(depth, 0)]).toEqual([null, null, 'a', 'a', 'a']);
    expect(new Set(asked)).toEqual(new Set([['depth']]));
    asked.length = 0;
    expect([seen({ castRay }, 1), asked]).toEqual(['a', []]);
  });

  test('follows only those that it is set to, the middle of the view, or a connected ray', () => {
    const pose = createPose();
    writePose(pose, rayTo(B), 0);
    const all = (['screen', 'mouse', 'left', 'left-hand', 'right', 'right-hand', 'gaze'] as const).map((by, i) =>
      mouse(i + 1, { by }).at(A),
    );
    const heard = (from: NonNullable<Params['from']>) =>
      all.filter((each) => {
        const { step } = start({ from });
        step(each);
        return step().over !== null;
      }).length;
    expect((['pointers', 'screen', 'left', 'right', 'ray', 'center'] as const).map(heard)).toEqual([7, 2, 2, 2, 0, 0]);
    const byRay = start({ from: 'ray' }, undefined, { inputs: { ray: pose } });
    byRay.step();
    expect(byRay.step().over).toBe('b');
    pose.valid = false;
    byRay.step();
    expect(byRay.step().over).toBe(null);
    const center = start({ from: 'center' }, [cubes({ ahead: [0, 1.6, -3] })]);
    center.step();
    expect(center.step().over).toBe('ahead');
  });

  test('raises the jumps of its pose when it turns to another object, and tells of copies by their index', () => {
    const { ctx, step } = start();
    step(mouse().at(A));
    step(mouse().at(A));
    const { jumps } = ctx.outputs.pose;
    step(mouse().at(B));
    expect(ctx.outputs.pose.jumps).toBe(jumps);
    step(mouse().at(B));
    expect(ctx.outputs.pose.jumps).toBe(jumps + 1);
    expect(pulseNumbers(ctx.outputs.entered)).toEqual([0]);
  });

  test('forgets what it met at a reset', () => {
    const { ctx, node, step } = start();
    const { at } = mouse();
    step(at(A, 'start'));
    step(at(A, 'hold'));
    node.reset?.();
    expect(step(at(AIR, 'hold'))).toEqual(NOTHING);
    expect(ctx.outputs.isPressed.value).toBe(false);
  });
});
