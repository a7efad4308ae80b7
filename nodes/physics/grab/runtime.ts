import { Matrix4, Vector3 } from 'three';
import { grabStrength, writePalm, writePinch } from '../../kit/hands.ts';
import type { PhysicsBody } from '../../kit/physics.ts';
import { claimPointer, handOf, pointerById } from '../../kit/pointers.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import type { Hand, Pointer, SessionInput } from '../../kit/session.ts';
import { castOnBody, distanceToBody } from '../../kit/three/cast-body.ts';
import type { definition } from './definition.ts';
import { createHandBodies } from './hand-bodies.ts';
import { type Carrier, createHold, endHold, type Hold, type Holder } from './holds.ts';

const SIDES = ['left', 'right'] as const;
type Side = (typeof SIDES)[number];

/**
 * A grab begins when the fist or squeeze is above `CLOSED` and ends when it is below `OPEN`. The two thresholds (hysteresis) prevent
 * flicker.
 */
const CLOSED = 0.8;
const OPEN = 0.5;

// Filled and read within one call.
const scratchRay = new Matrix4();
const scratchOrigin = new Vector3();
const scratchDirection = new Vector3();
const scratchPoint = new Vector3();
const scratchMatrix = new Matrix4();
const scratchPose = new Float32Array(16);

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { params, outputs } = ctx;
  const holds: Hold[] = [];
  const hands = createHandBodies(ctx.node, outputs.hands);
  const isClosed: Record<Side, boolean> = { left: false, right: false };
  /** The body that the last search has found, and `foundM`, its distance along the ray or from the hand. */
  let found: PhysicsBody | null = null;
  let foundM = 0;

  function canHold(body: PhysicsBody): boolean {
    if (body.description.mode !== 'dynamic') return false;
    for (const hold of holds) if (hold.body === body) return false;
    return true;
  }
  /** Finds the nearest body within reach of a hand, and writes the position of the hand to `scratchPoint`. */
  function findNear(pose: ArrayLike<number>): void {
    scratchPoint.set(pose[12] ?? 0, pose[13] ?? 0, pose[14] ?? 0);
    found = null;
    foundM = params.reachM.value;
    for (const { bodies } of ctx.inputs.body) {
      for (const body of bodies) {
        const distanceM = canHold(body) ? distanceToBody(body, scratchPoint) : Number.POSITIVE_INFINITY;
        if (distanceM >= foundM) continue;
        foundM = distanceM;
        found = body;
      }
    }
  }
  /** Finds the first body along a ray, and writes the point that the ray meets to `scratchPoint`. */
  function findAlong(worldFromRay: ArrayLike<number>): void {
    readRay(worldFromRay);
    found = null;
    foundM = params.farM.value;
    for (const { bodies } of ctx.inputs.body) {
      for (const body of bodies) {
        const distanceM = canHold(body) ? castOnBody(body, scratchOrigin, scratchDirection) : Number.POSITIVE_INFINITY;
        if (distanceM >= foundM) continue;
        foundM = distanceM;
        found = body;
      }
    }
    scratchPoint.copy(scratchDirection).multiplyScalar(foundM).add(scratchOrigin);
  }
  function add(by: Holder, carrier: Carrier, body: PhysicsBody, input: SessionInput): void {
    const worldFromCarrier = poseOf(by, carrier, input);
    if (!worldFromCarrier) return;
    const settings = { frequencyHz: params.stiffnessHz.value, maxForceN: params.maxForceN.value };
    const pointer = typeof by === 'number' ? pointerById(input, by) : null;
    const hand = typeof by === 'number' ? pointer && handOf(pointer.by) : by;
    holds.push(createHold(`${ctx.node}/${by}`, { by, hand, carrier, body }, worldFromCarrier, scratchPoint, settings));
  }
  /**
   * Claims a press for the body that it would hold. The hold begins in the next frame, unless another node claims the press for something
   * nearer.
   */
  function ask(pointer: Pointer, input: SessionInput): void {
    if (isHand(pointer)) {
      const carrier = handAt(sideOf(pointer), input).tracked ? 'pinch' : 'grip';
      const pose = poseOf(pointer.id, carrier, input);
      if (pose) findNear(pose);
      if (pose && found && claimPointer(pointer, ctx)) {
        add(pointer.id, carrier, found, input);
        return;
      }
    }
    findAlong(pointer.worldFromRay);
    if (found && claimPointer(pointer, ctx, foundM)) add(pointer.id, 'ray', found, input);
  }
  /** A fist grabs the body that it encloses. A squeezed controller grabs the body near its grip, or else the first one along its ray. */
  function close(side: Side, input: SessionInput): void {
    const carrier = handAt(side, input).tracked ? 'palm' : 'grip';
    const pose = poseOf(side, carrier, input);
    if (!pose) return;
    findNear(pose);
    const { worldFromRay, bare } = input[side];
    const isNear = found !== null;
    if (!isNear && worldFromRay && !bare) findAlong(worldFromRay);
    if (found) add(side, isNear ? carrier : 'ray', found, input);
  }
  /** Whether a hold goes on: its press is still down, or its hand still closed. */
  function isHeld({ by, isBegun }: Hold, input: SessionInput): boolean {
    if (typeof by !== 'number') return isClosed[by];
    const pointer = pointerById(input, by);
    if (!pointer || pointer.owner !== ctx) return false;
    return pointer.phase === 'hold' || (pointer.phase === 'start' && !isBegun);
  }
  function begin(hold: Hold, worldFromCarrier: ArrayLike<number>): void {
    hold.isBegun = true;
    hold.body.joints.push(hold.joint);
    const pulse = outputs.grabbed.emit();
    pulse.bodyKey = hold.body.key;
    pulse.setPose(worldFromCarrier);
  }
  function release(index: number): void {
    const [hold] = holds.splice(index, 1);
    if (!hold?.isBegun) return;
    endHold(hold);
    const { velocity, key } = hold.body;
    const pulse = outputs.released.emit();
    pulse.bodyKey = key;
    pulse.number = Math.hypot(velocity[0] ?? 0, velocity[1] ?? 0, velocity[2] ?? 0);
  }
  function followHolders(input: SessionInput): void {
    for (let i = holds.length - 1; i >= 0; i--) {
      const hold = holds[i];
      if (!hold) continue;
      // A body that was recycled is in no world any more.
      if (!hold.body.world || !isHeld(hold, input)) {
        release(i);
        continue;
      }
      // A hand that is lost for a moment stays where it was.
      const pose = poseOf(hold.by, hold.carrier, input);
      if (!pose) continue;
      hold.joint.worldFromTarget.set(scratchMatrix.fromArray(pose).multiply(hold.carrierFromPoint).elements);
      if (!hold.isBegun) begin(hold, pose);
    }
  }
  function isBusy(side: Side): boolean {
    for (const { by, hand, isBegun } of holds) if (isBegun && (by === side || hand === side)) return true;
    return false;
  }
  function forget(): void {
    hands.clear();
    for (const hold of holds.splice(0)) endHold(hold);
    isClosed.left = false;
    isClosed.right = false;
  }

  return {
    update: ({ input }) => {
      for (const side of SIDES) {
        const strength = strengthOf(side, input);
        const isClosing = !isClosed[side] && strength > CLOSED;
        isClosed[side] = strength > (isClosed[side] ? OPEN : CLOSED);
        if (isClosing) close(side, input);
      }
      followHolders(input);
      for (let i = 0; i < input.pointerCount; i++) {
        const pointer = input.pointers[i];
        if (pointer?.phase !== 'start' || pointer.by === 'gaze' || pointer.owner === ctx) continue;
        ask(pointer, input);
      }
      hands.update(input, ctx.clock.deltaS, isBusy);
      outputs.isHeld.value = holds.some(isBegunHold);
    },
    staysOnRepeat: true,
    reset: forget,
    dispose: forget,
  };
}

