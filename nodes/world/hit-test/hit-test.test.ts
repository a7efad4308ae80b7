import { describe, expect, test } from '@jest/globals';
import { addPointer, createPointer } from '../../../export/runtime/sessions/input/session-input.ts';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { ParamValue } from '../../kit/definition.ts';
import { createPose, type PoseView, writePose } from '../../kit/pose.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

/** Looks straight down from 1.6 m, at (x, z). */
const down = (x: number, z: number) => [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, x, 1.6, z, 1];

function start(
  from: 'center' | 'pointers' | 'left' | 'ray',
  ray: PoseView | null = null,
  params: Readonly<Record<string, ParamValue>> = {},
) {
  const spatial = createSpatial({ gl: {} as never, held: true });
  const fake = fakeContext(definition, { params: { from, ...params }, inputs: { ray }, services: { session: spatial as never } });
  const node = create(fake.ctx);
  const frame = createSessionFrame();
  frame.viewCount = 1;
  const { outputs } = fake.ctx;
  const step = () => {
    fake.tick(1 / 60);
    spatial.enterFrame(frame);
    node.update(frame);
    return {
      hit: outputs.hit.value,
      at: outputs.pose.valid ? [...outputs.pose.worldFromPose.slice(12, 15)].map((x) => Math.round(x * 1e5) / 1e5 + 0) : null,
      distanceM: outputs.distanceM.value,
      orientation: outputs.orientation.value,
      label: outputs.label.value,
      source: outputs.source.value,
    };
  };
  return { spatial, node, frame, step };
}

const NOTHING = { hit: false, at: null, distanceM: 0, orientation: '', label: '', source: '' };

describe('world/hit-test', () => {
  test('finds the floor from the center of the view', () => {
    const { frame, step } = start('center');
    frame.views[0]?.worldFromView.set(down(2, -3));
    const floor = { hit: true, at: [2, 0, -3], distanceM: expect.closeTo(1.6, 6), orientation: 'floor', label: '', source: 'floor' };
    expect(step()).toEqual(floor);
  });

  test('tells what the device calls the surface', () => {
    const { frame, step } = start('center');
    frame.views[0]?.worldFromView.set(down(2, -3));
    const table = {
      id: 'table-0',
      version: 0,
      label: 'table',
      orientation: 'horizontal' as const,
      worldFromSurface: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 0.6, -3, 1),
      outlineXZ: Float32Array.of(-1, -1, 1, -1, 1, 1, -1, 1),
    };
    frame.surfaces = { planes: [table], meshes: [] };
    expect(step()).toMatchObject({ at: [2, 0.6, -3], orientation: 'floor', label: 'table', source: 'plane' });
    frame.surfaces = null;
    expect(step()).toMatchObject({ label: '', source: 'floor' });
  });

  test('finds nothing where the ray goes up', () => {
    const { frame, step } = start('center');
    frame.views[0]?.worldFromView.set([1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1.6, 0, 1]);
    expect(step()).toEqual(NOTHING);
  });

  test('takes a pointer that is pressed before one that hovers', () => {
    const { frame, step } = start('pointers');
    expect(step()).toEqual(NOTHING);
    for (const [id, phase] of [
      [1, 'hover'],
      [2, 'hold'],
    ] as const) {
      const pointer = Object.assign(createPointer(), { id, phase });
      pointer.worldFromRay.set(down(id, 0));
      addPointer(frame.input, pointer);
    }
    expect(step().at).toEqual([2, 0, 0]);
  });

  test('hears the hand that it is set to', () => {
    const { frame, step } = start('left');
    for (const by of ['right', 'left-hand'] as const) {
      const pointer = Object.assign(createPointer(), { id: by === 'right' ? 1 : 2, by });
      pointer.worldFromRay.set(down(by === 'right' ? 1 : 2, 0));
      addPointer(frame.input, pointer);
    }
    expect(step().at).toEqual([2, 0, 0]);
  });

  test('follows a connected ray while it is valid', () => {
    const ray = createPose();
    const { step } = start('ray', ray);
    expect(step()).toEqual(NOTHING);
    writePose(ray, down(4, 4), 0);
    expect(step().at).toEqual([4, 0, 4]);
    expect(start('ray', null).step()).toEqual(NOTHING);
  });

  test('closes what it opened', () => {
    const { spatial, node, step } = start('center');
    step();
    expect(spatial.counts().hitTests).toBe(1);
    node.dispose();
    expect(spatial.counts().hitTests).toBe(0);
  });

  test('smooths a trembling view, and begins anew at re-centering', () => {
    const { frame, step } = start('center', null, { smoothingS: 1 / Math.PI, beta: 0 });
    const at = (x: number) => {
      frame.views[0]?.worldFromView.set(down(x, 0));
      return step().at?.[0] ?? Number.NaN;
    };
    expect(at(1)).toBe(1);
    // 2 π · 0.5 Hz / 60 Hz = 0.0524: 0.0524 / 1.0524 of 10 cm.
    expect(at(1.1)).toBeCloseTo(1.00498, 4);
    expect(at(1)).toBeLessThan(1.005);
    frame.jumps++;
    expect(at(3)).toBe(3);
    frame.views[0]?.worldFromView.set([1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1.6, 0, 1]);
    expect(step()).toEqual(NOTHING);
    expect(at(5)).toBe(5);
  });
});
