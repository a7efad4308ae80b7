import type { Emulator, HeadPose } from '../../export/emulator/emulator.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import { isTouch } from './room-touches.ts';

/** Moves the head of the emulated device: dragging looks around; W, A, S, D and the arrow keys walk. */
export interface Walk {
  /** Returns to the start pose. */
  rewind(): void;
  /** Sets the head to the pose of this walk again, after other code has set another pose. */
  restore(): void;
  dispose(): void;
}

/** Standing at the edge of a play area of 2 m, looking into the room. */
const START = { x: 0, y: 1.5, z: 1, yawRad: 0, pitchRad: -0.15 };
/** The start pose for the emulator. */
export const START_POSE: HeadPose = {
  position: [START.x, START.y, START.z],
  quaternion: [Math.sin(START.pitchRad / 2), 0, 0, Math.cos(START.pitchRad / 2)],
};
const RAD_PER_PX = 0.004;
const MAX_PITCH_RAD = 1.4;
const SPEED_M_PER_S = 1.2;
/** Maximum time step, so that a page that was suspended does not walk through walls. */
const MAX_STEP_S = 0.1;

const DIRECTIONS: Readonly<Record<string, readonly [right: number, forward: number]>> = {
  KeyW: [0, 1],
  ArrowUp: [0, 1],
  KeyS: [0, -1],
  ArrowDown: [0, -1],
  KeyA: [-1, 0],
  ArrowLeft: [-1, 0],
  KeyD: [1, 0],
  ArrowRight: [1, 0],
};

/** Whether the key is one of the walking keys. */
export function isStep({ code, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return code in DIRECTIONS && !ctrlKey && !metaKey && !altKey;
}

/** @param touches Whether the mouse may be a finger, see `isTouch`. */
export function createWalk(emulator: Pick<Emulator, 'setPose'>, screen: HTMLElement, clock: FrameClock, touches: boolean): Walk {
  const head = { ...START };
  const held = new Set<string>();
  let drag: { readonly pointer: number; x: number; y: number } | null = null;
  let frame = 0;
  let lastS = clock.nowS();

  const place = () => {
    const sinYaw = Math.sin(head.yawRad / 2);
    const cosYaw = Math.cos(head.yawRad / 2);
    const sinPitch = Math.sin(head.pitchRad / 2);
    const cosPitch = Math.cos(head.pitchRad / 2);
    // Yaw about y, then pitch about the rotated x axis.
    emulator.setPose({
      position: [head.x, head.y, head.z],
      quaternion: [cosYaw * sinPitch, sinYaw * cosPitch, -sinYaw * sinPitch, cosYaw * cosPitch],
    });
  };
  const step = (nowS: number) => {
    frame = clock.requestFrame(step);
    const deltaS = Math.min(Math.max(0, nowS - lastS), MAX_STEP_S);
    lastS = nowS;
    if (held.size === 0 || deltaS === 0) return;
    let right = 0;
    let forward = 0;
    for (const code of held) {
      const [r, f] = DIRECTIONS[code] ?? [0, 0];
      right += r;
      forward += f;
    }
    const length = Math.hypot(right, forward);
    if (length === 0) return;
    const byM = (SPEED_M_PER_S * deltaS) / length;
    head.x += (Math.cos(head.yawRad) * right - Math.sin(head.yawRad) * forward) * byM;
    head.z += (-Math.sin(head.yawRad) * right - Math.cos(head.yawRad) * forward) * byM;
    place();
  };
  const onDown = (event: PointerEvent) => {
    if (touches && isTouch(event)) {
      screen.setPointerCapture(event.pointerId);
      return;
    }
    drag = { pointer: event.pointerId, x: event.clientX, y: event.clientY };
    screen.setPointerCapture(event.pointerId);
  };
  const onMove = (event: PointerEvent) => {
    if (drag?.pointer !== event.pointerId) return;
    head.yawRad += (event.clientX - drag.x) * RAD_PER_PX;
    head.pitchRad = Math.min(Math.max(head.pitchRad + (event.clientY - drag.y) * RAD_PER_PX, -MAX_PITCH_RAD), MAX_PITCH_RAD);
    drag.x = event.clientX;
    drag.y = event.clientY;
    place();
  };
  const onUp = () => {
    drag = null;
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (!isStep(event)) return;
    event.preventDefault();
    held.add(event.code);
  };
  const onKeyUp = (event: KeyboardEvent) => held.delete(event.code);
  const onBlur = () => held.clear();

  screen.addEventListener('pointerdown', onDown);
  screen.addEventListener('pointermove', onMove);
  screen.addEventListener('pointerup', onUp);
  window.addEventListener('keydown', onKeyDown);
  window.addEventListener('keyup', onKeyUp);
  window.addEventListener('blur', onBlur);
  place();
  frame = clock.requestFrame(step);
  return {
    rewind: () => {
      Object.assign(head, START);
      place();
    },
    restore: place,
    dispose: () => {
      clock.cancelFrame(frame);
      screen.removeEventListener('pointerdown', onDown);
      screen.removeEventListener('pointermove', onMove);
      screen.removeEventListener('pointerup', onUp);
      window.removeEventListener('keydown', onKeyDown);
      window.removeEventListener('keyup', onKeyUp);
      window.removeEventListener('blur', onBlur);
    },
  };
}
