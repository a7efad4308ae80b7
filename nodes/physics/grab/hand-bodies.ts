import { writePalm } from '../../kit/hands.ts';
import { type BodyDescription, type BodyList, createPhysicsBody, type PhysicsBody } from '../../kit/physics.ts';
import type { SessionInput } from '../../kit/session.ts';

const SIDES = ['left', 'right'] as const;
type Side = (typeof SIDES)[number];

/** Indices of the hand joints that push bodies: the fingertips, and the knuckles of index, middle and little finger. */
const JOINTS = [4, 9, 14, 19, 24, 6, 11, 21] as const;
const FINGER_M = 0.01;
const PALM_M = 0.032;
/** Time after a release in which the hand does not push; otherwise it would hit what it has thrown. */
const REST_S = 0.4;

const PUSHER: Omit<BodyDescription, 'shapes'> = {
  mode: 'kinematic',
  massKg: 0,
  densityKgPerM3: 0,
  friction: 0.8,
  rollingM: 0,
  restitution: 0,
  linearDamping: 0,
  angularDamping: 0,
  gravityFactor: 0,
};

/** Kinematic bodies that follow bare hands and controllers, so that these push other bodies. */
export interface HandBodies {
  /**
   * Moves the bodies of both sides.
   *
   * @param isBusy Returns whether a side holds something; it then pushes nothing.
   */
  update(input: SessionInput, deltaS: number, isBusy: (side: Side) => boolean): void;
  clear(): void;
}

interface Pusher {
  readonly body: PhysicsBody;
  /** Index of the joint that the body follows; null: it follows the palm, or the grip of a controller. */
  readonly joint: number | null;
}

const scratchPose = new Float32Array(16);

/**
 * Creates the bodies of both hands.
 *
 * @param list Receives the bodies of the sides that are tracked.
 */
export function createHandBodies(node: string, list: BodyList): HandBodies {
  const sides = SIDES.map((side) => ({ side, pushers: createPushers(`${node}/${side}`), restS: 0, isListed: false }));

  function write(): void {
    list.bodies.length = 0;
    for (const { pushers, isListed } of sides) if (isListed) for (const { body } of pushers) list.bodies.push(body);
    list.version++;
  }
  return {
    update: (input, deltaS, isBusy) => {
      let hasChanged = false;
      for (const each of sides) {
        each.restS = isBusy(each.side) ? REST_S : Math.max(each.restS - deltaS, 0);
        const isListed = each.restS === 0 && follow(each.pushers, each.side, input);
        hasChanged ||= isListed !== each.isListed;
        each.isListed = isListed;
      }
      if (hasChanged) write();
    },
    clear: () => {
      for (const each of sides) each.isListed = false;
      write();
    },
  };
}

function createPushers(key: string): Pusher[] {
  const sphere = (name: string, radiusM: number) =>
    createPhysicsBody(`${key}/${name}`, { ...PUSHER, shapes: [{ kind: 'sphere', centerM: [0, 0, 0], radiusM }] });
  return [{ body: sphere('palm', PALM_M), joint: null }, ...JOINTS.map((joint): Pusher => ({ body: sphere(`${joint}`, FINGER_M), joint }))];
}

/** Moves the bodies of a side to its hand, or all of them to its controller; returns false if neither is tracked. */
function follow(pushers: readonly Pusher[], side: Side, input: SessionInput): boolean {
  const hand = side === 'left' ? input.leftHand : input.rightHand;
  const grip = input[side].worldFromGrip;
  if (hand.tracked) writePalm(scratchPose, hand);
  else if (grip) scratchPose.set(grip);
  else return false;
  for (const { body, joint } of pushers) {
    const isJoint = joint !== null && hand.tracked;
    for (let i = 0; i < 16; i++) body.worldFromTarget[i] = (isJoint ? hand.worldFromJoints[16 * joint + i] : scratchPose[i]) ?? 0;
  }
  return true;
}
