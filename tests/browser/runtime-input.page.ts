/// <reference types="webxr" />

import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { createBrowserClock } from '../../export/runtime/clock.ts';
import { createCameraSession } from '../../export/runtime/sessions/camera/camera-session.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { createOrbitSession } from '../../export/runtime/sessions/orbit/orbit-session.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { claimPointer } from '../../nodes/kit/pointers.ts';
import type { Controller, Session, SessionFrame } from '../../nodes/kit/session.ts';

export interface TapSeen {
  readonly by: string;
  readonly origin: readonly number[];
  readonly direction: readonly number[];
}

function tapsOf({ input }: SessionFrame): TapSeen[] {
  return input.taps.slice(0, input.tapCount).map(({ by, worldFromRay: m }) => ({
    by,
    origin: [...m.slice(12, 15)],
    direction: [...m.slice(8, 11)].map((x) => -x + 0),
  }));
}

function copyOf({ stick, worldFromRay, worldFromGrip, haptics, ...rest }: Controller) {
  const originOf = (m: Float32Array | null) => m && [...m.slice(12, 15)];
  return { ...rest, stick: [...stick], ray: originOf(worldFromRay), grip: originOf(worldFromGrip), vibrates: haptics !== null };
}

let session: Session;
let taps: TapSeen[] = [];
let frames = 0;
let right: ReturnType<typeof copyOf> | null = null;

/** An orbit around (0, 1, 0), 2 m away and level, on a square canvas of 400 CSS pixels in the corner of the page. */
export function begin(): void {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;left:0;top:0;width:400px;height:400px';
  document.body.append(canvas);
  const gl = canvas.getContext('webgl2') as WebGL2RenderingContext;
  session = createOrbitSession({
    inputs: SESSION_INPUTS,
    gl,
    canvas,
    clock: createBrowserClock(),
    start: { targetWorld: [0, 1, 0], distanceM: 2, elevationRad: 0 },
  });
  session.start(
    (frame) => {
      frames++;
      taps.push(...tapsOf(frame));
      follow(frame);
      right = copyOf(frame.input.right);
    },
    () => {},
  );
}

/** All taps of the frames since the last call, once what was done before has reached one. */
export async function seen(): Promise<TapSeen[]> {
  const before = frames;
  while (frames < before + 2) await new Promise((resolve) => requestAnimationFrame(resolve));
  const all = taps;
  taps = [];
  return all;
}

let phases: string[] = [];
let started: number[] = [];
let owner: object | null = null;
let heading = 0;

/** What each pointer went through since the last call, and where the view's axis points. */
export async function pointers(): Promise<{ readonly phases: string[]; readonly heading: number }> {
  await seen();
  const all = phases;
  phases = [];
  return { phases: all, heading };
}

/** A mouse press at (200, 200) that moves to (260, 200) and ends before the next frame, the direction of its start, and the view's axis. */
export async function flick(): Promise<{ readonly start: number[]; readonly heading: number }> {
  const canvas = document.querySelector('canvas') as HTMLCanvasElement;
  canvas.setPointerCapture = () => {};
  const send = (type: string, clientX: number, buttons: number) =>
    canvas.dispatchEvent(
      new PointerEvent(type, {
        pointerId: 1,
        pointerType: 'mouse',
        button: type === 'pointermove' ? -1 : 0,
        buttons,
        clientX,
        clientY: 200,
      }),
    );
  send('pointerdown', 200, 1);
  send('pointermove', 260, 1);
  send('pointerup', 260, 0);
  await seen();
  return { start: started, heading };
}

/** Whether a node claims every press from now on. */
export function claim(on: boolean): void {
  owner = on ? {} : null;
}

function follow({ input, views }: SessionFrame): void {
  for (const pointer of input.pointers.slice(0, input.pointerCount)) {
    if (owner) claimPointer(pointer, owner);
    if (pointer.phase === 'start') started = [...pointer.worldFromRay.slice(8, 11)].map((x) => -x);
    const word = `${pointer.by} ${pointer.id} ${pointer.phase}${pointer.tapped ? ' tapped' : ''}`;
    if (phases.at(-1) !== word && !(pointer.phase === 'hold' && phases.includes(word))) phases.push(word);
  }
  heading = Math.atan2(views[0]?.worldFromView[8] ?? 0, views[0]?.worldFromView[10] ?? 0);
}

/** The reported state of the right half of a connected gamepad, with its stick up and its trigger half pulled. */
export async function gamepad() {
  const buttons = Array.from({ length: 16 }, (_, i) => ({ pressed: i === 0, touched: false, value: i === 7 ? 0.5 : 0 }));
  const pad = { connected: true, mapping: 'standard', axes: [0, 0, 0.25, -1], buttons };
  Object.defineProperty(navigator, 'getGamepads', { configurable: true, value: () => [null, pad] });
  await seen();
  const unheard = right;
  window.dispatchEvent(new Event('gamepadconnected'));
  await seen();
  const plugged = right;
  pad.connected = false;
  await seen();
  return { unheard, plugged, unplugged: right };
}

