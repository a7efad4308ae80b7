import { deriveTaps, type MutableController, type MutableInput, rest } from '../input/session-input.ts';
import { createMatrix } from '../matrix.ts';
import { createWebXrPointers } from './webxr-pointers.ts';

/** Indices of the `xr-standard` mapping (WebXR Gamepads §3.3), then those that controllers with a thumbstick add (profiles registry). */
const TRIGGER = 0;
const SQUEEZE = 1;
const PRIMARY = 4;
const SECONDARY = 5;
const TOUCHPAD_AXIS = 0;
const THUMBSTICK_AXIS = 2;

/** Pointers and taps by screen, controller or hand, and the state of the controllers. */
export interface WebXrInput {
  /** Fills the input of a frame. Call it once per frame. */
  fill(input: MutableInput, frame: XRFrame): void;
}

export function createWebXrInput(session: XRSession, referenceSpace: XRReferenceSpace): WebXrInput {
  const pointers = createWebXrPointers(session, referenceSpace);
  const rays = { left: createMatrix(), right: createMatrix() };
  return {
    fill: (input, frame) => {
      input.pointerCount = 0;
      pointers.fill(input, frame);
      deriveTaps(input);
      rest(input.left);
      rest(input.right);
      for (let i = 0; i < session.inputSources.length; i++) {
        const source = session.inputSources[i];
        if (!source) continue;
        const hand = source.handedness === 'left' ? 'left' : 'right';
        if (!source.gamepad || source.targetRayMode === 'screen' || input[hand].connected) continue;
        readController(input[hand], source.gamepad);
        const pose = frame.getPose(source.targetRaySpace, referenceSpace);
        if (!pose) continue;
        rays[hand].set(pose.transform.matrix);
        input[hand].worldFromRay = rays[hand];
      }
    },
  };
}

function readController(controller: MutableController, { axes, buttons }: Gamepad): void {
  const axis = axes.length > THUMBSTICK_AXIS ? THUMBSTICK_AXIS : TOUCHPAD_AXIS;
  controller.connected = true;
  controller.stick[0] = axes[axis] ?? 0;
  // Towards the visitor is positive; + 0 turns −0 into 0.
  controller.stick[1] = -(axes[axis + 1] ?? 0) + 0;
  controller.trigger = buttons[TRIGGER]?.value ?? 0;
  controller.squeeze = buttons[SQUEEZE]?.value ?? 0;
  controller.primary = buttons[PRIMARY]?.pressed ?? false;
  controller.secondary = buttons[SECONDARY]?.pressed ?? false;
}
