import { pinchStrength } from '../../../../nodes/kit/hands.ts';
import { isPose } from '../../../../nodes/kit/pose.ts';
import type { PointerKind } from '../../../../nodes/kit/session.ts';
import { beginPress, createPress, dropPress, endPress, type Press, showPhase } from '../input/press.ts';
import { addPointer, MAX_POINTERS, type MutableInput } from '../input/session-input.ts';

/** Index of the trigger in the `xr-standard` mapping (WebXR Gamepads §3.3). */
const TRIGGER = 0;

/**
 * Reads the input sources of a WebXR session as pointers. A press that the page keeps for its DOM overlay fires no `selectstart`, so it is
 * no press here.
 */
export interface WebXrPointers {
  /** Adds the pointers to the input. Called once per frame, after the joints of hands are set. */
  fill(input: MutableInput, frame: XRFrame): void;
  /** In a frame without a viewer pose. Presses that no frame has shown are forgotten: they would come late, when tracking returns. */
  skip(): void;
}

interface SourcePress {
  readonly press: Press;
  source: XRInputSource | null;
  selected: boolean;
  /** Whether the ray of the source is known. */
  aimed: boolean;
  /** Whether the session still has the source. */
  present: boolean;
}

/**
 * Turns `selectstart`, `select` and `selectend` into presses. A press that ends without `select` was canceled by the system.
 *
 * @param referenceSpace World space.
 */
export function createWebXrPointers(session: XRSession, referenceSpace: XRReferenceSpace): WebXrPointers {
  const presses: SourcePress[] = [];
  let made = 0;

  const take = (source: XRInputSource): SourcePress | null => {
    let unused: SourcePress | null = null;
    for (let i = 0; i < presses.length; i++) {
      const each = presses[i];
      if (each?.source === source && each.press.ended === 'no') return each;
      if (each?.source === null) unused ??= each;
    }
    if (!unused) {
      if (presses.length === MAX_POINTERS) return null;
      unused = { press: createPress(), source: null, selected: false, aimed: false, present: true };
      presses.push(unused);
    }
    const { press } = unused;
    unused.source = source;
    unused.present = true;
    unused.aimed = false;
    press.used = true;
    press.began = false;
    press.ended = 'no';
    press.over = false;
    press.pointer.id = ++made;
    press.pointer.by = kindOf(source);
    press.pointer.owner = null;
    press.pointer.xrSource = source;
    press.pointer.worldFromGrip = null;
    return unused;
  };
  const aim = (each: SourcePress, frame: XRFrame): boolean => {
    const matrix = each.source ? frame.getPose(each.source.targetRaySpace, referenceSpace)?.transform.matrix : null;
    if (!matrix || !isPose(matrix)) return false;
    each.press.pointer.worldFromRay.set(matrix);
    each.aimed = true;
    return true;
  };
  const free = (each: SourcePress): void => {
    each.source = null;
    each.press.used = false;
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
    skip: () => {
      for (let i = 0; i < presses.length; i++) {
        const each = presses[i];
        if (!each?.source || !each.press.began || each.press.shown) continue;
        dropPress(each.press);
        if (isTransient(each.source)) free(each);
      }
    },
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
        // A press is not shown before it has a place, and never if it ends before.
        if (!each.aimed && !(each.present && aim(each, frame))) {
          if (press.ended !== 'no') dropPress(press);
          if (!each.present || (isTransient(source) && !press.began)) free(each);
          continue;
        }
        showPhase(press);
        const { pointer } = press;
        const isHover = pointer.phase === 'hover';
        // A press that began before the last one was over has a pointer of its own.
        if (isHover && (!each.present || isTransient(source) || hasOther(presses, each))) {
          free(each);
          continue;
        }
        const aimed = each.present && pointer.phase !== 'end' && pointer.phase !== 'cancel' && aim(each, frame);
        if (isHover && !aimed) {
          each.aimed = false;
          continue;
        }
        // Hand tracking may begin later than the source.
        pointer.by = kindOf(source);
        const grip = each.present && source.gripSpace ? frame.getPose(source.gripSpace, referenceSpace)?.transform.matrix : null;
        const isHeld = grip !== null && grip !== undefined && isPose(grip);
        if (isHeld) press.grip.set(grip);
        pointer.worldFromGrip = isHeld ? press.grip : null;
        pointer.pinch = pinchOf(source, input, pointer.phase === 'start' || pointer.phase === 'hold');
        addPointer(input, pointer);
      }
    },
  };
}

function hasOther(presses: readonly SourcePress[], press: SourcePress): boolean {
  for (let i = 0; i < presses.length; i++) if (presses[i] !== press && presses[i]?.source === press.source) return true;
  return false;
}

/** Whether a source exists only during a press (WebXR Device API §10.1). */
function isTransient({ targetRayMode }: XRInputSource): boolean {
  return targetRayMode === 'screen' || targetRayMode === 'transient-pointer';
}

function kindOf(source: XRInputSource): PointerKind {
  const { targetRayMode, handedness } = source;
  if (targetRayMode === 'screen') return 'screen';
  if (handedness === 'none' || targetRayMode === 'gaze') return 'gaze';
  return isBareHand(source) ? `${handedness}-hand` : handedness;
}

/** Whether the source is a hand that holds no controller. */
export function isBareHand({ hand, targetRayMode, profiles }: XRInputSource): boolean {
  return Boolean(hand) || targetRayMode === 'transient-pointer' || profiles.some(isHandProfile);
}

/** Whether a profile is that of a hand. By WebXR Input Profiles, hands whose joints are not granted have such a profile too. */
function isHandProfile(profile: string): boolean {
  return profile.startsWith('generic-hand');
}

function pinchOf({ gamepad, hand, handedness }: XRInputSource, input: MutableInput, isPressed: boolean): number {
  const trigger = gamepad?.buttons[TRIGGER]?.value;
  if (trigger !== undefined) return trigger;
  const joints = handedness === 'left' ? input.leftHand : input.rightHand;
  return hand && joints.tracked ? pinchStrength(joints) : Number(isPressed);
}
