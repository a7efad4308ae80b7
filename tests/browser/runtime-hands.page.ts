/// <reference types="webxr" />

import { P_GAMEPAD } from 'iwer';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import { createSessionInput } from '../../export/runtime/sessions/input/session-input.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { recordInput } from '../../export/runtime/sessions/record-input.ts';
import { readSessionFile } from '../../export/runtime/sessions/recorded/read-session-file.ts';
import { createInputReplay } from '../../export/runtime/sessions/recorded/replay-input.ts';
import type { SessionFileFrame } from '../../export/runtime/sessions/session-format.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { HAND_JOINTS } from '../../nodes/kit/hand-joints.ts';
import type { Hand, SessionFrame, SessionInput } from '../../nodes/kit/session.ts';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const HANDS: ProgramNeed = { capability: 'hands', required: false, nodes: [], why: 'to test', without: '' };

/** A headset in whose session the page reads input, and asks the browser itself as well. */
async function inHeadset<T>(
  needs: readonly ProgramNeed[],
  act: (emulator: ReturnType<typeof installEmulator>, frame: <R>(see: (frame: SessionFrame) => R) => Promise<R>) => Promise<T>,
): Promise<T> {
  const emulator = installEmulator({ device: 'headset', clock: 'manual', display: false, sizePx: [64, 64] });
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { output } = await requestWebXrSession({ xr: navigator.xr, inputs: SESSION_INPUTS, gl, needs, antialias: false });
  if (!output) throw new Error('There is no session.');
  let see: ((frame: SessionFrame) => void) | null = null;
  output.start(
    (frame) => {
      see?.(frame);
      see = null;
    },
    () => {},
  );
  const frame = async <R>(look: (frame: SessionFrame) => R): Promise<R> => {
    const seen: R[] = [];
    see = (now) => void seen.push(look(now));
    await emulator.stepFrame();
    if (seen.length === 0) throw new Error('There was no frame.');
    return seen[0] as R;
  };
  try {
    return await act(emulator, frame);
  } finally {
    await output.end();
    await emulator.uninstall();
  }
}

/** The largest difference between the joints of a hand and what the browser says of each, in its matrices and radii. */
function differenceFromBrowser({ xr }: SessionFrame, hand: Hand, handedness: string): number {
  const { session, frame, referenceSpace } = xr as unknown as { session: XRSession; frame: XRFrame; referenceSpace: XRReferenceSpace };
  const source = [...session.inputSources].find((each) => each.handedness === handedness);
  let most = 0;
  HAND_JOINTS.forEach((joint, i) => {
    const space = source?.hand?.get(joint);
    const pose = space && frame.getJointPose?.(space, referenceSpace);
    if (!pose) throw new Error(`The browser has no ${joint}.`);
    most = Math.max(most, Math.abs((pose.radius ?? 0) - (hand.radiiM[i] ?? 0)));
    for (let k = 0; k < 16; k++) most = Math.max(most, Math.abs((pose.transform.matrix[k] ?? 0) - (hand.worldFromJoints[16 * i + k] ?? 0)));
  });
  return most;
}

/** Both hands at different places, one that pinches, then one that is lost. */
export function joints() {
  return inHeadset([HANDS], async (emulator, frame) => {
    const { device } = emulator;
    device.primaryInputMode = 'hand';
    const { left, right } = device.hands;
    if (!left || !right) throw new Error('The headset has no hands.');
    left.position.set(-0.3, 1.1, -0.5);
    left.quaternion.set(0, Math.sin(0.4), 0, Math.cos(0.4));
    right.position.set(0.2, 1.3, -0.6);
    right.updatePinchValue(1);
    await frame(() => {});
    const both = await frame((now) => ({
      differences: [differenceFromBrowser(now, now.input.leftHand, 'left'), differenceFromBrowser(now, now.input.rightHand, 'right')],
      tracked: [now.input.leftHand.tracked, now.input.rightHand.tracked],
      by: now.input.pointers.slice(0, now.input.pointerCount).map(({ by, phase }) => `${by} ${phase}`),
      granted: now.xr?.capabilities.has('hands'),
    }));
    right.connected = false;
    const lost = await frame(({ input }) => ({
      tracked: [input.leftHand.tracked, input.rightHand.tracked],
      by: input.pointers.slice(0, input.pointerCount).map(({ by, phase }) => `${by} ${phase}`),
    }));
    return { ...both, lost };
  });
}