const isBegunHold = ({ isBegun }: Hold): boolean => isBegun;

function readRay(worldFromRay: ArrayLike<number>): void {
  scratchRay.fromArray(worldFromRay);
  scratchOrigin.setFromMatrixPosition(scratchRay);
  const [, , , , , , , , x, y, z] = scratchRay.elements;
  scratchDirection.set(-x, -y, -z);
}

function isHand({ by }: Pointer): boolean {
  return by === 'left-hand' || by === 'right-hand';
}

function sideOf({ by }: Pointer): Side {
  return handOf(by) ?? 'right';
}

function handAt(side: Side, { leftHand, rightHand }: SessionInput): Hand {
  return side === 'left' ? leftHand : rightHand;
}

/** The current pose of a carrier; null while it is not tracked. Valid until the next call. */
function poseOf(by: Holder, carrier: Carrier, input: SessionInput): ArrayLike<number> | null {
  const pointer = typeof by === 'number' ? pointerById(input, by) : null;
  const side = typeof by === 'number' ? pointer && sideOf(pointer) : by;
  if (side === null) return null;
  switch (carrier) {
    case 'ray':
      return (pointer ?? input[side]).worldFromRay;
    case 'grip':
      return (pointer ?? input[side]).worldFromGrip;
    case 'pinch':
    case 'palm': {
      const hand = handAt(side, input);
      if (!hand.tracked) return null;
      if (carrier === 'pinch') writePinch(scratchPose, hand);
      else writePalm(scratchPose, hand);
      return scratchPose;
    }
  }
}

/** How far a side is closed: the fist of a bare hand, or the squeeze of a controller. */
function strengthOf(side: Side, input: SessionInput): number {
  const hand = handAt(side, input);
  return hand.tracked ? grabStrength(hand) : input[side].squeeze;
}
