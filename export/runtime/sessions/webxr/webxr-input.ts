import { isPose } from '../../../../nodes/kit/pose.ts';
import { createHapticsCache } from '../input/haptics.ts';
import { deriveTaps, type MutableController, type MutableInput, rest } from '../input/session-input.ts';
import { createMatrix } from '../matrix.ts';
import { createWebXrHands } from './webxr-hands.ts';
import { createWebXrPointers, isBareHand } from './webxr-pointers.ts';

/**
 * Indices of buttons and axes: those of the `xr-standard` mapping (WebXR Gamepads §3.3), and those of controllers with a thumbstick
 * (profiles registry).
 */
const TRIGGER = 0;
const SQUEEZE = 1;
const PRIMARY = 4;
const SECONDARY = 5;
const STICK = 3;
const TOUCHPAD_AXIS = 0;
const THUMBSTICK_AXIS = 2;

/**
 * Reads the input of a WebXR session: pointers and taps by screen, controller or hand, the state of controllers, and the joints of hands.
 */
export interface WebXrInput {
  /** Fills the input of a frame. Call it once per frame. */
  fill(input: MutableInput, frame: XRFrame): void;
  /** In a frame without a viewer pose: what was pressed since the last frame is forgotten. */
  skip(): void;
}

export function createWebXrInput(session: XRSession, referenceSpace: XRReferenceSpace): WebXrInput {
  const hands = createWebXrHands(session, referenceSpace);
  const pointers = createWebXrPointers(session, referenceSpace);
  const own = { left: createOwn(), right: createOwn() };
  const poseOf = (space: XRSpace | undefined, frame: XRFrame, out: Float32Array): Float32Array | null => {
    const matrix = space && frame.getPose(space, referenceSpace)?.transform.matrix;
    if (!matrix || !isPose(matrix)) return null;
    out.set(matrix);
    return out;
  };
  return {
    skip: pointers.skip,
    fill: (input, frame) => {
      hands.fill(input, frame);
      input.pointerCount = 0;
      pointers.fill(input, frame);
      deriveTaps(input);
      rest(input.left);
      rest(input.right);
      for (let i = 0; i < session.inputSources.length; i++) {
        const source = session.inputSources[i];
        if (!source) continue;
        const side = source.handedness === 'left' ? 'left' : 'right';
        const controller = input[side];
        if (!source.gamepad || source.targetRayMode === 'screen' || controller.connected) continue;
        readController(controller, source.gamepad);
        controller.worldFromRay = poseOf(source.targetRaySpace, frame, own[side].ray);
        controller.worldFromGrip = poseOf(source.gripSpace, frame, own[side].grip);
        controller.bare = isBareHand(source);
        controller.haptics = own[side].hapticsOf(source.gamepad);
      }
    },
  };
}

/** Creates the objects to which the controller of one side refers. */
function createOwn() {
  return { ray: createMatrix(), grip: createMatrix(), hapticsOf: createHapticsCache() };
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
  controller.stickPressed = buttons[STICK]?.pressed ?? false;
}
