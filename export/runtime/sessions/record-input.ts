import type { Controller, Hand, Pointer, SessionInput } from '../../../nodes/kit/session.ts';
import type { SessionFileController, SessionFileHand, SessionFileInput, SessionFilePointer } from './session-format.ts';

/**
 * The input of a frame as a recorded session stores it (`docs/SESSION-FORMAT.md`): pointers, connected controllers and tracked hands. Taps
 * are derived from pointers. Poses are rounded to a hundredth of a millimeter.
 *
 * @returns Undefined if the frame has no input, so that frames without input have no such member.
 *
 * @example const input = recordInput(frame.input); frames.push({ timeS: frame.timeS, color, worldFromCamera, ...(input && { input }) });
 */
export function recordInput(input: SessionInput): SessionFileInput | undefined {
  const { left, right, leftHand, rightHand } = input;
  const pointers = input.pointers.slice(0, input.pointerCount).map(toPointer);
  const recorded: SessionFileInput = {
    ...(pointers.length > 0 && { pointers }),
    ...(left.connected && { left: toController(left) }),
    ...(right.connected && { right: toController(right) }),
    ...(leftHand.tracked && { leftHand: toHand(leftHand) }),
    ...(rightHand.tracked && { rightHand: toHand(rightHand) }),
  };
  return Object.keys(recorded).length > 0 ? recorded : undefined;
}

function toPointer({ id, by, phase, worldFromRay, worldFromGrip, pinch, tapped }: Pointer): SessionFilePointer {
  return {
    id,
    by,
    phase,
    worldFromRay: rounded(worldFromRay),
    ...(worldFromGrip && { worldFromGrip: rounded(worldFromGrip) }),
    pinch: round(pinch),
    ...(tapped && { tapped }),
  };
}

function toController({
  stick,
  trigger,
  squeeze,
  primary,
  secondary,
  stickPressed,
  bare,
  worldFromRay,
  worldFromGrip,
}: Controller): SessionFileController {
  return {
    stick: [round(stick[0] ?? 0), round(stick[1] ?? 0)],
    trigger: round(trigger),
    squeeze: round(squeeze),
    ...(primary && { primary }),
    ...(secondary && { secondary }),
    ...(stickPressed && { stickPressed }),
    ...(bare && { bare }),
    ...(worldFromRay && { worldFromRay: rounded(worldFromRay) }),
    ...(worldFromGrip && { worldFromGrip: rounded(worldFromGrip) }),
  };
}

function toHand({ worldFromJoints, radiiM }: Hand): SessionFileHand {
  return { worldFromJoints: rounded(worldFromJoints), radiiM: rounded(radiiM) };
}

function rounded(numbers: Float32Array): number[] {
  return Array.from(numbers, round);
}

function round(x: number): number {
  return Math.round(x * 1e5) / 1e5 + 0;
}
