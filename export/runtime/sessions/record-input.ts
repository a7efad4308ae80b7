import { multiplyMatrices } from '../../../nodes/kit/matrices.ts';
import type { Controller, Hand, Pointer, SessionInput } from '../../../nodes/kit/session.ts';
import type { SessionFileController, SessionFileHand, SessionFileInput, SessionFilePointer } from './session-format.ts';

/**
 * The input of a frame as a recorded session stores it (`docs/SESSION-FORMAT.md`): pointers, connected controllers and tracked hands. Taps
 * are derived from pointers. Poses are rounded to a hundredth of a millimeter.
 *
 * @param outFromWorld Where the poses are moved to: column-major 4×4, rigid, such as the space of the room while world space drifts
 * against it. Null or absent: they stay in world space.
 * @returns Undefined if the frame has no input, so that frames without input have no such member.
 *
 * @example const input = recordInput(frame.input); frames.push({ timeS: frame.timeS, color, worldFromCamera, ...(input && { input }) });
 */
export function recordInput(input: SessionInput, outFromWorld: Float32Array | null = null): SessionFileInput | undefined {
  const { left, right, leftHand, rightHand } = input;
  const pointers = input.pointers.slice(0, input.pointerCount).map((pointer) => toPointer(pointer, outFromWorld));
  const recorded: SessionFileInput = {
    ...(pointers.length > 0 && { pointers }),
    ...(left.connected && { left: toController(left, outFromWorld) }),
    ...(right.connected && { right: toController(right, outFromWorld) }),
    ...(leftHand.tracked && { leftHand: toHand(leftHand, outFromWorld) }),
    ...(rightHand.tracked && { rightHand: toHand(rightHand, outFromWorld) }),
  };
  return Object.keys(recorded).length > 0 ? recorded : undefined;
}

function toPointer(
  { id, by, phase, worldFromRay, worldFromGrip, pinch, tapped }: Pointer,
  outFromWorld: Float32Array | null,
): SessionFilePointer {
  return {
    id,
    by,
    phase,
    worldFromRay: moved(worldFromRay, outFromWorld),
    ...(worldFromGrip && { worldFromGrip: moved(worldFromGrip, outFromWorld) }),
    pinch: round(pinch),
    ...(phase === 'end' && tapped && { tapped }),
  };
}

function toController(
  { stick, trigger, squeeze, primary, secondary, stickPressed, bare, worldFromRay, worldFromGrip }: Controller,
  outFromWorld: Float32Array | null,
): SessionFileController {
  return {
    stick: [round(stick[0] ?? 0), round(stick[1] ?? 0)],
    trigger: round(trigger),
    squeeze: round(squeeze),
    ...(primary && { primary }),
    ...(secondary && { secondary }),
    ...(stickPressed && { stickPressed }),
    ...(bare && { bare }),
    ...(worldFromRay && { worldFromRay: moved(worldFromRay, outFromWorld) }),
    ...(worldFromGrip && { worldFromGrip: moved(worldFromGrip, outFromWorld) }),
  };
}

function toHand({ worldFromJoints, radiiM }: Hand, outFromWorld: Float32Array | null): SessionFileHand {
  return { worldFromJoints: moved(worldFromJoints, outFromWorld), radiiM: rounded(radiiM) };
}

/** Poses of 16 numbers each. */
function moved(poses: Float32Array, outFromWorld: Float32Array | null): number[] {
  if (!outFromWorld) return rounded(poses);
  const out = new Float32Array(poses.length);
  for (let at = 0; at < poses.length; at += 16) multiplyMatrices(out.subarray(at), outFromWorld, poses.subarray(at, at + 16));
  return rounded(out);
}

function rounded(numbers: Float32Array): number[] {
  return Array.from(numbers, round);
}

function round(x: number): number {
  return Math.round(x * 1e5) / 1e5 + 0;
}
