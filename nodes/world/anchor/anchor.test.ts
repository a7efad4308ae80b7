import { describe, expect, test } from '@jest/globals';
import { createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import { createSpatial } from '../../../export/runtime/spatial/create-spatial.ts';
import { createPulseQueue } from '../../../export/runtime/values/pulses.ts';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { Anchor, AnchorState } from '../../kit/anchors.ts';
import { createPose, type PoseOutput, writePose } from '../../kit/pose.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';

type Params = NonNullable<NonNullable<Parameters<typeof fakeContext<typeof definition>>[1]>['params']>;

const at = (x: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1];

/** `xr`: of the frames of a WebXR session; without it anchors are ideal. */
function start({ pose = createPose(), params = {}, xr = null }: { pose?: PoseOutput | null; params?: Params; xr?: object | null } = {}) {
  const spatial = createSpatial({ gl: {} as never, held: true });
  const anchors: Anchor[] = [];
  /** Names under which anchors were to be kept, and anchors of an earlier visit. */
  const named: string[] = [];
  const kept = new Map<string, Anchor>();
  const session = {
    sessions: 1,
    anchors: {
      create: (where: ArrayLike<number>, keepAs?: string) => {
        const anchor = spatial.anchors.create(where, keepAs);
        anchors.push(anchor);
        if (keepAs !== undefined) named.push(keepAs);
        return anchor;
      },
      restore: (name: string) => kept.get(name) ?? null,
      forget: (name: string) => void kept.delete(name),
    },
  };
  const set = createPulseQueue();
  const clear = createPulseQueue();
  const fake = fakeContext(definition, { params, inputs: { pose, set, clear }, services: { session: session as never } });
  const node = create(fake.ctx);
  const frame = Object.assign(createSessionFrame(), { xr });
  const { outputs } = fake.ctx;
  const step = () => {
    spatial.enterFrame(frame);
    node.update(frame);
    set.clear();
    clear.clear();
    return { x: outputs.pose.valid ? outputs.pose.worldFromPose[12] : null, state: outputs.state.value };
  };
  /** With the pose as it is from this frame on; null for none. */
  const stepAt = (x: number | null) => {
    if (pose) writePose(pose, x === null ? null : at(x), 0);
    return step();
  };
  return { ...fake, named, kept, spatial, node, session, anchors, set, clear, frame, step, stepAt };
}

const NONE = { x: null, state: '' };

describe('world/anchor', () => {
  test('keeps the pose that becomes valid, whatever comes after', () => {
    const { ctx, spatial, stepAt } = start();
    expect(stepAt(null)).toEqual(NONE);
    expect(stepAt(1)).toEqual({ x: 1, state: 'tracked' });
    expect(ctx.outputs.tracked.value).toBe(true);
    expect(stepAt(2)).toEqual({ x: 1, state: 'tracked' });
    expect(stepAt(null)).toEqual({ x: 1, state: 'tracked' });
    expect(stepAt(3)).toEqual({ x: 3, state: 'tracked' });
    expect(spatial.counts().anchors).toBe(1);
  });

  test('keeps the pose at a pulse, and that alone where it is set to pulses', () => {
    const { spatial, set, step, stepAt } = start({ params: { when: 'set' } });
    expect(stepAt(1)).toEqual(NONE);
    set.emit().setPose(at(9));
    expect(step().x).toBe(1);
    expect(stepAt(2).x).toBe(1);
    set.emit();
    expect(step().x).toBe(2);
    set.emit();
    expect(stepAt(null).x).toBe(2);
    expect(spatial.counts().anchors).toBe(1);
  });

  test('keeps the poses of pulses without a pose at its input', () => {
    const { set, step } = start({ pose: null });
    expect(step()).toEqual(NONE);
    set.emit();
    expect(step()).toEqual(NONE);
    set.emit().setPose(at(4));
    set.emit().setPose(at(5));
    expect(step()).toEqual({ x: 5, state: 'tracked' });
  });

  test('keeps its pose at a pulse whose pose is none', () => {
    const { anchors, set, step } = start({ pose: null });
    set.emit().setPose(at(4));
    step();
    for (const broken of [at(Number.NaN), new Float32Array(16)]) {
      set.emit().setPose(broken);
      expect(step()).toEqual({ x: 4, state: 'tracked' });
    }
    expect(anchors).toHaveLength(1);
  });

  test('gives the pose and the state that the device gives', () => {
    const { ctx, anchors, step, stepAt } = start();
    stepAt(1);
    const device = anchors[0] as { state: AnchorState; readonly worldFromAnchor: Float32Array };
    device.worldFromAnchor.set(at(1.5));
    for (const state of ['pending', 'lost', 'deleted'] as const) {
      device.state = state;
      expect(step()).toEqual({ x: 1.5, state });
      expect(ctx.outputs.tracked.value).toBe(false);
    }
  });

  test('holds the pose in world space where the session has no anchors, and says so', () => {
    const { ctx, stepAt } = start({ xr: { capabilities: new Set() } });
    expect(stepAt(1)).toEqual({ x: 1, state: 'unsupported' });
    expect(stepAt(2)).toEqual({ x: 1, state: 'unsupported' });
    expect(ctx.outputs.tracked.value).toBe(false);
  });

  test('raises the jumps of its pose at re-centering and with each anchor', () => {
    const { ctx, frame, set, step, stepAt } = start();
    stepAt(1);
    const { jumps } = ctx.outputs.pose;
    step();
    expect(ctx.outputs.pose.jumps).toBe(jumps);
    frame.jumps++;
    step();
    expect(ctx.outputs.pose.jumps).toBe(jumps + 1);
    set.emit();
    step();
    expect(ctx.outputs.pose.jumps).toBe(jumps + 2);
  });

  test('is removed by a pulse', () => {
    const { spatial, clear, step, stepAt } = start();
    stepAt(1);
    clear.emit();
    expect(step()).toEqual(NONE);
    expect(spatial.counts().anchors).toBe(0);
    expect(step()).toEqual(NONE);
  });

  test('ends with the session; in the next one the pose becomes valid again', () => {
    const { session, spatial, stepAt } = start();
    stepAt(1);
    session.sessions++;
    spatial.leaveSession();
    expect(stepAt(null)).toEqual(NONE);
    expect(stepAt(2).x).toBe(2);
    session.sessions++;
    spatial.leaveSession();
    expect(stepAt(3).x).toBe(3);
    expect(spatial.counts().anchors).toBe(1);
  });

  describe('over visits', () => {
    const NODE = 'anchor-test';
    const earlier = (state: AnchorState): Anchor & { state: AnchorState; deletes: number } => ({
      id: 'earlier',
      state,
      worldFromAnchor: Float32Array.from(at(7)),
      keeping: 'kept',
      evicted: 0,
      deletes: 0,
      delete() {
        this.deletes++;
      },
    });
    const again = (anchor: Anchor | null, params: Params = {}) => {
      const stage = start({ params: { keep: true, ...params } });
      if (anchor) stage.kept.set(NODE, anchor);
      return stage;
    };

    test('asks the device to keep it under the name of the node, and only if it is set to', () => {
      const keeps = again(null);
      keeps.stepAt(1);
      expect(keeps.named).toEqual([NODE]);
      const { named, stepAt } = start();
      stepAt(1);
      expect(named).toEqual([]);
    });

    test('says once that the device keeps none, as in a session without anchors', () => {
      const { ctx, reports, stepAt, step } = again(null);
      expect(stepAt(1)).toEqual({ x: 1, state: 'tracked' });
      step();
      expect(reports).toEqual([expect.objectContaining({ code: 'SCR057', severity: 'info' })]);
      expect(ctx.outputs.kept.value).toBe(false);
    });

    test('says that an older one was forgotten for it', () => {
      const { ctx, reports, session, stepAt } = again(null);
      session.anchors.create = () => ({ ...earlier('tracked'), evicted: 1 });
      stepAt(1);
      expect(reports).toEqual([expect.objectContaining({ code: 'SCR057', severity: 'warning' })]);
      expect(ctx.outputs.kept.value).toBe(true);
    });

    test('has no pose until the device has found the place of an earlier visit, and keeps that place', () => {
      const anchor = earlier('pending');
      const { ctx, named, stepAt } = again(anchor);
      expect(stepAt(null)).toEqual({ x: null, state: 'pending' });
      expect(stepAt(1)).toEqual({ x: null, state: 'pending' });
      const { jumps } = ctx.outputs.pose;
      anchor.state = 'tracked';
      expect(stepAt(2)).toEqual({ x: 7, state: 'tracked' });
      expect([ctx.outputs.pose.jumps, named]).toEqual([jumps + 1, []]);
      anchor.state = 'lost';
      expect(stepAt(3)).toEqual({ x: 7, state: 'lost' });
    });

    test('makes a new one where the device no longer has it', () => {
      const anchor = earlier('pending');
      const { named, stepAt } = again(anchor);
      stepAt(1);
      anchor.state = 'deleted';
      expect(stepAt(2)).toEqual({ x: 2, state: 'tracked' });
      expect(named).toEqual([NODE]);
    });

    test('is replaced by a pulse, and forgotten by another', () => {
      const anchor = earlier('tracked');
      const { kept, named, set, clear, step, stepAt } = again(anchor);
      stepAt(1);
      set.emit();
      expect([step(), anchor.deletes, named]).toEqual([{ x: 1, state: 'tracked' }, 1, [NODE]]);
      clear.emit();
      expect([step(), kept.has(NODE)]).toEqual([NONE, false]);
    });

    test('stays kept when the program is reset or ends', () => {
      const { node, kept, step } = again(earlier('tracked'));
      step();
      node.reset?.();
      expect(step()).toEqual({ x: 7, state: 'tracked' });
      node.dispose();
      expect(kept.has(NODE)).toBe(true);
    });
  });

  test('leaves nothing behind, and begins anew after a reset', () => {
    const { node, spatial, step, stepAt } = start();
    stepAt(1);
    node.reset?.();
    expect(spatial.counts().anchors).toBe(0);
    expect(step().x).toBe(1);
    node.dispose();
    expect(spatial.counts().anchors).toBe(0);
  });
});