/** A pinch of the right hand and a squeeze by the left controller after it, as they came, and as a recording of them replays them. */
export function replayed() {
  return inHeadset([HANDS], async ({ device }, frame) => {
    const frames: SessionFileFrame[] = [];
    const live: ReturnType<typeof told>[] = [];
    const see = () =>
      frame(({ input, timeS }) => {
        const recorded = recordInput(input);
        frames.push({ timeS, color: 'a.png', worldFromCamera: IDENTITY, ...(recorded && { input: recorded }) });
        live.push(told(input));
      });
    device.primaryInputMode = 'hand';
    await see();
    device.hands.right?.updatePinchValue(1);
    await see();
    await see();
    device.hands.right?.updatePinchValue(0);
    for (let i = 0; i < 3; i++) await see();
    device.primaryInputMode = 'controller';
    device.controllers.left?.updateButtonValue('squeeze', 1);
    for (let i = 0; i < 2; i++) await see();
    const lens = { widthPx: 2, heightPx: 2, intrinsics: { fxPx: 1, fyPx: 1, cxPx: 1, cyPx: 1 } };
    const file: unknown = { format: 'scrim-session', version: 1, title: 'Input', color: lens, frameRateHz: 60, frames };
    const { output, diagnostics } = readSessionFile(JSON.parse(JSON.stringify(file)));
    const replay = output && createInputReplay(output);
    const input = createSessionInput();
    const again = live.map((_, i) => {
      input.pointerCount = 0;
      replay?.fill(input, i);
      return told(input);
    });
    return { live, again, diagnostics };
  });
}

/** What a node sees of the input, to a tenth of a millimeter. */
function told({ pointers, pointerCount, tapCount, left, leftHand, rightHand }: SessionInput) {
  const round = (numbers: ArrayLike<number> | null | undefined) =>
    Array.from(numbers ?? [], (x) => Math.round(Math.round(x * 1e5) / 10) / 1e4 + 0);
  return {
    pointers: pointers
      .slice(0, pointerCount)
      .map(({ by, phase, tapped, worldFromRay, pinch }) => ({ by, phase, tapped, ray: round(worldFromRay), pinch: round([pinch]) }))
      .sort((a, b) => a.by.localeCompare(b.by)),
    tapCount,
    squeeze: left.squeeze,
    grip: round(left.worldFromGrip),
    hands: [leftHand, rightHand].map(({ tracked, worldFromJoints, radiiM }) => (tracked ? [round(worldFromJoints), round(radiiM)] : null)),
  };
}

/** Whether the session asks for hands that no node needs. */
export function unasked() {
  return inHeadset([], async (_emulator, frame) => {
    return frame(({ xr, input }) => [
      (xr?.session as XRSession | undefined)?.enabledFeatures?.includes('hand-tracking'),
      input.rightHand.tracked,
    ]);
  });
}

/** The grip of the right controller, and what its motor played. */
export function haptics() {
  return inHeadset([], async ({ device }, frame) => {
    const controller = device.controllers.right;
    if (!controller) throw new Error('The headset has no right controller.');
    controller.position.set(0.3, 1.2, -0.4);
    await frame(() => {});
    const found = await frame(({ input, xr }) => {
      const {
        session,
        frame: now,
        referenceSpace,
      } = xr as unknown as { session: XRSession; frame: XRFrame; referenceSpace: XRReferenceSpace };
      const source = [...session.inputSources].find(({ handedness }) => handedness === 'right');
      const own = source?.gripSpace && now.getPose(source.gripSpace, referenceSpace)?.transform.matrix;
      input.right.haptics?.pulse(0.6, 0.25);
      return { grip: [...(input.right.worldFromGrip ?? [])], own: [...(own ?? [])], bare: input.right.bare };
    });
    const [motor] = controller.inputSource.gamepad?.hapticActuators ?? [];
    const played = motor?.[P_GAMEPAD].lastPulse;
    return { ...found, played: [played?.value, played?.duration] };
  });
}

/** What the session on a device says is missing, where a node needs hands. */
export async function missingOn(device: 'phone' | 'headset') {
  const emulator = installEmulator({ device, clock: 'manual', display: false, sizePx: [64, 64], refuse: ['hand-tracking'] });
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { output, diagnostics } = await requestWebXrSession({ xr: navigator.xr, gl, needs: [HANDS], antialias: false });
  await output?.end();
  await emulator.uninstall();
  return diagnostics.length;
}
