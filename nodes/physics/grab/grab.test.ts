import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { addPointer, createPointer, type MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { captureHand } from '../../../tests/support/captured-hand.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { ball } from '../../../tests/support/physics/lab.ts';
import { createStage, placeOf } from '../../../tests/support/physics/stage.ts';
import { writePalm, writePinch } from '../../kit/hands.ts';
import { claimPointer } from '../../kit/pointers.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const EYES = new Vector3(0, 1.6, 2);

function start() {
  const stage = createStage();
  const body = stage.add([0, 0.1, 0], ball(0.1));
  const fake = fakeContext(definition, { inputs: { body: [stage.list] } });
  const node = create(fake.ctx);
  const frame = createSessionFrame();
  const { input } = frame;
  const pointer = Object.assign(createPointer(), { id: 3, tapped: false });
  const play = () => {
    stage.play(1, node, fake, frame);
    return pulseNumbers(fake.ctx.outputs.released);
  };
  const point = (phase: MutablePointer['phase'] | null, to: Vector3, by: MutablePointer['by'] = 'mouse', grip: Vector3 | null = null) => {
    input.pointerCount = 0;
    if (!phase) return;
    if (phase === 'start') Object.assign(pointer, { owner: null, ownerDistanceM: 0 });
    const ray = new Matrix4().lookAt(EYES, to, new Vector3(0, 1, 0)).setPosition(EYES);
    pointer.worldFromRay.set(ray.elements);
    const worldFromGrip = grip && Float32Array.from(new Matrix4().setPosition(grip).elements);
    addPointer(input, Object.assign(pointer, { phase, by, worldFromGrip }));
  };
  const step = (...args: Parameters<typeof point>) => {
    point(...args);
    return play();
  };
  /** Shows the left hand with a point of it somewhere. */
  const showHand = (gesture: 'relaxed' | 'pinch' | 'fist', part: typeof writePinch, at: Vector3) => {
    captureHand(gesture, 0, input.leftHand);
    const pose = new Float32Array(16);
    part(pose, input.leftHand);
    for (let i = 12; i < 16 * 25; i += 16) {
      for (let axis = 0; axis < 3; axis++) {
        const offset = at.getComponent(axis) - (pose[12 + axis] ?? 0);
        input.leftHand.worldFromJoints[i + axis] = (input.leftHand.worldFromJoints[i + axis] ?? 0) + offset;
      }
    }
  };
  return { ...fake, stage, node, body, pointer, input, step, play, point, showHand };
}

/** A throw: at rest for 0.2 s, then the speed grows evenly for 0.25 s to the last speed, kept for 0.1 s. Meters at a frame. */
function throwAt(frame: number, speed: number): number {
  const timeS = Math.max(frame / 60 - 0.2, 0);
  return timeS < 0.25 ? (speed * timeS ** 2) / 0.5 : speed * (timeS - 0.125);
}
const THROW_FRAMES = 33;

describe('physics/grab', () => {
  test('carries the body under the pointer, and throws it with the velocity of the press', () => {
    const { body, step, ctx } = start();
    const at = (x: number, y: number) => new Vector3(x, y, 0);
    for (let i = 0; i < 5; i++) step(null, at(0, 0.1));
    step('start', at(0, 0.1));
    step('hold', at(0, 0.1));
    expect(ctx.outputs.isHeld.value).toBe(true);
    for (let i = 0; i < 60; i++) step('hold', at(0, 0.1 + i / 60));
    expect(placeOf(body)[1]).toBeGreaterThan(0.9);
    for (let i = 0; i < 30; i++) step('hold', at((i / 60) * 3, 1.1));
    const [speed = 0] = step('end', at(1.5, 1.1));
    expect(speed).toBeGreaterThan(2);
    expect(ctx.outputs.isHeld.value).toBe(false);
    for (let i = 0; i < 20; i++) step(null, at(0, 0));
    expect(placeOf(body)[0]).toBeGreaterThan(1.9);
    expect(body.joints).toEqual([]);
  });

  test('a press beside the body holds nothing', () => {
    const { step, ctx } = start();
    step(null, new Vector3());
    step('start', new Vector3(0.5, 0.1, 0));
    step('hold', new Vector3(0.5, 0.1, 0));
    expect(ctx.outputs.isHeld.value).toBe(false);
  });

  test('the nearest on the ray gets the press, whichever node asks first', () => {
    const { step, point, play, pointer, ctx, body } = start();
    const at = new Vector3(0, 0.1, 0);
    const other = {};
    // To the ball it is 2.4 m.
    const bodyM = EYES.distanceTo(at) - 0.1;
    step(null, at);
    point('start', at);
    expect(claimPointer(pointer, other, 1)).toBe(true);
    play();
    step('hold', at);
    expect([ctx.outputs.isHeld.value, pointer.owner === other, body.joints]).toEqual([false, true, []]);

    step('end', at);
    point('start', at);
    claimPointer(pointer, other, 3);
    play();
    expect([pointer.owner === ctx, pointer.ownerDistanceM]).toEqual([true, expect.closeTo(bodyM, 3)]);
    // What is nearer takes it away in the same frame, before anything was held.
    expect(claimPointer(pointer, other, 2)).toBe(true);
    expect(step('hold', at)).toEqual([]);
    expect([ctx.outputs.isHeld.value, body.joints]).toEqual([false, []]);

    step('end', at);
    step('start', at);
    step('hold', at);
    expect([ctx.outputs.isHeld.value, body.joints.length]).toEqual([true, 1]);
  });

  test('a hand whose joints are unknown carries it with its grip', () => {
    const { body, step } = start();
    const grip = (y: number) => new Vector3(0, y, 0);
    step(null, new Vector3());
    step('start', new Vector3(0, 0.1, 0), 'right-hand', grip(0.1));
    for (let i = 0; i < 90; i++) step('hold', new Vector3(0, 0.1, 0), 'right-hand', grip(0.1 + Math.min(i / 60, 1)));
    expect(placeOf(body)[1]).toBeCloseTo(1.1, 1);
  });

  test.each([
    ['a pinch', 'pinch', writePinch],
    ['a fist', 'fist', writePalm],
  ] as const)('%s of a bare hand throws it with the velocity of the hand', (_, gesture, part) => {
    const { body, step, play, point, showHand, ctx } = start();
    const away = new Vector3(5, 5, 5);
    const at = (frame: number) => new Vector3(throwAt(frame, 3) * 0.8, 0.12 + throwAt(frame, 3) * 0.6, 0);
    showHand('relaxed', part, at(0));
    step(null, away);
    for (let frame = 0; frame < THROW_FRAMES; frame++) {
      showHand(gesture, part, at(frame));
      // The ray of a hand points past the body that is in the hand.
      if (gesture === 'pinch') point(frame === 0 ? 'start' : 'hold', away, 'left-hand');
      play();
    }
    expect(ctx.outputs.isHeld.value).toBe(true);
    showHand('relaxed', part, at(THROW_FRAMES));
    if (gesture === 'pinch') point('end', away, 'left-hand');
    expect(play()).toEqual([expect.closeTo(3, 0)]);
    const [x = 0, y = 0, z = 0] = body.velocity;
    // 10 % of 3 m/s.
    expect(Math.hypot(x - 2.4, y - 1.8, z)).toBeLessThan(0.3);
  });

  test('a squeezed controller grabs along its ray, and a hand beyond its reach nothing', () => {
    const { body, play, input, showHand, ctx } = start();
    showHand('relaxed', writePalm, new Vector3(0.5, 0.1, 0));
    play();
    showHand('fist', writePalm, new Vector3(0.5, 0.1, 0));
    play();
    expect(ctx.outputs.isHeld.value).toBe(false);
    input.leftHand.tracked = false;
    const pose = Float32Array.from(new Matrix4().setPosition(0, 0.1, 1).elements);
    Object.assign(input.right, { worldFromRay: pose, worldFromGrip: pose, squeeze: 1 });
    play();
    play();
    expect([ctx.outputs.isHeld.value, body.joints.length]).toEqual([true, 1]);
    input.right.squeeze = 0;
    play();
    expect([ctx.outputs.isHeld.value, body.joints]).toEqual([false, []]);
  });

  test('a held body pushes another', () => {
    const { stage, body, step } = start();
    const other = stage.add([0.4, 0.1, 0], ball(0.1));
    const at = (x: number) => new Vector3(x, 0.1, 0);
    step(null, at(0));
    step('start', at(0));
    for (let i = 0; i < 60; i++) step('hold', at(0.5 * Math.min(i / 30, 1)));
    expect(placeOf(body)[0]).toBeGreaterThan(0.4);
    expect(placeOf(other)[0]).toBeGreaterThan(0.55);
  });

  test('an open hand pushes a body, and does not hit what it has thrown', () => {
    const { stage, body, showHand, play, ctx, input } = start();
    const at = (frame: number) => new Vector3(-0.5 + Math.min(frame / 60, 0.6), 0.15, 0);
    showHand('relaxed', writePalm, at(0));
    play();
    const { bodies } = ctx.outputs.hands;
    expect(bodies.length).toBeGreaterThan(5);
    stage.list.bodies.push(...bodies);
    stage.list.version++;
    for (let frame = 0; frame < 36; frame++) {
      showHand('relaxed', writePalm, at(frame));
      play();
    }
    // At 1 m/s, the speed of the hand.
    expect(body.velocity[0]).toBeGreaterThan(0.9);
    expect(placeOf(body)[0]).toBeGreaterThan(0.1);

    // It closes beside the ball, within its reach.
    const [x, y, z] = placeOf(body);
    showHand('fist', writePalm, new Vector3(x + 0.13, y + 0.03, z));
    for (let frame = 0; frame < 3; frame++) play();
    expect([ctx.outputs.isHeld.value, bodies]).toEqual([true, []]);
    showHand('relaxed', writePalm, new Vector3(...placeOf(body)));
    play();
    expect(bodies).toEqual([]);
    for (let frame = 0; frame < 30; frame++) play();
    expect(bodies.length).toBeGreaterThan(5);
    input.leftHand.tracked = false;
    play();
    expect(bodies).toEqual([]);
  });

  test('a reset lets go, also of a body whose joints are gone', () => {
    const { body, node, step } = start();
    step(null, new Vector3());
    step('start', new Vector3(0, 0.1, 0));
    step('hold', new Vector3(0, 0.1, 0));
    expect(body.joints).toHaveLength(1);
    const other = { ...body.joints[0] } as never;
    body.joints.splice(0, 1, other);
    node.reset?.();
    expect(body.joints).toEqual([other]);
  });
});
