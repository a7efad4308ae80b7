import { Vector3 } from 'three';
import type { Hit } from '../../kit/hit-test.ts';
import { canPinch, type PointerSpan, writePointerSpan } from '../../kit/pointer-span.ts';
import { pointerById } from '../../kit/pointers.ts';
import type { Pointer, SessionFrame } from '../../kit/session.ts';
import { restorePose, type Spot, type SpotState, stateOf } from './spot.ts';

/** The gesture by which a visitor moves a placed copy: one pointer drags it, two pointers scale and rotate it. */
export interface Grip {
  /** The copy that the gesture holds; null if there is no gesture. */
  readonly held: Spot | null;
  /** Whether a pointer can begin a gesture, or take part in the current one as the second pointer. */
  accepts(pointer: Pointer, frame: SessionFrame): boolean;
  /** Adds a pointer that `accepts` has accepted. If no copy is held, the gesture begins and holds `spot`. */
  begin(pointer: Pointer, spot: Spot): void;
  /**
   * Moves the held copy. Call it once per frame.
   *
   * @param hitOf Returns where a pointer meets a surface on which the objects may stand; null if it meets none.
   * @returns The outcome, if a gesture that changed the copy has ended in this frame; null otherwise.
   */
  update(frame: SessionFrame, hitOf: (pointer: Pointer) => Hit | null, limits: ScaleLimits): GripEnd | null;
  /** Ends the gesture without undoing it, because the pose has changed for another reason. */
  letGo(): void;
  /** Undoes the gesture and ends it. */
  cancel(): GripEnd | null;
}

export interface GripEnd {
  readonly outcome: 'changed' | 'undone';
  /** The state of the copy before the gesture. */
  readonly before: SpotState;
}

export interface ScaleLimits {
  readonly minScale: number;
  readonly maxScale: number;
}

/** A pointer that has turned less does not drag, because hands and devices tremble. */
const STILL_RAD = 0.01;
/** Cosine of the greatest angle between two normals that still belong to the same surface. */
const COS_SAME_SURFACE = Math.cos((15 * Math.PI) / 180);

// Filled and read within one call.
const scratchPoint = new Vector3();
const scratchNormal = new Vector3();
const scratchSpan: PointerSpan = { lengthM: 0, angleRad: 0 };

/**
 * Creates a grip.
 *
 * @param owner The object that has claimed the presses.
 */
export function createGrip(owner: object): Grip {
  let spot: Spot | null = null;
  /** The state of the held copy before the gesture, to restore it if the system cancels the press or a hand is lost. */
  let before: SpotState | null = null;
  /** Ids of the two pointers; 0 for none. */
  let first = 0;
  let second = 0;
  /** Whether the gesture has changed the copy. */
  let hasChanged = false;
  let jumps = 0;

  /** For a drag: the offset from the hit to the copy at its start. */
  const offsetM = new Vector3();
  const startHitM = new Vector3();
  const startNormal = new Vector3();
  let hasStart = false;
  let isDragging = false;

  /** For a pinch: the span between the pointers in the last frame. */
  const lastSpan: PointerSpan = { lengthM: 0, angleRad: 0 };
  let hasSpan = false;

  function restart(): void {
    hasStart = false;
    isDragging = false;
    hasSpan = false;
  }
  function letGo(): void {
    spot = null;
    before = null;
    first = 0;
    second = 0;
    hasChanged = false;
    restart();
  }
  /** Ends the gesture and returns how. Reads `before` first, because `letGo` clears it. */
  function end(outcome: GripEnd['outcome']): GripEnd | null {
    const ended = hasChanged && before ? { outcome, before } : null;
    letGo();
    return ended;
  }
  function isLost(pointer: Pointer): boolean {
    return pointer.owner !== null && pointer.owner !== owner;
  }
  function cancel(): GripEnd | null {
    if (before) restorePose(before);
    return end('undone');
  }

  function drag({ placement }: Spot, hit: Hit): void {
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

  function pinch({ placement }: Spot, a: Pointer, b: Pointer, frame: SessionFrame, { minScale, maxScale }: ScaleLimits): void {
    const view = frame.views[0];
    if (!view || !writePointerSpan(scratchSpan, a, b, view, placement.rotation)) return;
    if (hasSpan) {
      const turnedRad = scratchSpan.angleRad - lastSpan.angleRad;
      placement.turnRad += Math.atan2(Math.sin(turnedRad), Math.cos(turnedRad));
      const scale = (placement.scale * scratchSpan.lengthM) / lastSpan.lengthM;
      placement.scale = Math.min(Math.max(scale, minScale), Math.max(minScale, maxScale));
      hasChanged ||= placement.scale !== before?.scale || placement.turnRad !== before.turnRad;
    }
    hasSpan = true;
    lastSpan.lengthM = scratchSpan.lengthM;
    lastSpan.angleRad = scratchSpan.angleRad;
  }

  return {
    get held() {
      return spot;
    },
    accepts: (pointer, { input }) => {
      if (second !== 0) return false;
      if (first === 0) return true;
      const holder = pointerById(input, first);
      return holder !== null && canPinch(holder, pointer);
    },
    begin: (pointer, pressed) => {
      if (first === 0) {
        first = pointer.id;
        spot = pressed;
        before = stateOf(pressed);
      } else second = pointer.id;
      restart();
    },
    update: (frame, hitOf, limits) => {
      if (spot === null) return null;
      // The start of a drag was measured in another world space.
      if (frame.jumps !== jumps && !isDragging) restart();
      jumps = frame.jumps;
      const a = pointerById(frame.input, first);
      const b = second === 0 ? null : pointerById(frame.input, second);
      // A press that is gone without an end, as that of a hand that is no longer tracked, is canceled too.
      if (a === null || a.phase === 'cancel' || (second !== 0 && (b === null || b.phase === 'cancel'))) return cancel();
      // Something nearer has claimed the press after this node did.
      if (isLost(a) || (b && isLost(b))) return cancel();
      if (b) pinch(spot, a, b, frame, limits);
      else {
        const hit = hitOf(a);
        if (hit) drag(spot, hit);
      }
      const aIsOver = a.phase === 'end' || a.phase === 'hover';
      if (b === null) return aIsOver ? end('changed') : null;
      const bIsOver = b.phase === 'end' || b.phase === 'hover';
      if (aIsOver && bIsOver) return end('changed');
      if (!aIsOver && !bIsOver) return null;
      // The one that stays drags on.
      if (aIsOver) first = second;
      second = 0;
      restart();
      return null;
    },
    letGo,
    cancel,
  };
}
