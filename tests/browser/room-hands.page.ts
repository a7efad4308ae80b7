/// <reference types="webxr" />
import { pointHandPose } from 'iwer/lib/device/configs/hand/point.js';
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { ProgramNeed } from '../../export/program/needs.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { grabStrength, pinchStrength } from '../../nodes/kit/hands.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import { createRoomHands } from '../../renderer/preview/room-hands.ts';
import { createRoomTouches } from '../../renderer/preview/room-touches.ts';
import { createRoomTracking } from '../../renderer/preview/room-tracking.ts';
import { createWalk } from '../../renderer/preview/walk.ts';

const needOf = (capability: ProgramNeed['capability']): ProgramNeed => ({
  capability,
  required: false,
  nodes: [],
  why: 'to test',
  without: '',
});

const press = (code: string, keys: KeyboardEventInit = {}) =>
  window.dispatchEvent(new KeyboardEvent('keydown', { code, cancelable: true, ...keys }));
const release = (code: string) => window.dispatchEvent(new KeyboardEvent('keyup', { code }));

/** A headset or a phone in the preview, whose frames come one by one. */
async function inPreview<T>(
  device: 'headset' | 'phone',
  act: (parts: {
    frame: () => Promise<SessionFrame>;
    emulator: ReturnType<typeof installEmulator>;
    screen: HTMLElement;
    hint: HTMLElement;
    trackingHint: HTMLElement;
    /** Sets what is called within each frame, while the browser answers. */
    watch: (look: (frame: SessionFrame) => void) => void;
  }) => Promise<T>,
  framesPerSecond = 60,
): Promise<T> {
  const emulator = installEmulator({ device, clock: 'manual', framesPerSecond, display: false, sizePx: [64, 64], views: 1 });
  const [screen, hint, trackingHint] = [document.createElement('div'), document.createElement('p'), document.createElement('p')];
  screen.style.cssText = 'position:absolute;left:0;top:0;width:400px;height:400px';
  hint.hidden = true;
  trackingHint.hidden = true;
  document.body.append(screen, hint, trackingHint);
  let waiting: ((timeS: number) => void)[] = [];
  const clock = {
    nowS: () => 0,
    requestFrame: (callback: (timeS: number) => void) => waiting.push(callback),
    cancelFrame: () => {},
  };
  emulator.setPose({ position: [1, 1.6, 2] });
  const walk = device === 'phone' ? createWalk(emulator, screen, clock as never, true) : null;
  const hands = (device === 'phone' ? createRoomTouches : createRoomHands)(emulator, screen, hint, clock as never);
  const tracking = createRoomTracking(emulator, trackingHint);
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { output } = await requestWebXrSession({
    xr: navigator.xr,
    inputs: SESSION_INPUTS,
    gl,
    needs: [needOf('hands'), needOf('anchors')],
    antialias: false,
  });
  if (!output) throw new Error('There is no session.');
  let last: SessionFrame | null = null;
  let look: (frame: SessionFrame) => void = () => {};
  output.start(
    (frame) => {
      last = frame;
      look(frame);
    },
    () => {},
  );
  const frame = async (): Promise<SessionFrame> => {
    const callbacks = waiting;
    waiting = [];
    for (const callback of callbacks) callback(0);
    await emulator.stepFrame();
    if (!last) throw new Error('There was no frame.');
    return last;
  };
  try {
    await frame();
    const watch = (next: typeof look) => {
      look = next;
    };
    return await act({ frame, emulator, screen, hint, trackingHint, watch });
  } finally {
    hands.dispose();
    tracking.dispose();
    walk?.dispose();
    await output.end();
    await emulator.uninstall();
    screen.remove();
    hint.remove();
    trackingHint.remove();
  }
}

const phasesOf = ({ input }: SessionFrame) =>
  input.pointers
    .slice(0, input.pointerCount)
    .map(({ by, phase }) => `${by} ${phase}`)
    .sort();

