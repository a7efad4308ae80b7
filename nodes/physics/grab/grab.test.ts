import { describe, expect, test } from '@jest/globals';
import { Matrix4, Vector3 } from 'three';
import { addPointer, createPointer, type MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { fakeContext, pulseNumbers } from '../../../tests/support/node-context.ts';
import { ball } from '../../../tests/support/physics/lab.ts';
import { createStage, placeOf } from '../../../tests/support/physics/stage.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

const EYES = new Vector3(0, 1.6, 2);

function start() {
  const stage = createStage();
  const body = stage.add([0, 0.1, 0], ball(0.1));
  const fake = fakeContext(definition, { inputs: { body: [stage.list] } });
  const node = create(fake.ctx);
  const frame = createSessionFrame();
  const step = (phase: MutablePointer['phase'] | null, to: Vector3, by: MutablePointer['by'] = 'mouse') => {
    frame.input.pointerCount = 0;
    if (phase) {
      const pointer = Object.assign(createPointer(), { id: 3, phase, by, tapped: false });
      const ray = new Matrix4().lookAt(EYES, to, new Vector3(0, 1, 0)).setPosition(EYES);
      pointer.worldFromRay.set(ray.elements);
      if (by === 'right-hand') Object.assign(pointer, { worldFromGrip: Float32Array.from(new Matrix4().setPosition(to).elements) });
      addPointer(frame.input, pointer);
    }
    stage.play(1, node, fake, frame);
    return pulseNumbers(fake.ctx.outputs.released);
  };
  return { ...fake, node, body, step };
}

describe('physics/grab', () => {
  test('carries the body under the pointer, and throws it with the velocity of the press', () => {
    const { body, step, ctx } = start();
    const at = (x: number, y: number) => new Vector3(x, y, 0);
    for (let i = 0; i < 5; i++) step(null, at(0, 0.1));
    step('start', at(0, 0.1));
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
    expect(ctx.outputs.isHeld.value).toBe(false);
  });

  test('a hand carries it with its grip', () => {
    const { body, step } = start();
    step(null, new Vector3());
    step('start', new Vector3(0, 0.1, 0), 'right-hand');
    for (let i = 0; i < 90; i++) step('hold', new Vector3(0, 0.1 + Math.min(i / 60, 1), 0), 'right-hand');
    expect(placeOf(body)[1]).toBeCloseTo(1.1, 1);
  });

  test('a reset lets go', () => {
    const { body, node, step } = start();
    step(null, new Vector3());
    step('start', new Vector3(0, 0.1, 0));
    expect(body.joints).toHaveLength(1);
    node.reset?.();
    expect(body.joints).toEqual([]);
  });
});
