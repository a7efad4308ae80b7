import { createHapticsCache } from './haptics.ts';
import { type MutableController, type MutableInput, rest } from './session-input.ts';

/** Axes and buttons of each half in the standard mapping (Gamepad §Remapping). */
const HALVES = {
  left: { axis: 0, trigger: 6, squeeze: 4, primary: 2, secondary: 3, stick: 10 },
  right: { axis: 2, trigger: 7, squeeze: 5, primary: 0, secondary: 1, stick: 11 },
} as const;

/** Reads the first gamepad with standard mapping as two controllers. Without one the controllers are at rest. */
export function createGamepadReader(): (input: MutableInput, gamepads: readonly (Gamepad | null)[]) => void {
  const hapticsOf = createHapticsCache();
  return (input, gamepads) => {
    rest(input.left);
    rest(input.right);
    const gamepad = gamepads.find((candidate) => candidate?.connected === true && candidate.mapping === 'standard');
    if (!gamepad) return;
    readHalf(input.left, gamepad, HALVES.left);
    readHalf(input.right, gamepad, HALVES.right);
    // One motor for both halves.
    input.left.haptics = input.right.haptics = hapticsOf(gamepad);
  };
}

function readHalf(controller: MutableController, { axes, buttons }: Gamepad, half: (typeof HALVES)['left' | 'right']): void {
  controller.connected = true;
  controller.stick[0] = axes[half.axis] ?? 0;
  // Down is positive in the Gamepad API; + 0 turns −0 into 0.
  controller.stick[1] = -(axes[half.axis + 1] ?? 0) + 0;
  controller.trigger = buttons[half.trigger]?.value ?? 0;
  controller.squeeze = buttons[half.squeeze]?.value ?? 0;
  controller.primary = buttons[half.primary]?.pressed ?? false;
  controller.secondary = buttons[half.secondary]?.pressed ?? false;
  controller.stickPressed = buttons[half.stick]?.pressed ?? false;
}
