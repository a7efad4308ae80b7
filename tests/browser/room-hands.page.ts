/// <reference types="webxr" />
import { pointHandPose } from 'iwer/lib/device/configs/hand/point.js';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { grabStrength, pinchStrength } from '../../nodes/kit/hands.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import { createRoomHands } from '../../renderer/preview/room-hands.ts';

const HANDS: ProgramNeed = { capability: 'hands', required: false, nodes: [], why: 'to test', without: '' };

const press = (code: string) => window.dispatchEvent(new KeyboardEvent('keydown', { code, cancelable: true }));
const release = (code: string) => window.dispatchEvent(new KeyboardEvent('keyup', { code }));

/** A headset in the preview, whose frames come one by one. */
async function inPreview<T>(
  act: (parts: {
    frame: () => Promise<SessionFrame>;
    emulator: ReturnType<typeof installEmulator>;
    screen: HTMLElement;
    hint: HTMLElement;
  }) => Promise<T>,
): Promise<T> {
  const emulator = installEmulator({ device: 'headset', clock: 'manual', display: false, sizePx: [64, 64], views: 1 });
  const [screen, hint] = [document.createElement('div'), document.createElement('p')];
  screen.style.cssText = 'position:absolute;left:0;top:0;width:400px;height:400px';
  hint.hidden = true;
  document.body.append(screen, hint);
  let place: ((timeS: number) => void) | null = null;
  const clock = {
    nowS: () => 0,
    requestFrame: (callback: (timeS: number) => void) => {
      place = callback;
      return 1;
    },
    cancelFrame: () => {
      place = null;
    },
  };
  emulator.setPose({ position: [1, 1.6, 2] });
  const hands = createRoomHands(emulator, screen, hint, clock as never);
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { output } = await requestWebXrSession({ xr: navigator.xr, inputs: SESSION_INPUTS, gl, needs: [HANDS], antialias: false });
  if (!output) throw new Error('There is no session.');
  let last: SessionFrame | null = null;
  output.start(
    (frame) => {
      last = frame;
    },
    () => {},
  );
  const frame = async (): Promise<SessionFrame> => {
    place?.(0);
    await emulator.stepFrame();
    if (!last) throw new Error('There was no frame.');
    return last;
  };
  try {
    await frame();
    return await act({ frame, emulator, screen, hint });
  } finally {
    hands.dispose();
    await output.end();
    await emulator.uninstall();
    screen.remove();
    hint.remove();
  }
}

const phasesOf = ({ input }: SessionFrame) =>
  input.pointers
    .slice(0, input.pointerCount)
    .map(({ by, phase }) => `${by} ${phase}`)
    .sort();

/** Keys of controllers: trigger, squeeze, and what the page lets them play. */
export function controllers() {
  return inPreview(async ({ frame, emulator, screen, hint }) => {
    const hints = [hint.textContent, hint.hidden];
    screen.dispatchEvent(new PointerEvent('pointermove', { clientX: 300, clientY: 200 }));
    press('KeyR');
    press('KeyG');
    const down = await frame();
    const held = {
      phases: phasesOf(down),
      trigger: [down.input.left.trigger, down.input.right.trigger],
      squeeze: [down.input.left.squeeze, down.input.right.squeeze],
    };
    // From the right hand to the point under the mouse, 2 m ahead.
    const ray = down.input.right.worldFromRay ?? [];
    const [ahead, grip] = [[...ray.slice(8, 11)].map((x) => -x), [...(down.input.right.worldFromRay ?? []).slice(12, 15)]];
    down.input.right.haptics?.pulse(0.5, 0.2);
    const pulses = [emulator.lastPulse('left'), emulator.lastPulse('right')];
    release('KeyR');
    release('KeyG');
    const up = phasesOf(await frame());
    return { hints, held, ahead, grip, pulses, up };
  });
}

/** Keys of bare hands: two that pinch, one that is lost in its pinch and comes back, a poke, a grab and a capture. */
export function hands() {
  return inPreview(async ({ frame, emulator, hint }) => {
    press('KeyH');
    await frame();
    const seen: string[][] = [];
    const see = async () => seen.push(phasesOf(await frame()));
    press('KeyR');
    press('KeyF');
    await see();
    await see();
    press('KeyL');
    await see();
    await see();
    release('KeyR');
    press('KeyL');
    await see();
    release('KeyF');
    await see();
    const shapes: Record<string, number[]> = {};
    const shape = async (name: string) => {
      await frame();
      const { input } = await frame();
      shapes[name] = [pinchStrength(input.rightHand), grabStrength(input.rightHand)];
    };
    await shape('relaxed');
    for (const [name, code] of [
      ['pinch', 'KeyR'],
      ['grab', 'KeyT'],
      ['poke', 'KeyY'],
    ] as const) {
      press(code);
      await shape(name);
      release(code);
    }
    emulator.addGesture('pointing again', JSON.parse(JSON.stringify(pointHandPose)));
    emulator.setGesture('right', 'pointing again');
    await shape('capture');
    let refused = '';
    try {
      emulator.setGesture('right', 'wave');
    } catch (error) {
      refused = (error as Error).message;
    }
    return { seen, shapes, refused, hint: hint.textContent };
  });
}
