import { describe, expect, test } from '@jest/globals';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { createPose, type PoseOutput, type PoseView, writePose } from '../../../nodes/kit/pose.ts';
import type { NodeModule, PulseList, PulseOutput } from '../../../nodes/kit/runtime.ts';
import { pulseNumbers } from '../../../tests/support/node-context.ts';
import type { NodeOperation } from '../../program/program.ts';
import { createDiagnosticsBoard } from '../diagnostics-board.ts';
import type { LiveResource } from '../resources/resources.ts';
import { createPulseQueue, type PulseQueue } from '../values/pulses.ts';
import { createSlots } from '../values/slots.ts';
import { createNodeInstance, type NodeHost, type NodeInstance } from './node-instance.ts';
import { nodeKey } from './node-key.ts';

const NO_SLOTS = createSlots({ numbers: [], texts: [], slots: [], params: {} });

/** A node that gives a pulse for each that it takes, `factor` times. */
function echo(factor: number): NodeModule {
  return {
    create: (ctx) => {
      const { go } = ctx.inputs as { readonly go: PulseList };
      const { out } = ctx.outputs as { readonly out: PulseOutput };
      return {
        update: () => {
          for (let i = 0; i < go.count; i++) for (let copy = 0; copy < factor; copy++) out.emit(go.at(i));
        },
        dispose: () => {},
      };
    },
  };
}

function operation(...from: string[]): NodeOperation {
  return {
    id: 'echo-a',
    node: 'echo-a',
    kind: 'value',
    type: 'test/echo',
    view: 'once',
    reads: from,
    writes: ['out'],
    inputs: { go: from.map((resource) => ({ kind: 'resource', resource })) },
    multiple: ['go'],
    pulses: ['go'],
    outputs: { out: { kind: 'resource', resource: 'out' } },
    params: {},
    config: {},
    assets: {},
  };
}

function start(factor: number, ...from: string[]) {
  const queues: Record<string, PulseQueue> = { a: createPulseQueue(), b: createPulseQueue(), out: createPulseQueue() };
  const resources = new Map(Object.entries(queues).map(([id, queue]): [string, LiveResource] => [id, { kind: 'pulses', queue }]));
  const told: (readonly Diagnostic[])[] = [];
  const host = {
    modules: { 'test/echo': echo(factor) },
    seed: 1,
    board: createDiagnosticsBoard((diagnostics) => told.push(diagnostics)),
    assets: { serviceFor: () => ({}) },
  } as unknown as NodeHost;
  const instance: NodeInstance = createNodeInstance(host, 'key', operation(...from), resources, NO_SLOTS, [], null);
  const frame = (a: number[], b: number[]): number[] => {
    for (const queue of Object.values(queues)) queue.clear();
    for (const number of a) if (queues.a) queues.a.emit().number = number;
    for (const number of b) if (queues.b) queues.b.emit().number = number;
    instance.runtime.update({} as never);
    return queues.out ? pulseNumbers(queues.out) : [];
  };
  return { frame, told, rewire: (...next: string[]) => instance.point(operation(...next), resources, NO_SLOTS) };
}

describe('poses of a node', () => {
  const follower: NodeModule = {
    create: (ctx) => {
      const { at, unwired } = ctx.inputs as { readonly at: PoseView; readonly unwired: PoseView | null };
      const { out } = ctx.outputs as { readonly out: PoseOutput };
      return { update: () => writePose(out, at.valid && unwired === null ? at.worldFromPose : null, at.jumps), dispose: () => {} };
    },
  };
  const following = (from: string): NodeOperation => ({
    ...operation(),
    type: 'test/follower',
    reads: [from],
    inputs: { at: [{ kind: 'resource', resource: from }], unwired: [] },
    multiple: [],
    pulses: [],
    poses: ['at', 'unwired'],
  });

  test('are read in the frame in which they are written, and by another wire after a recompile', () => {
    const poses = { a: createPose(), b: createPose(), out: createPose() };
    const resources = new Map(Object.entries(poses).map(([id, pose]): [string, LiveResource] => [id, { kind: 'pose', pose }]));
    const host = {
      modules: { 'test/follower': follower },
      seed: 1,
      board: createDiagnosticsBoard(() => {}),
      assets: { serviceFor: () => ({}) },
    };
    const instance = createNodeInstance(host as unknown as NodeHost, 'key', following('a'), resources, NO_SLOTS, [], null);
    const at = (x: number) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1];
    const frame = () => {
      instance.runtime.update({} as never);
      return poses.out.valid ? poses.out.worldFromPose[12] : null;
    };
    expect(frame()).toBe(null);
    writePose(poses.a, at(1), 5);
    writePose(poses.b, at(2), 0);
    expect(frame()).toBe(1);
    const { jumps } = poses.out;
    instance.point(following('b'), resources, NO_SLOTS);
    expect(frame()).toBe(2);
    expect(poses.out.jumps).toBeGreaterThan(jumps);
    const key = (from: string) =>
      nodeKey(
        following(from),
        () => 'none',
        () => null,
      );
    expect(key('a')).toBe(key('b'));
  });
});

describe('pulses of a node', () => {
  test('come in wire by wire, and not at all where the input is not connected', () => {
    expect(start(1, 'b', 'a').frame([1, 2], [3])).toEqual([3, 1, 2]);
    expect(start(1).frame([1, 2], [3])).toEqual([]);
  });

  test('come by other wires after a recompile, in which the node lives on', () => {
    const { frame, rewire } = start(1, 'a');
    expect(frame([1], [2])).toEqual([1]);
    rewire('b');
    expect(frame([1], [2])).toEqual([2]);
    const key = (...from: string[]) =>
      nodeKey(
        operation(...from),
        () => 'none',
        () => null,
      );
    expect(key('a')).toBe(key('b', 'a'));
  });

  test('beyond what goes through are dropped, and the user is told once', () => {
    const { frame, told } = start(5, 'a');
    expect(frame([1, 2, 3], [])).toHaveLength(15);
    expect(told).toEqual([]);
    expect(frame([1, 2, 3, 4], [])).toHaveLength(16);
    frame([1, 2, 3, 4], []);
    expect(told).toMatchObject([[{ code: 'SCR056', severity: 'warning', nodeId: 'echo-a', port: 'out' }]]);
  });
});