/** Keys of controllers: trigger, squeeze, and what the page lets them play. */
export function controllers() {
  return inPreview('headset', async ({ frame, emulator, screen, hint }) => {
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
  return inPreview('headset', async ({ frame, emulator, hint }) => {
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

/** The mouse on a phone: a click, a drag with Shift, one with Alt, and one that looks around. Phases per frame, and the rays. */
export function touches() {
  return inPreview('phone', async ({ frame, emulator, screen, hint }) => {
    screen.setPointerCapture = () => {};
    const send = (type: string, clientX: number, clientY: number, keys: PointerEventInit = {}) =>
      screen.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: type === 'pointermove' ? -1 : 0, clientX, clientY, ...keys }));
    /** Phases of the frames, and where the pointers of each point: right and up per distance ahead, in the view. */
    const play = async (frames: number) => {
      const phases: string[][] = [];
      let rays: number[][] = [];
      let taps = 0;
      for (let i = 0; i < frames; i++) {
        const shown = await frame();
        const { pointers, pointerCount, tapCount } = shown.input;
        phases.push(phasesOf(shown));
        taps += tapCount;
        if (pointerCount > 0) {
          rays = pointers.slice(0, pointerCount).map(({ worldFromRay: m }) => {
            const v = shown.views[0]?.viewFromWorld ?? [];
            const [x = 0, y = 0, z = 1] = [0, 1, 2].map((i) =>
              [0, 1, 2].reduce((sum, k) => sum + (v[4 * k + i] ?? 0) * (m[8 + k] ?? 0), 0),
            );
            return [-x / z, -y / z];
          });
        }
      }
      return { phases: phases.filter((each) => each.length > 0), rays, taps };
    };
    const headOf = () => {
      const { x, y, z, w } = emulator.device.quaternion;
      return [x, y, z, w];
    };
    const level = headOf();
    send('pointerdown', 300, 200);
    send('pointerup', 300, 200);
    const click = await play(6);
    const drag = async (keys: PointerEventInit) => {
      send('pointerdown', 300, 200, keys);
      const down = await play(2);
      send('pointermove', 200, 100, keys);
      const moved = await play(2);
      send('pointerup', 200, 100, keys);
      const up = await play(3);
      return { down, moved, up, turned: Math.hypot(...headOf().map((x, i) => x - (level[i] ?? 0))) > 1e-3 };
    };
    return {
      click,
      one: await drag({ shiftKey: true }),
      two: await drag({ altKey: true }),
      look: await drag({}),
      hint: hint.textContent,
      tan: Math.tan(emulator.device.fovy / 2),
    };
  });
}

/** Keys of the tracking: where an anchor at (0, 1, -1) of the room is in world space after each, and what the session says. */
export function tracking() {
  return inPreview(
    'headset',
    async ({ frame, trackingHint, watch }) => {
      const hints: (string | null)[] = [trackingHint.textContent];
      let isAsked = false;
      let anchor: XRAnchor | null = null;
      // Null where the session gave no frame, as without tracking.
      let seen: { at: number[] | null; views: number; jumps: number; anchors: number } | null = null;
      watch(({ xr, viewCount, jumps }) => {
        const [browserFrame, space] = [xr?.frame as XRFrame, xr?.referenceSpace as XRReferenceSpace];
        if (!isAsked) void browserFrame.createAnchor?.(new XRRigidTransform({ y: 1, z: -1 }), space).then((made) => (anchor = made));
        isAsked = true;
        const pose = anchor && browserFrame.trackedAnchors?.has(anchor) ? browserFrame.getPose(anchor.anchorSpace, space) : null;
        const at = pose ? [pose.transform.position.x, pose.transform.position.y, pose.transform.position.z] : null;
        seen = { at, views: viewCount, jumps, anchors: browserFrame.trackedAnchors?.size ?? 0 };
      });
      const play = async (frames = 1) => {
        seen = null;
        for (let i = 0; i < frames; i++) await frame();
        hints.push(trackingHint.textContent);
        return seen;
      };
      const after = async (code: string, keys?: KeyboardEventInit, frames?: number) => {
        press(code, keys);
        return play(frames);
      };
      const steps = {
        start: await play(3),
        minute: await after('KeyV', { shiftKey: true }),
        drift: await after('KeyV', {}, 60),
        still: await after('KeyV', {}, 10),
        anchorsLost: await after('KeyN'),
        anchorsFound: await after('KeyN'),
        trackingLost: await after('KeyK'),
        trackingFound: await after('KeyK'),
        centered: await after('KeyC', {}, 2),
        deleted: await after('KeyM'),
      };
      return { steps, hints, hidden: trackingHint.hidden };
    },
    1,
  );
}
