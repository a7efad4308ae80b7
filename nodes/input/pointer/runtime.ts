import { claimPointer, handOf } from '../../kit/pointers.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Pointer, SessionInput } from '../../kit/session.ts';
import type { definition } from './definition.ts';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { by, claims } = ctx.config;
  const { outputs } = ctx;
  /** Id of the pointer that is followed; 0 for none. */
  let followed = 0;
  /** How many times the node has changed to another pointer; each change raises `jumps` of its poses. */
  let switches = 0;

  function matters(pointer: Pointer): boolean {
    // Another node has claimed the press.
    if (pointer.owner !== null && pointer.owner !== ctx) return false;
    const hand = handOf(pointer.by);
    switch (by) {
      case 'any':
        return true;
      case 'screen':
        return pointer.by === 'screen' || pointer.by === 'mouse';
      case 'left':
      case 'right':
        return hand === by;
    }
  }

  /** The followed pointer while it is pressed, else the first that is pressed, else the followed one, else the first. */
  function choose(input: SessionInput): Pointer | null {
    let best: Pointer | null = null;
    let bestRank = -1;
    for (let i = 0; i < input.pointerCount; i++) {
      const pointer = input.pointers[i];
      if (!pointer || !matters(pointer)) continue;
      const rank = (pointer.phase === 'hover' ? 0 : 2) + (pointer.id === followed ? 1 : 0);
      if (rank <= bestRank) continue;
      best = pointer;
      bestRank = rank;
    }
    return best;
  }

  return {
    update: ({ input, jumps }) => {
      const pointer = choose(input);
      if (pointer && pointer.id !== followed) switches++;
      followed = pointer?.id ?? 0;
      if (pointer && claims) claimPointer(pointer, ctx);
      const phase = pointer?.phase ?? 'hover';
      writePose(outputs.pose, pointer?.worldFromRay ?? null, jumps + switches);
      writePose(outputs.grip, pointer?.worldFromGrip ?? null, jumps + switches);
      outputs.pressed.value = phase === 'start' || phase === 'hold';
      outputs.pinch.value = pointer?.pinch ?? 0;
      if (pointer && phase === 'start') outputs.started.emit().setPose(pointer.worldFromRay);
      if (pointer && (phase === 'end' || phase === 'cancel')) {
        const pulse = outputs.ended.emit();
        pulse.number = phase === 'cancel' ? -1 : Number(pointer.tapped);
        pulse.setPose(pointer.worldFromRay);
      }
    },
    reset: () => {
      followed = 0;
      switches = 0;
    },
    dispose: () => {},
  };
}
