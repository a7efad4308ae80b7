import { Matrix4, Vector3 } from 'three';
import { deriveObjects } from '../../kit/derive-objects.ts';
import type { Hit } from '../../kit/hit-test.ts';
import { claimPointer } from '../../kit/pointers.ts';
import { writePose } from '../../kit/pose.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Pointer, SessionFrame } from '../../kit/session.ts';
import { surfaceOrientation } from '../../kit/surface-pose.ts';
import type { definition } from './definition.ts';
import { createGrip } from './grip.ts';
import { createPlacement } from './placement.ts';
import { meetsObjects } from './reach.ts';

const IDENTITY = new Matrix4();

// Filled and read within one call.
const scratchPoint = new Vector3();

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { mode, surfaces, gestures, showBefore, nextSession } = ctx.config;
  const { nearM, minScale, maxScale, snapRad } = ctx.params;
  const { inputs, outputs, session } = ctx;
  const hitTest = session.openHitTest({ from: 'pointers' });
  const placement = createPlacement(() => session.anchors);
  const grip = createGrip(placement);
  /** Rigid. */
  const worldFromPose = new Matrix4();
  const worldFromPlaced = new Matrix4();
  const limits = { minScale: 1, maxScale: 1 };
  let isPlaced = false;
  let taps = 0;
  let jumps = 0;
  let frameJumps = 0;
  let lastSession = session.sessions;

  const derived = deriveObjects(outputs.objects, (item) => {
    item.worldFromObject.premultiply(isPlaced ? worldFromPlaced : IDENTITY);
  });

  const hitOf = ({ id }: Pointer): Hit | null => {
    const hits = hitTest.read();
    for (let i = 0; i < hits.count; i++) {
      const hit = hits.at(i);
      if (hit.pointer !== id) continue;
      return surfaces === 'any' || surfaceOrientation(hit.worldFromHit) === surfaces ? hit : null;
    }
    return null;
  };

  function writeMatrices(): void {
    placement.writePose(worldFromPose, snapRad.value);
    worldFromPlaced.copy(worldFromPose).scale(scratchPoint.setScalar(placement.scale));
  }

  function endPlacement(): void {
    grip.letGo();
    placement.release();
    placement.turnRad = 0;
    placement.scale = 1;
    if (isPlaced) outputs.removed.emit().setPose(worldFromPose.elements);
    isPlaced = false;
  }

  function enterSession(frame: SessionFrame): void {
    lastSession = session.sessions;
    jumps++;
    if (!isPlaced) return;
    grip.letGo();
    if (nextSession === 'unplaced') endPlacement();
    else {
      placement.recall(frame);
      placement.fasten(frame);
    }
  }

  function place(hit: Hit, frame: SessionFrame): void {
    const wasPlaced = isPlaced;
    if (wasPlaced && mode === 'once') return;
    grip.letGo();
    placement.stand(hit);
    placement.fasten(frame, hit);
    if (!wasPlaced || mode === 'replace') {
      placement.turnRad = 0;
      placement.scale = Math.min(Math.max(1, minScale.value), Math.max(minScale.value, maxScale.value));
    }
    isPlaced = true;
    taps++;
    jumps++;
    writeMatrices();
    if (wasPlaced && mode === 'move') emitMoved();
    else {
      const pulse = outputs.placed.emit();
      pulse.number = taps;
      pulse.setPose(worldFromPose.elements);
    }
  }

  function emitMoved(): void {
    const pulse = outputs.moved.emit();
    pulse.number = placement.scale;
    pulse.setPose(worldFromPose.elements);
  }

  /** Whether a press that starts belongs to the placed objects. */
  function isMine(pointer: Pointer, frame: SessionFrame): boolean {
    if (!grip.accepts(pointer, frame)) return false;
    // The second finger or hand presses anywhere.
    if (grip.isHeld) return true;
    const hit = hitOf(pointer);
    if (hit && scratchPoint.fromArray(hit.worldFromHit, 12).distanceTo(placement.positionM) <= nearM.value) return true;
    return meetsObjects(pointer.worldFromRay, inputs.objects, worldFromPlaced);
  }

  function take(frame: SessionFrame): void {
    const { input } = frame;
    for (let i = 0; i < input.pointerCount; i++) {
      const pointer = input.pointers[i];
      if (!pointer) continue;
      if (pointer.phase === 'start' && isPlaced && gestures) {
        if (isMine(pointer, frame) && claimPointer(pointer, ctx)) grip.begin(pointer);
      } else if (pointer.phase === 'end' && pointer.tapped && pointer.owner === null) {
        const hit = hitOf(pointer);
        if (hit) place(hit, frame);
      }
    }
  }

  return {
    update: (frame) => {
      // Every frame, because the device starts to follow pointers when it is asked.
      hitTest.read();
      if (frame.jumps !== frameJumps) jumps++;
      frameJumps = frame.jumps;
      if (session.sessions !== lastSession) enterSession(frame);
      if (inputs.remove.count > 0) endPlacement();
      placement.follow();
      if (isPlaced) writeMatrices();
      take(frame);
      limits.minScale = minScale.value;
      limits.maxScale = maxScale.value;
      const ended = grip.update(frame, hitOf, limits);
      if (isPlaced) writeMatrices();
      if (ended) placement.fasten(frame);
      if (ended === 'changed') emitMoved();
      writePose(outputs.pose, isPlaced ? worldFromPose.elements : null, jumps);
      outputs.isPlaced.value = isPlaced;
      outputs.scale.value = placement.scale;
      derived.update(inputs.objects, isPlaced || showBefore);
    },
    reset: () => {
      grip.letGo();
      placement.release();
      placement.turnRad = 0;
      placement.scale = 1;
      isPlaced = false;
      taps = 0;
      jumps = 0;
      frameJumps = 0;
    },
    dispose: () => {
      placement.release();
      hitTest.close();
    },
  };
}
