import { createHit } from '../../kit/hit-test.ts';
import { claimPointer, handOf, pointerById, rayTurnRad, TAP_TURN_RAD } from '../../kit/pointers.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime, PulseOutput } from '../../kit/runtime.ts';
import type { Pointer, SessionFrame } from '../../kit/session.ts';
import { castAtObjects, createObjectHit, type ObjectHit } from './cast-objects.ts';
import type { definition } from './definition.ts';
import { copyPicked, createPicked, isSameObject, type Picked, writePicked } from './picked.ts';
import { createPresses } from './presses.ts';

const ROOM = ['depth'] as const;

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { from, claims } = ctx.config;
  const { inputs, outputs, session } = ctx;
  const met = createObjectHit();
  const roomHit = createHit();
  const presses = createPresses();
  /** `current`: what the ray met at the end of the last frame. `before`: what the outputs reported in the previous update. */
  const current = createPicked();
  const before = createPicked();
  const candidate = createPicked();
  const normal = new Float64Array(3);
  let switches = 0;

  function listensTo({ by }: Pointer): boolean {
    switch (from) {
      case 'pointers':
        return true;
      case 'screen':
        return by === 'screen' || by === 'mouse';
      case 'left':
      case 'right':
        return handOf(by) === from;
      case 'center':
      case 'ray':
        return false;
    }
  }

  /** Casts a ray at the virtual objects and returns the first hit. Returns null if a phantom or the room hides it. */
  function meet(worldFromRay: ArrayLike<number>): ObjectHit | null {
    castAtObjects(met, worldFromRay, inputs.objects);
    if (met.item?.role !== 'virtual') return null;
    const hidden =
      inputs.depth !== null &&
      session.castRay(worldFromRay, roomHit, ROOM) &&
      roomHit.distanceM < met.distanceM - Math.max(0, ctx.params.toleranceM.value);
    return hidden ? null : met;
  }

  function lookAlong(worldFromRay: ArrayLike<number>, frame: SessionFrame): void {
    if (meet(worldFromRay)) writePicked(current, met, worldFromRay, 0, frame);
  }

  function lookAtPointers(frame: SessionFrame): void {
    const { input } = frame;
    let bestRank = 0;
    for (let i = 0; i < input.pointerCount; i++) {
      const pointer = input.pointers[i];
      if (!pointer || !listensTo(pointer) || !meet(pointer.worldFromRay)) continue;
      writePicked(candidate, met, pointer.worldFromRay, pointer.id, frame);
      // Where the node that moves the object has claimed the press, it is told here too, and stays with that node.
      if (claims && pointer.owner !== candidate.claimant) claimPointer(pointer, ctx, candidate.distanceM);
      if (pointer.owner !== null && !isOurs(pointer, candidate)) continue;
      if (pointer.phase === 'start') presses.begin(candidate, pointer.worldFromRay);
      const rank = (presses.has(pointer.id) ? 4 : 0) + (pointer.id === before.pointer ? 2 : 0) + 1;
      if (rank <= bestRank) continue;
      bestRank = rank;
      copyPicked(current, candidate);
    }
  }

  function isOurs(pointer: Pointer, picked: Picked): boolean {
    return pointer.owner === ctx || pointer.owner === picked.claimant || (!claims && pointer.owner === null);
  }

  return {
    update: ({ input, jumps }) => {
      for (let i = 0; i < presses.all.length; i++) {
        const press = presses.all[i];
        if (!press || press.state === 'none') continue;
        const pointer = pointerById(input, press.picked.pointer);
        if (!pointer || !isOurs(pointer, press.picked)) {
          press.state = 'none';
          continue;
        }
        if (press.state === 'asked') emit(outputs.pressed, press.picked);
        press.state = 'held';
        press.isDrag ||= rayTurnRad(press.startRay, pointer.worldFromRay) > TAP_TURN_RAD;
        if (pointer.phase === 'end' && pointer.tapped && !press.isDrag) emit(outputs.tapped, press.picked);
        if (pointer.phase === 'end' || pointer.phase === 'cancel') press.state = 'none';
      }
      if (!isSameObject(before, current)) {
        switches++;
        if (before.isMet) emit(outputs.left, before);
        if (current.isMet) emit(outputs.entered, current);
      }
      copyPicked(before, current);
      outputs.isOver.value = current.isMet;
      outputs.isPressed.value = presses.isHeld();
      outputs.key.value = current.key;
      outputs.part.value = current.part;
      outputs.wire.value = current.isMet ? current.wire : -1;
      outputs.copy.value = current.copy;
      outputs.distanceM.value = current.distanceM;
      for (let i = 0; i < 3; i++) normal[i] = current.isMet ? (current.worldFromPoint[4 + i] ?? 0) : 0;
      outputs.normal.value = normal;
      writePose(outputs.pose, current.isMet ? current.worldFromPoint : null, jumps + switches);
    },
    remember: () => {
      const { frame } = session;
      writeNothing(current);
      if (from === 'ray') {
        if (inputs.ray?.valid) lookAlong(inputs.ray.worldFromPose, frame);
      } else if (from === 'center') {
        const [view] = frame.views;
        if (view && frame.viewCount > 0) lookAlong(view.worldFromView, frame);
      } else lookAtPointers(frame);
    },
    reset: () => {
      presses.clear();
      writeNothing(current);
      writeNothing(before);
      switches = 0;
    },
    dispose: () => {},
  };
}

function writeNothing(picked: Picked): void {
  copyPicked(picked, NOTHING);
}

const NOTHING = createPicked();

function emit(output: PulseOutput, { key, copy, worldFromPoint }: Picked): void {
  const pulse = output.emit();
  pulse.text = key;
  pulse.number = copy;
  pulse.setPose(worldFromPoint);
}
