import { Vector3 } from 'three';
import type { Hit } from '../../kit/hit-test.ts';
import { pointerById } from '../../kit/pointers.ts';
import type { Pointer, SessionFrame } from '../../kit/session.ts';
import type { Placement } from './placement.ts';
import { canPinch, type Span, writeSpan } from './span.ts';

/** What a press does to the placed objects: one pointer drags them, two scale and rotate them. */
export interface Grip {
  /** Whether a press holds the objects. */
  readonly isHeld: boolean;
  /** Whether another press can take part. */
  accepts(pointer: Pointer, frame: SessionFrame): boolean;
  /** A press that `accepts` has accepted. */
  begin(pointer: Pointer): void;
  /**
   * Moves the objects. Once a frame.
   *
   * @param hitOf The surface that a pointer meets, if the objects may stand there.
   * @returns How a gesture has ended in this frame that changed them; null otherwise.
   */
  update(frame: SessionFrame, hitOf: (pointer: Pointer) => Hit | null, limits: ScaleLimits): 'changed' | 'undone' | null;
  /** The pose has changed for another reason: nothing is held. */
  letGo(): void;
}

export interface ScaleLimits {
  readonly minScale: number;
  readonly maxScale: number;
}

/** A pointer that moves less does not drag: hands and devices tremble. */
const STILL_RAD = 0.01;
/** Normals of one surface differ less. */
const COS_SAME_SURFACE = Math.cos((15 * Math.PI) / 180);

// Filled and read within one call.
const scratchPoint = new Vector3();
const scratchNormal = new Vector3();
const scratchSpan: Span = { length: 0, angleRad: 0 };

export function createGrip(placement: Placement): Grip {
  /** Ids; 0 for none. */
  let first = 0;
  let second = 0;
  /** The objects have changed since the gesture began. */
  let hasChanged = false;
  let jumps = 0;

  /** Of a drag: from the hit to the objects, as it was at its start. */
  const offsetM = new Vector3();
  const startHitM = new Vector3();
  const startNormal = new Vector3();
  let hasStart = false;
  let isDragging = false;

  /** Of a pinch: in the last frame. */
  const lastSpan: Span = { length: 0, angleRad: 0 };
  let hasSpan = false;

  /** Before the gesture, in case the system cancels the press. */
  const before = { positionM: new Vector3(), rotation: placement.rotation.clone(), turnRad: 0, scale: 1 };

  function restart(): void {
    hasStart = false;
    isDragging = false;
    hasSpan = false;
  }
  function letGo(): void {
    first = 0;
    second = 0;
    hasChanged = false;
    restart();
  }
  function undo(): void {
    placement.positionM.copy(before.positionM);
    placement.rotation.copy(before.rotation);
    placement.turnRad = before.turnRad;
    placement.scale = before.scale;
  }

  function drag(hit: Hit): void {
    const m = hit.worldFromHit;
    scratchPoint.fromArray(m, 12);
    scratchNormal.fromArray(m, 4);
    if (!hasStart) {
      hasStart = true;
      offsetM.copy(placement.positionM).sub(scratchPoint);
      startHitM.copy(scratchPoint);
      startNormal.copy(scratchNormal);
    }
    isDragging ||= scratchPoint.distanceTo(startHitM) > STILL_RAD * hit.distanceM;
    if (!isDragging) return;
    placement.release();
    hasChanged = true;
    // On another surface the offset means nothing.
    if (startNormal.dot(scratchNormal) >= COS_SAME_SURFACE) scratchPoint.add(offsetM);
    else offsetM.set(0, 0, 0);
    placement.slide(scratchPoint, scratchNormal);
  }

  function pinch(a: Pointer, b: Pointer, frame: SessionFrame, { minScale, maxScale }: ScaleLimits): void {
    const view = frame.views[0];
    if (!view || !writeSpan(scratchSpan, a, b, view, placement.rotation)) return;
    if (hasSpan) {
      const turnedRad = scratchSpan.angleRad - lastSpan.angleRad;
      placement.turnRad += Math.atan2(Math.sin(turnedRad), Math.cos(turnedRad));
      const scale = (placement.scale * scratchSpan.length) / lastSpan.length;
      placement.scale = Math.min(Math.max(scale, minScale), Math.max(minScale, maxScale));
      hasChanged ||= placement.scale !== before.scale || placement.turnRad !== before.turnRad;
    }
    hasSpan = true;
    lastSpan.length = scratchSpan.length;
    lastSpan.angleRad = scratchSpan.angleRad;
  }

  return {
    get isHeld() {
      return first !== 0;
    },
    accepts: (pointer, { input }) => {
      if (second !== 0) return false;
      if (first === 0) return true;
      const holder = pointerById(input, first);
      return holder !== null && canPinch(holder, pointer);
    },
    begin: (pointer) => {
      if (first === 0) {
        first = pointer.id;
        before.positionM.copy(placement.positionM);
        before.rotation.copy(placement.rotation);
        before.turnRad = placement.turnRad;
        before.scale = placement.scale;
      } else second = pointer.id;
      restart();
    },
    update: (frame, hitOf, limits) => {
      if (first === 0) return null;
      // The start of a drag was measured in another world space.
      if (frame.jumps !== jumps && !isDragging) restart();
      jumps = frame.jumps;
      const a = pointerById(frame.input, first);
      const b = second === 0 ? null : pointerById(frame.input, second);
      if (a?.phase === 'cancel' || b?.phase === 'cancel') {
        const wasChanged = hasChanged;
        undo();
        letGo();
        return wasChanged ? 'undone' : null;
      }
      if (a && b) pinch(a, b, frame, limits);
      else if (a && second === 0) {
        const hit = hitOf(a);
        if (hit) drag(hit);
      }
      const aIsOver = a === null || a.phase === 'end' || a.phase === 'hover';
      const bIsOver = b === null || b.phase === 'end' || b.phase === 'hover';
      if (second !== 0 && (aIsOver || bIsOver)) {
        // The one that stays drags on.
        if (aIsOver) first = second;
        second = 0;
        restart();
        if (!aIsOver || !bIsOver) return null;
      } else if (!aIsOver) return null;
      const wasChanged = hasChanged;
      letGo();
      return wasChanged ? 'changed' : null;
    },
    letGo,
  };
}
