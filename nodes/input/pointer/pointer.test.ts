import { describe, expect, test } from '@jest/globals';
import {
  addPointer,
  createPointer,
  createSessionInput,
  type MutablePointer,
} from '../../../export/runtime/sessions/input/session-input.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params'];

function pointerOf(id: number, more: Partial<MutablePointer> = {}): MutablePointer {
  const pointer = Object.assign(createPointer(), { id, ...more });
  pointer.worldFromRay[12] = id;
  return pointer;
}

function start(params: Params = {}) {
  const fake = fakeContext(definition, { params: params ?? {} });
  const node = create(fake.ctx);
  const input = createSessionInput();
  const { outputs } = fake.ctx;
  const frame = (pointers: readonly MutablePointer[], jumps = 0) => {
    input.pointerCount = 0;
    for (const pointer of pointers) addPointer(input, pointer);
    fake.tick(1 / 60);
    node.update({ input, jumps } as never);
    return {
      at: outputs.pose.valid ? outputs.pose.worldFromPose[12] : null,
      pressed: outputs.pressed.value,
      started: outputs.started.count,
      ended: pulseNumbers(outputs.ended),
    };
  };
  return { ...fake, frame };
}

describe('input/pointer', () => {
  test('gives the ray and the pulses of a press', () => {
    const { ctx, frame } = start();
    expect(frame([])).toEqual({ at: null, pressed: false, started: 0, ended: [] });
    expect(frame([pointerOf(1, { phase: 'start', pinch: 0.75 })])).toEqual({ at: 1, pressed: true, started: 1, ended: [] });
    expect([ctx.outputs.pinch.value, ctx.outputs.started.at(0).worldFromPose?.[12]]).toEqual([0.75, 1]);
    expect(frame([pointerOf(1, { phase: 'hold' })])).toEqual({ at: 1, pressed: true, started: 0, ended: [] });
    expect(frame([pointerOf(1, { phase: 'end', tapped: true })])).toEqual({ at: 1, pressed: false, started: 0, ended: [1] });
    expect(frame([pointerOf(1, { phase: 'hover' })])).toEqual({ at: 1, pressed: false, started: 0, ended: [] });
  });

  test('tells a tap from a drag and from what the system canceled', () => {
    const ends = (['end', 'cancel'] as const).map((phase) => start().frame([pointerOf(1, { phase })]).ended);
    expect(ends).toEqual([[0], [-1]]);
  });

  test('follows a press to its end, and a press before what hovers', () => {
    const { ctx, frame } = start();
    expect(frame([pointerOf(1), pointerOf(2)]).at).toBe(1);
    expect(frame([pointerOf(1), pointerOf(2, { phase: 'start' })]).at).toBe(2);
    const { jumps } = ctx.outputs.pose;
    expect(frame([pointerOf(1, { phase: 'start' }), pointerOf(2, { phase: 'hold' })]).at).toBe(2);
    expect(ctx.outputs.pose.jumps).toBe(jumps);
    expect(frame([pointerOf(1, { phase: 'hold' }), pointerOf(2)]).at).toBe(1);
    expect(ctx.outputs.pose.jumps).toBe(jumps + 1);
  });

  test('raises the jumps of its pose when the world is re-centered', () => {
    const { ctx, frame } = start();
    frame([pointerOf(1)], 3);
    const { jumps } = ctx.outputs.pose;
    frame([pointerOf(1)], 4);
    expect(ctx.outputs.pose.jumps).toBe(jumps + 1);
  });

  test('hears only those that it is set to', () => {
    const all = (['screen', 'mouse', 'left', 'left-hand', 'right', 'right-hand', 'gaze'] as const).map((by, i) => pointerOf(i + 1, { by }));
    const heard = (by: 'screen' | 'left' | 'right') =>
      all.filter((pointer) => start({ by }).frame([pointer]).at !== null).map((each) => each.by);
    expect([heard('screen'), heard('left'), heard('right')]).toEqual([
      ['screen', 'mouse'],
      ['left', 'left-hand'],
      ['right', 'right-hand'],
    ]);
  });

  test('claims a press, and leaves one that another node claimed', () => {
    const { ctx, frame } = start({ claims: true });
    const mine = pointerOf(1, { phase: 'start' });
    expect(frame([mine]).at).toBe(1);
    expect(mine.owner).toBe(ctx);
    expect(frame([pointerOf(2, { phase: 'start', owner: {} })]).at).toBe(null);
  });

  test('gives the grip where there is one', () => {
    const { ctx, frame } = start();
    frame([pointerOf(1, { worldFromGrip: pointerOf(7).worldFromRay })]);
    expect([ctx.outputs.grip.valid, ctx.outputs.grip.worldFromPose[12]]).toEqual([true, 7]);
    frame([pointerOf(1)]);
    expect(ctx.outputs.grip.valid).toBe(false);
  });
});
