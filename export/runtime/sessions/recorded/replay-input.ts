import { beginPress, createPress, endPress, type Press, showPhase } from '../input/press.ts';
import {
  addPointer,
  deriveTaps,
  MAX_POINTERS,
  type MutableController,
  type MutableHand,
  type MutableInput,
  rest,
} from '../input/session-input.ts';
import type { SessionFile, SessionFileController, SessionFileHand, SessionFilePointer } from '../session-format.ts';

/** Replays the input of a recording. */
export interface InputReplay {
  /**
   * Adds the recorded pointers to those of the page, and sets controllers and hands that are recorded. If a frame is shown again, its
   * presses are not repeated; presses in frames that playback skipped are replayed, so no tap is lost or doubled.
   *
   * @param number Number of the recorded frame, which continues to increase when the recording repeats.
   */
  fill(input: MutableInput, number: number): void;
  /** Drops all presses. Called when playback has jumped. */
  reset(): void;
}

/** Added to recorded ids, so that they differ from those of the page's own pointers. */
const FIRST_ID = 1 << 20;
/** Maximum number of skipped frames whose input is replayed. If there are more, playback was interrupted, and their input is dropped. */
const MOST_SKIPPED = 30;

interface Replayed {
  readonly press: Press;
  id: number;
  isPresent: boolean;
}

/** Creates the replay of a recording's input; null if it has none. */
export function createInputReplay({ frames }: SessionFile): InputReplay | null {
  if (!frames.some(({ input }) => input)) return null;
  const slots: Replayed[] = Array.from({ length: MAX_POINTERS }, () => ({ press: createPress(), id: 0, isPresent: false }));
  const poses = { left: createPoses(), right: createPoses() };
  let last: number | null = null;

  const slotOf = (id: number): Replayed | null => {
    let unused: Replayed | null = null;
    for (let i = 0; i < slots.length; i++) {
      const slot = slots[i];
      if (slot?.press.used && slot.id === id) return slot;
      if (slot && !slot.press.used) unused ??= slot;
    }
    if (!unused) return null;
    unused.id = id;
    unused.press.used = true;
    unused.press.began = false;
    unused.press.ended = 'no';
    unused.press.over = false;
    unused.press.pointer.id = FIRST_ID + id;
    unused.press.pointer.owner = null;
    return unused;
  };
  const follow = ({ id, by, phase, worldFromRay, worldFromGrip, pinch, tapped }: SessionFilePointer): void => {
    const slot = slotOf(id);
    if (!slot) return;
    const { press } = slot;
    const { pointer } = press;
    slot.isPresent = true;
    pointer.by = by;
    pointer.pinch = pinch;
    pointer.worldFromRay.set(worldFromRay);
    if (worldFromGrip) press.grip.set(worldFromGrip);
    pointer.worldFromGrip = worldFromGrip ? press.grip : null;
    if (phase === 'start' && !press.began) beginPress(press);
    if (phase === 'end' || phase === 'cancel') endPress(press, phase, tapped ?? false);
  };
  return {
    fill: (input, number) => {
      const first = last === null || number < last || number - last > MOST_SKIPPED ? number : last + 1;
      last = number;
      for (let at = first; at <= number; at++) {
        for (let i = 0; i < slots.length; i++) {
          const slot = slots[i];
          if (slot) slot.isPresent = false;
        }
        const pointers = frames[at % frames.length]?.input?.pointers;
        for (let i = 0; pointers && i < pointers.length; i++) {
          const pointer = pointers[i];
          if (pointer) follow(pointer);
        }
      }
      for (let i = 0; i < slots.length; i++) {
        const slot = slots[i];
        if (!slot?.press.used) continue;
        if (!slot.isPresent) endPress(slot.press, 'cancel', false);
        showPhase(slot.press);
        const { pointer } = slot.press;
        // Touches do not hover, as where the last frame of one is shown again.
        if (pointer.phase === 'hover' && (!slot.isPresent || pointer.by === 'screen')) slot.press.used = false;
        else addPointer(input, pointer);
      }
      deriveTaps(input);
      const recorded = frames[number % frames.length]?.input;
      followController(input.left, recorded?.left, poses.left);
      followController(input.right, recorded?.right, poses.right);
      followHand(input.leftHand, recorded?.leftHand);
      followHand(input.rightHand, recorded?.rightHand);
    },
    reset: () => {
      last = null;
      for (const { press } of slots) press.used = false;
    },
  };
}

function createPoses() {
  return { ray: new Float32Array(16), grip: new Float32Array(16) };
}

function followController(
  out: MutableController,
  recorded: SessionFileController | undefined,
  poses: { readonly ray: Float32Array; readonly grip: Float32Array },
): void {
  if (!recorded) {
    // One of the page, as a gamepad, stays.
    if (out.worldFromRay === poses.ray || out.worldFromGrip === poses.grip) rest(out);
    return;
  }
  const { stick, trigger, squeeze, primary, secondary, stickPressed, bare, worldFromRay, worldFromGrip } = recorded;
  out.connected = true;
  out.stick.set(stick);
  out.trigger = trigger;
  out.squeeze = squeeze;
  out.primary = primary ?? false;
  out.secondary = secondary ?? false;
  out.stickPressed = stickPressed ?? false;
  out.bare = bare ?? false;
  out.haptics = null;
  if (worldFromRay) poses.ray.set(worldFromRay);
  if (worldFromGrip) poses.grip.set(worldFromGrip);
  out.worldFromRay = worldFromRay ? poses.ray : null;
  out.worldFromGrip = worldFromGrip ? poses.grip : null;
}

function followHand(out: MutableHand, recorded: SessionFileHand | undefined): void {
  out.tracked = recorded !== undefined;
  if (!recorded) return;
  out.worldFromJoints.set(recorded.worldFromJoints);
  out.radiiM.set(recorded.radiiM);
}
