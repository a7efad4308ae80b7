import type { PointerKind } from '../../../../nodes/kit/session.ts';
import { beginPress, createPress, endPress, type Press, showPhase } from '../input/press.ts';
import { addPointer, MAX_POINTERS, type MutableInput } from '../input/session-input.ts';

/** Distance of the tips of thumb and index finger at which a pinch is closed, and at which it is open, meters. */
const PINCH_CLOSED_M = 0.01;
const PINCH_OPEN_M = 0.06;

/** Place of the trigger in the `xr-standard` mapping (WebXR Gamepads §3.3). */
const TRIGGER = 0;

/** Input sources of a WebXR session as pointers. A press on the DOM overlay that the page keeps fires no `selectstart` and is none. */
export interface WebXrPointers {
  /** Once a frame. */
  fill(input: MutableInput, frame: XRFrame): void;
}

interface SourcePress {
  readonly press: Press;
  source: XRInputSource | null;
  selected: boolean;
  /** The session still has the source. */
  present: boolean;
}

/**
 * Turns `selectstart`, `select` and `selectend` into presses. A press that ends without `select` was taken away by the system.
 *
 * @param referenceSpace World space.
 */
export function createWebXrPointers(session: XRSession, referenceSpace: XRReferenceSpace): WebXrPointers {
  const presses: SourcePress[] = [];
  let made = 0;

  const take = (source: XRInputSource): SourcePress | null => {
    let free: SourcePress | null = null;
    for (let i = 0; i < presses.length; i++) {
      const each = presses[i];
      if (each?.source === source && each.press.ended === 'no') return each;
      if (each?.source === null) free ??= each;
    }
    if (!free) {
      if (presses.length === MAX_POINTERS) return null;
      free = { press: createPress(), source: null, selected: false, present: true };
      presses.push(free);
    }
    const { press } = free;
    free.source = source;
    free.present = true;
    press.used = true;
    press.began = false;
    press.ended = 'no';
    press.over = false;
    press.pointer.id = ++made;
    press.pointer.by = kindOf(source);
    press.pointer.owner = null;
    press.pointer.xrSource = source;
    press.pointer.worldFromGrip = null;
    return free;
  };
  const aim = ({ press, source }: SourcePress, frame: XRFrame): boolean => {
    const pose = source ? frame.getPose(source.targetRaySpace, referenceSpace) : null;
    if (pose) press.pointer.worldFromRay.set(pose.transform.matrix);
    return pose !== null && pose !== undefined;
  };
  const begin = ({ frame, inputSource }: XRInputSourceEvent): SourcePress | null => {
    const pressed = take(inputSource);
    if (!pressed) return null;
    pressed.selected = false;
    beginPress(pressed.press);
    aim(pressed, frame);
    return pressed;
  };
  session.addEventListener('selectstart', begin);
  session.addEventListener('select', (event) => {
    const known = presses.find(({ source, press }) => source === event.inputSource && press.began && press.ended === 'no');
    const pressed = known ?? begin(event);
    if (!pressed) return;
    pressed.selected = true;
    aim(pressed, event.frame);
    // Some browsers fire `select` alone.
    if (!known) endPress(pressed.press, 'end', true);
  });
  session.addEventListener('selectend', ({ frame, inputSource }) => {
    const pressed = presses.find(({ source, press }) => source === inputSource && press.began && press.ended === 'no');
    if (!pressed) return;
    aim(pressed, frame);
    endPress(pressed.press, pressed.selected ? 'end' : 'cancel', pressed.selected);
  });

  return {
    fill: (input, frame) => {
      for (let i = 0; i < presses.length; i++) {
        const each = presses[i];
        if (each) each.present = false;
      }
      for (let i = 0; i < session.inputSources.length; i++) {
        const source = session.inputSources[i];
        if (!source) continue;
        let isKnown = false;
        for (let j = 0; j < presses.length; j++) {
          const each = presses[j];
          if (each?.source !== source) continue;
          each.present = true;
          isKnown = true;
        }
        if (!isKnown && !isTransient(source)) take(source);
      }
      for (let i = 0; i < presses.length; i++) {
        const each = presses[i];
        const source = each?.source;
        if (!each || !source) continue;
        const { press } = each;
        // The source went in the middle of a press.
        if (!each.present) endPress(press, 'cancel', false);
        showPhase(press);
        const { pointer } = press;
        const isHover = pointer.phase === 'hover';
        // A press that began before the last one was over has a pointer of its own.
        if (isHover && (!each.present || isTransient(source) || hasOther(presses, each))) {
          each.source = null;
          press.used = false;
          continue;
        }
        const aimed = each.present && pointer.phase !== 'end' && pointer.phase !== 'cancel' && aim(each, frame);
        if (isHover && !aimed) continue;
        // Hand tracking may begin later than the source.
        pointer.by = kindOf(source);
        const grip = each.present && source.gripSpace ? frame.getPose(source.gripSpace, referenceSpace) : null;
        if (grip) press.grip.set(grip.transform.matrix);
        pointer.worldFromGrip = grip ? press.grip : null;
        pointer.pinch = pinchOf(source, frame, pointer.phase === 'start' || pointer.phase === 'hold');
        addPointer(input, pointer);
      }
    },
  };
}

function hasOther(presses: readonly SourcePress[], press: SourcePress): boolean {
  for (let i = 0; i < presses.length; i++) if (presses[i] !== press && presses[i]?.source === press.source) return true;
  return false;
}

/** There only while it presses (WebXR Device API §10.1). */
function isTransient({ targetRayMode }: XRInputSource): boolean {
  return targetRayMode === 'screen' || targetRayMode === 'transient-pointer';
}

function kindOf(source: XRInputSource): PointerKind {
  const { targetRayMode, handedness } = source;
  if (targetRayMode === 'screen') return 'screen';
  if (handedness === 'none' || targetRayMode === 'gaze') return 'gaze';
  const isBare = Boolean(source.hand) || targetRayMode === 'transient-pointer' || source.profiles.some(isHandProfile);
  return isBare ? `${handedness}-hand` : handedness;
}

/** WebXR Input Profiles names hands that are not granted joints so, too. */
function isHandProfile(profile: string): boolean {
  return profile.startsWith('generic-hand');
}

function pinchOf(source: XRInputSource, frame: XRFrame, isPressed: boolean): number {
  const trigger = source.gamepad?.buttons[TRIGGER]?.value;
  if (trigger !== undefined) return trigger;
  const thumb = source.hand?.get('thumb-tip');
  const index = source.hand?.get('index-finger-tip');
  // Relative to each other, in whatever space.
  const pose = thumb && index ? frame.getPose(thumb, index) : null;
  if (!pose) return isPressed ? 1 : 0;
  const { x, y, z } = pose.transform.position;
  const distanceM = Math.hypot(x, y, z);
  return Math.min(1, Math.max(0, (PINCH_OPEN_M - distanceM) / (PINCH_OPEN_M - PINCH_CLOSED_M)));
}
