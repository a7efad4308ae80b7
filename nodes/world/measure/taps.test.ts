import { describe, expect, test } from '@jest/globals';
import { InstancedMesh, Matrix4 } from 'three';
import type { MutablePointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import { frameOfEyes, nextFrame, type Place, pointer, rayTo } from '../../../tests/support/pointer-kit.ts';
import type { ObjectList } from '../../kit/scene-lists.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;

function start(params: Params) {
  const spatial = createSpatial({ gl: {} as never, held: true });
  const pulses = { add: createPulseQueue(), undo: createPulseQueue(), finish: createPulseQueue(), clear: createPulseQueue() };
  const session = { sessions: 1, openHitTest: spatial.openHitTest, castRay: spatial.castRay, anchors: spatial.anchors };
  const services = { session: session as never };
  const fake = fakeContext(definition, { params: { from: 'taps', unit: 'm', ...params }, inputs: pulses, services });
  const list: ObjectList = { version: 0, items: [] };
  Object.assign(fake.ctx.outputs, { objects: list });
  Object.assign(fake.ctx.clock, { held: true });
  const node = create(fake.ctx);
  const frame = frameOfEyes();
  const { outputs } = fake.ctx;
  const step = (...pointers: readonly MutablePointer[]) => {
    nextFrame(frame, pointers);
    fake.tick(1 / 60);
    spatial.enterFrame(frame);
    node.update(frame);
    for (const queue of Object.values(pulses)) queue.clear();
    const { value, valid, count } = outputs;
    return { value: Math.round(value.value * 1e5) / 1e5, valid: valid.value, count: count.value, measured: outputs.measured.count };
  };
  const point = (to: Place, more: Partial<MutablePointer> = {}) => pointer(1, 'end', rayTo(to), more);
  const tap = (to: Place) => {
    step(point(to, { phase: 'start', tapped: false }));
    return step(point(to));
  };
  /** How many lines and ends are shown. */
  const drawn = () => list.items.map(({ root, hidden }) => (hidden || !(root instanceof InstancedMesh) ? 0 : root.count));
  return { ...fake, ...pulses, node, spatial, session, frame, step, tap, point, drawn };
}

describe('world/measure with taps', () => {
  test('measures a distance with the second tap, and begins anew with the third', () => {
    const { ctx, tap, step, drawn } = start({});
    expect(step()).toEqual({ value: 0, valid: false, count: 0, measured: 0 });
    expect(drawn()).toEqual([0, 0]);
    expect(tap([0, 0, -2])).toEqual({ value: 0, valid: false, count: 1, measured: 0 });
    expect(drawn()).toEqual([0, 1]);
    expect(tap([0.6, 0, -2])).toEqual({ value: 0.6, valid: true, count: 2, measured: 1 });
    expect(drawn()).toEqual([1, 2]);
    expect(ctx.outputs.text.value.replaceAll(' ', ' ')).toMatch(/^0\.\d+ m ± 0\.\d+ m$/);
    expect(step().measured).toBe(0);
    expect(tap([0, 0, -1])).toEqual({ value: 0, valid: false, count: 1, measured: 0 });
  });

  test('a line grows with each tap, and ends with a tap at its last point', () => {
    const { tap, drawn } = start({ mode: 'polyline' });
    for (const to of [
      [0, 0, -2],
      [1, 0, -2],
      [1, 0, -3],
    ] as const)
      tap(to);
    expect(tap([1, 0, -3.5])).toMatchObject({ value: 2.5, count: 4, measured: 0 });
    expect(tap([1, 0, -3.5])).toMatchObject({ value: 2.5, count: 4, measured: 1 });
    expect(drawn()).toEqual([3, 4]);
  });

  test('an outline closes with a tap at its first point, or by a pulse', () => {
    const { tap, finish, step, drawn } = start({ mode: 'polygon' });
    for (const to of [
      [0, 0, -2],
      [1, 0, -2],
      [1, 0, -3],
    ] as const)
      tap(to);
    expect(tap([0, 0, -3])).toMatchObject({ value: 1, count: 4, measured: 0 });
    expect(drawn()).toEqual([4, 4]);
    expect(tap([0, 0, -2])).toMatchObject({ value: 1, count: 4, measured: 1 });
    tap([0, 0, -2]);
    tap([1, 0, -2]);
    tap([1, 0, -3]);
    finish.emit();
    expect(step()).toMatchObject({ value: 0.5, measured: 1 });
  });

  test('a rectangle has four sides, a box twelve edges', () => {
    const flat = start({ mode: 'rectangle' });
    for (const to of [
      [0, 0, -2],
      [0.5, 0, -2],
      [0.9, 0, -2.4],
    ] as const)
      flat.tap(to);
    expect([flat.step().value, flat.drawn()]).toEqual([0.2, [4, 3]]);
    const solid = start({ mode: 'box' });
    for (const to of [
      [0, 0, -2],
      [0.5, 0, -2],
      [0.5, 0, -2.4],
    ] as const)
      solid.tap(to);
    solid.add.emit().setPose(new Matrix4().setPosition(0.2, 0.3, -2.2).elements);
    expect([solid.step().value, solid.drawn()]).toEqual([0.06, [12, 4]]);
  });

  test('undo removes the last point, clear all, and neither leaves anchors behind', () => {
    const { tap, undo, clear, step, spatial, node } = start({ mode: 'angle' });
    for (const to of [
      [0, 0, -2],
      [1, 0, -2],
      [1, 0, -3],
    ] as const)
      tap(to);
    expect(spatial.counts().anchors).toBe(3);
    undo.emit();
    expect(step()).toMatchObject({ count: 2, valid: false });
    expect(tap([2, 0, -2])).toMatchObject({ count: 3, value: expect.closeTo(Math.PI, 5) });
    clear.emit();
    expect(step()).toMatchObject({ count: 0, valid: false });
    expect(spatial.counts().anchors).toBe(0);
    tap([0, 0, -2]);
    node.dispose();
    expect(spatial.counts()).toEqual({ hitTests: 0, deviceSources: 0, anchors: 0 });
  });

  test('shows the value up to a mouse that hovers', () => {
    const { tap, step, point, drawn } = start({});
    tap([0, 0, -2]);
    expect(step(point([0.25, 0, -2], { phase: 'hover', tapped: false, by: 'mouse' }))).toMatchObject({
      value: 0.25,
      count: 1,
      valid: true,
    });
    expect(drawn()).toEqual([1, 2]);
    expect(step()).toMatchObject({ count: 1, valid: false });
  });

  test('takes no taps while it is not active, none that another node owns, and none with rays that are no poses', () => {
    const { set, step, point } = start({ active: false });
    expect(step(point([0, 0, -2])).count).toBe(0);
    set('active', true);
    expect(step(point([0, 0, -2], { owner: {} })).count).toBe(0);
    const broken = point([0, 0, -2]);
    broken.worldFromRay.fill(Number.NaN);
    expect(step(broken).count).toBe(0);
    expect(step(point([0, 0, -2])).count).toBe(1);
  });

  test('forgets its points in another session', () => {
    const { tap, session, step } = start({});
    tap([0, 0, -2]);
    session.sessions++;
    expect(step().count).toBe(0);
  });
});
