import type { DrawOperation, NodeOperation } from '../../program/program.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { DrawBinding } from '../scene-backend.ts';
import { createSlotView, type Slots } from '../values/slots.ts';
import { isDraw } from './node-key.ts';

/** The room depth that hides what a node draws, and the params of that. */
export interface Occlusion {
  readonly binding: NonNullable<DrawBinding['occlusion']>;
  point(operation: NodeOperation, slots: Slots): void;
}

/** Null for a node that draws nothing, or whose objects nothing in the room hides. */
export function createOcclusion(operation: NodeOperation, resources: LiveResources, slots: Slots): Occlusion | null {
  const occlusion = occlusionOf(operation);
  if (!occlusion) return null;
  const views = Object.entries(occlusion.params).map(([name, slot]) => ({ name, view: createSlotView(slots, slot) }));
  return {
    binding: {
      roomDepth: liveResource(resources, occlusion.roomDepth, 'room-depth').depth,
      params: Object.fromEntries(views.map(({ name, view }) => [name, view])) as NonNullable<DrawBinding['occlusion']>['params'],
    },
    point: (next, nextSlots) => {
      for (const { name, view } of views) view.point(nextSlots, occlusionOf(next)?.params[name] ?? -1);
    },
  };
}

function occlusionOf(operation: NodeOperation): DrawOperation['occlusion'] {
  return isDraw(operation) ? operation.occlusion : null;
}