/** The left stick of a gamepad pushed to the right, then A. */
export async function gamepadPointer() {
  const buttons = Array.from({ length: 16 }, () => ({ pressed: false, touched: false, value: 0 }));
  const pad = { connected: true, mapping: 'standard', axes: [1, 0, 0, 0], buttons };
  Object.defineProperty(navigator, 'getGamepads', { configurable: true, value: () => [pad] });
  window.dispatchEvent(new Event('gamepadconnected'));
  for (let i = 0; i < 20; i++) await seen();
  pad.axes = [0, 0, 0, 0];
  await seen();
  phases = [];
  Object.assign(buttons[0] ?? {}, { pressed: true });
  await seen();
  Object.assign(buttons[0] ?? {}, { pressed: false });
  const [tap] = [...(await seen()), ...(await seen())];
  const ring = document.querySelector<HTMLElement>('canvas + div');
  const told = phases.map((word) => word.replace(/ [0-9]+ /, ' '));
  pad.connected = false;
  await seen();
  return { tap, phases: told, left: ring?.style.left };
}

/**
 * A gamepad in a camera session without a sensor: the left stick to the left, then A. Gives the tap, the pointer's phases, and the
 * direction of the view's axis.
 */
export async function cameraGamepad() {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;left:0;top:400px;width:400px;height:400px';
  document.body.append(canvas);
  const gl = canvas.getContext('webgl2') as WebGL2RenderingContext;
  const angles = { alphaRad: 0, betaRad: Math.PI / 2, gammaRad: 0, screenRad: 0 };
  const stream = { video: document.createElement('video'), start: async () => {}, stop: () => {} };
  const sensor = { angles, present: false, dispose: () => {} };
  const camera = createCameraSession({ gl, canvas, clock: createBrowserClock(), stream, sensor, inputs: SESSION_INPUTS });
  const tapped: TapSeen[] = [];
  const told: string[] = [];
  let axis: number[] = [];
  let count = 0;
  camera.start(
    (frame) => {
      count++;
      tapped.push(...tapsOf(frame));
      for (const { by, phase } of frame.input.pointers.slice(0, frame.input.pointerCount)) {
        if (told.at(-1) !== `${by} ${phase}`) told.push(`${by} ${phase}`);
      }
      axis = [...(frame.views[0]?.worldFromView.slice(8, 11) ?? [])].map((x) => -x);
    },
    () => {},
  );
  const frames = async (n: number) => {
    for (const until = count + n; count < until; ) await new Promise((resolve) => requestAnimationFrame(resolve));
  };
  const buttons = Array.from({ length: 16 }, () => ({ pressed: false, touched: false, value: 0 }));
  const pad = { connected: true, mapping: 'standard', axes: [-1, 0, 0, 0], buttons };
  Object.defineProperty(navigator, 'getGamepads', { configurable: true, value: () => [pad] });
  window.dispatchEvent(new Event('gamepadconnected'));
  await frames(20);
  pad.axes = [0, 0, 0, 0];
  for (const pressed of [true, false]) {
    Object.assign(buttons[0] ?? {}, { pressed });
    await frames(3);
  }
  const hasRing = canvas.nextElementSibling !== null;
  await camera.end();
  const ringStays = canvas.nextElementSibling !== null;
  pad.connected = false;
  canvas.remove();
  return { tapped, told, axis, hasRing, ringStays };
}

export async function end(): Promise<number> {
  await session.end();
  document.querySelector('canvas')?.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter' }));
  return taps.length;
}

/** A WebXR session whose frames are kept as they came. */
async function inXr<T>(
  options: EmulatorOptions,
  act: (emulator: ReturnType<typeof installEmulator>, frame: () => Promise<SessionFrame>) => Promise<T>,
): Promise<T> {
  const emulator = installEmulator({ clock: 'manual', display: false, sizePx: [64, 64], ...options });
  const gl = document.createElement('canvas').getContext('webgl2') as WebGL2RenderingContext;
  const { output } = await requestWebXrSession({ xr: navigator.xr, inputs: SESSION_INPUTS, gl, needs: [], antialias: false });
  if (!output) throw new Error('There is no session.');
  let last: SessionFrame | null = null;
  output.start(
    (frame) => {
      last = frame;
    },
    () => {},
  );
  const step = async (): Promise<SessionFrame> => {
    await emulator.stepFrame();
    if (!last) throw new Error('There was no frame.');
    return last;
  };
  try {
    return await act(emulator, step);
  } finally {
    await output.end();
    await emulator.uninstall();
  }
}

/** Taps per frame, of a finger that touches the middle of a phone's screen and lets go. */
export function phone() {
  return inXr({ device: 'phone' }, async (emulator, frame) => {
    emulator.setPose({ position: [1, 1.5, 2] });
    const perFrame: TapSeen[][] = [];
    const next = async () => perFrame.push(tapsOf(await frame()));
    await next();
    emulator.press(0.5, 0.5);
    await next();
    await next();
    emulator.release();
    await next();
    await next();
    await next();
    return perFrame;
  });
}

/** The right controller of a headset, its trigger pulled, its stick pushed away, its lower button pressed; and the taps it made. */
export function headset() {
  return inXr({ device: 'headset' }, async (emulator, frame) => {
    await frame();
    const controller = emulator.device.controllers.right;
    if (!controller) throw new Error('The headset has no right controller.');
    controller.position.set(0.3, 1.2, -0.4);
    controller.updateButtonValue('trigger', 1);
    controller.updateButtonValue('a-button', 1);
    controller.updateAxis('thumbstick', 'y-axis', -0.75);
    await frame();
    const held = copyOf((await frame()).input.right);
    controller.updateButtonValue('trigger', 0);
    const after: TapSeen[] = [];
    for (let i = 0; i < 3; i++) after.push(...tapsOf(await frame()));
    return { held, taps: after };
  });
}
