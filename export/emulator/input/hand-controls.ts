import { P_GAMEPAD, P_HAND_INPUT, type XRDevice } from 'iwer';
import type { Emulator } from '../emulator.ts';
import { closeIndexFinger, type HandInput, readHandCapture } from './hand-capture.ts';

type Side = 'left' | 'right';

/** Gestures that the device has without a capture. */
export type HandGesture = 'relaxed' | 'pinch' | 'poke' | 'grab';

/**
 * iwer's name for the pose of each gesture. A pinch has the pose of a relaxed hand; `setGesture` also sets iwer's pinch value, which makes
 * the device select.
 */
const POSES: Readonly<Record<HandGesture, string>> = { relaxed: 'default', pinch: 'default', poke: 'point', grab: 'grab' };

/** Controls of the hands and controllers of an emulated device. */
export type HandControls = Pick<Emulator, 'setInput' | 'setGesture' | 'addGesture' | 'setHandTracked' | 'lastPulse'>;

export function createHandControls(device: XRDevice): HandControls {
  const handOf = (side: Side): HandInput => {
    const hand = device.hands[side];
    if (!hand) throw new Error(`The device has no ${side} hand.`);
    return hand;
  };
  const { poses } = handOf('left')[P_HAND_INPUT];
  if (poses.point) poses.grab ??= closeIndexFinger(poses.point);
  return {
    setInput: (mode) => {
      device.primaryInputMode = mode === 'hands' ? 'hand' : 'controller';
    },
    setGesture: (side, gesture) => {
      const hand = handOf(side);
      const pose = POSES[gesture as HandGesture] ?? gesture;
      if (!(pose in hand[P_HAND_INPUT].poses)) {
        throw new Error(`There is no gesture “${gesture}”. Add its capture first, or use one of ${Object.keys(POSES).join(', ')}.`);
      }
      hand.poseId = pose;
      hand.updatePinchValue(gesture === 'pinch' ? 1 : 0);
    },
    addGesture: (name, capture) => {
      const pose = readHandCapture(capture);
      for (const side of ['left', 'right'] as const) handOf(side)[P_HAND_INPUT].poses[name] = pose;
    },
    setHandTracked: (side, tracked) => {
      const hand = handOf(side);
      hand.connected = tracked;
      if (tracked) return;
      // The press ends with the hand: a pinch that opens meanwhile selects nothing when the hand comes back.
      const pinch = hand.inputSource.gamepad?.[P_GAMEPAD].buttonsMap.pinch?.[P_GAMEPAD];
      if (pinch) Object.assign(pinch, { value: 0, pendingValue: null });
    },
    lastPulse: (side) => {
      const pulse = device.controllers[side]?.inputSource.gamepad?.hapticActuators[0]?.[P_GAMEPAD].lastPulse;
      return pulse ? { strength: pulse.value, durationS: pulse.duration / 1000 } : null;
    },
  };
}
