import type { PoseOutput } from '../../../nodes/kit/pose.ts';
import type { InputRef, NodeOperation } from '../../program/program.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import { createPoseInput, type PoseInput } from '../values/pose-input.ts';
import { createMergedPulses, type PulseQueue } from '../values/pulses.ts';
import { type AnySlotView, createSlotView, type Slots } from '../values/slots.ts';

/** The inputs, outputs and params of a node as live views: one object each for the lifetime of the node. */
export interface NodePorts {
  readonly inputs: Readonly<Record<string, unknown>>;
  readonly outputs: Readonly<Record<string, unknown>>;
  readonly params: Readonly<Record<string, unknown>>;
  readonly pulseOutputs: readonly (readonly [port: string, queue: PulseQueue])[];
  /** Connects the views to the slots and wires of a recompiled program; the operation is otherwise the same. */
  point(operation: NodeOperation, resources: LiveResources, slots: Slots): void;
}

export function createNodePorts(operation: NodeOperation, resources: LiveResources, slots: Slots): NodePorts {
  /** Views of slots, with a function that finds the slot's number in a later version of the operation. */
  const slotViews: { readonly view: AnySlotView; readonly slotIn: (operation: NodeOperation) => number }[] = [];
  const slotView = (slotIn: (operation: NodeOperation) => number): AnySlotView => {
    const view = createSlotView(slots, slotIn(operation));
    slotViews.push({ view, slotIn });
    return view;
  };
  const carried = (ref: InputRef, refIn: (operation: NodeOperation) => InputRef | undefined): unknown => {
    switch (ref.kind) {
      case 'slot':
        return slotView((op) => slotOf(refIn(op)));
      case 'layer':
        return layerOf(ref.layer.color, resources);
      case 'resource':
        return viewOf(ref.resource, resources);
    }
  };
  /** Poses, with a function that finds the wire in a later version of the operation. */
  const poses: { readonly input: PoseInput; readonly refIn: (operation: NodeOperation) => InputRef | undefined }[] = [];
  const poseInput = (ref: InputRef, refIn: (operation: NodeOperation) => InputRef | undefined): PoseInput => {
    const input = createPoseInput(poseAt(ref, resources));
    poses.push({ input, refIn });
    return input;
  };
  const merged = (operation.pulses ?? []).map((port) => [port, createMergedPulses(queuesAt(operation, port, resources))] as const);
  const mergedAt = new Map(merged);
  const input = (port: string, refs: readonly InputRef[]): unknown => {
    const pulses = mergedAt.get(port);
    if (pulses) return pulses;
    const isPose = operation.poses?.includes(port) ?? false;
    const views = refs.map((ref, i) => (isPose ? poseInput : carried)(ref, (op) => op.inputs[port]?.[i]));
    return operation.multiple.includes(port) ? views : (views[0] ?? null);
  };
  return {
    inputs: Object.fromEntries(Object.entries(operation.inputs).map(([port, refs]) => [port, input(port, refs)])),
    outputs: Object.fromEntries(Object.entries(operation.outputs).map(([port, ref]) => [port, carried(ref, (op) => op.outputs[port])])),
    params: Object.fromEntries(Object.keys(operation.params).map((name) => [name, slotView((op) => op.params[name] ?? -1)])),
    pulseOutputs: Object.entries(operation.outputs).flatMap(([port, ref]) => {
      const resource = ref.kind === 'resource' ? resources.get(ref.resource) : undefined;
      return resource?.kind === 'pulses' ? [[port, resource.queue] as const] : [];
    }),
    point: (next, nextResources, nextSlots) => {
      for (const { view, slotIn } of slotViews) view.point(nextSlots, slotIn(next));
      for (const [port, pulses] of merged) pulses.point(queuesAt(next, port, nextResources));
      for (const { input: pose, refIn } of poses) pose.point(poseAt(refIn(next), nextResources));
    },
  };
}

function queuesAt({ inputs }: NodeOperation, port: string, resources: LiveResources): PulseQueue[] {
  return (inputs[port] ?? []).flatMap((ref) => (ref.kind === 'resource' ? [liveResource(resources, ref.resource, 'pulses').queue] : []));
}

function poseAt(ref: InputRef | undefined, resources: LiveResources): PoseOutput {
  return liveResource(resources, ref?.kind === 'resource' ? ref.resource : '', 'pose').pose;
}

function slotOf(ref: InputRef | undefined): number {
  return ref?.kind === 'slot' ? ref.slot : -1;
}

/** The layer object that a node reads or writes at a port; null for a render target, which only the runtime draws and reads. */
function layerOf(id: string, resources: LiveResources): unknown {
  const resource = resources.get(id);
  return resource?.kind === 'external' ? resource.layer : null;
}

/**
 * The object through which a node reads or writes a resource. Throws for kinds of resources that have none, which is a programming error.
 */
function viewOf(id: string, resources: LiveResources): object {
  const resource = resources.get(id);
  switch (resource?.kind) {
    case 'objects':
    case 'lights':
    case 'bodies':
      return resource.list;
    case 'room-depth':
      return resource.depth;
    case 'environment':
      return resource.environment;
    case 'external':
      return resource.layer;
    case 'sound':
      return resource.live.sound;
    case 'pulses':
      return resource.queue;
    case 'pose':
      return resource.pose;
    case 'capture':
      return resource.place;
    case 'pixels':
      return resource.pixels;
    case 'technique':
      return resource.technique.view;
    case 'target':
    case 'table':
    case 'shadow-maps':
    case undefined:
      throw new Error(`The program has no resource ${id} that a node can read or fill.`);
  }
}
