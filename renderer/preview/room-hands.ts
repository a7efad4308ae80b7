import { Matrix4, Quaternion, Vector3 } from 'three';
import type { Emulator } from '../../export/emulator/emulator.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';

/**
 * Hands and controllers of the emulated device by mouse and keys: they stay beside the head, point at what is under the mouse, and press
 * while a key is held.
 */
export interface RoomHands {
  dispose(): void;
}

type Controls = Pick<Emulator, 'device' | 'setInput' | 'setGesture' | 'setHandTracked'>;
type Side = 'left' | 'right';

/** Positions of the hands relative to the eyes, in the axes of an upright head, in meters. */
const PLACES: Readonly<Record<Side, readonly [number, number, number]>> = { left: [-0.18, -0.2, -0.35], right: [0.18, -0.2, -0.35] };
/** Distance from the eyes of the point that the hands point at: meters. */
const AIM_M = 2;

/** What a key does while it is held: the gesture of a hand, and the button of a controller. */
type Hold = { readonly side: Side; readonly gesture: 'pinch' | 'poke' | 'grab'; readonly button: 'trigger' | 'squeeze' | null };

const HOLDS: Readonly<Record<string, Hold>> = {
  KeyF: { side: 'left', gesture: 'pinch', button: 'trigger' },
  KeyR: { side: 'right', gesture: 'pinch', button: 'trigger' },
  KeyG: { side: 'left', gesture: 'grab', button: 'squeeze' },
  KeyT: { side: 'right', gesture: 'grab', button: 'squeeze' },
  KeyY: { side: 'right', gesture: 'poke', button: null },
};
const SWITCH = 'KeyH';
const LOSE = 'KeyL';

const HINTS = {
  controllers: 'R, F: right, left trigger · T, G: squeeze · H: hands · the mouse points',
  hands: 'R, F: right, left pinch · T, G: grab · Y: poke · L: lose the right hand · H: controllers · the mouse points',
} as const;

/** Whether the key drives hands and controllers. */
export function isHandKey({ code, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return (code in HOLDS || code === SWITCH || code === LOSE) && !ctrlKey && !metaKey && !altKey;
}

// Filled and read within one call.
const scratchHead = new Quaternion();
const scratchTurn = new Quaternion();
const scratchAt = new Vector3();
const scratchAim = new Vector3();
const scratchMatrix = new Matrix4();
const UP = new Vector3(0, 1, 0);

/**
 * Creates the hands and controllers of an emulated device.
 *
 * @param hint Element that shows the keys.
 */
export function createRoomHands(emulator: Controls, screen: HTMLElement, hint: HTMLElement, clock: FrameClock): RoomHands {
  const { device } = emulator;
  let mode: keyof typeof HINTS = 'controllers';
  let isLost = false;
  const held = new Set<string>();
  /** Position of the mouse on the screen element: to the right and up, from -1 to 1. */
  const mouse = { x: 0, y: 0 };
  let frame = 0;

  const show = () => {
    hint.textContent = HINTS[mode];
  };
  const shape = (side: Side) => {
    const holds = [...held].flatMap((code) => (HOLDS[code]?.side === side ? [HOLDS[code]] : []));
    emulator.setGesture(side, holds.at(-1)?.gesture ?? 'relaxed');
    for (const button of ['trigger', 'squeeze'] as const) {
      device.controllers[side]?.updateButtonValue(button, holds.some((hold) => hold.button === button) ? 1 : 0);
    }
  };
  const place = () => {
    frame = clock.requestFrame(place);
    const { position, quaternion, fovy } = device;
    scratchHead.set(quaternion.x, quaternion.y, quaternion.z, quaternion.w);
    const aspect = screen.clientWidth / Math.max(1, screen.clientHeight);
    const tan = Math.tan(fovy / 2);
    scratchAim
      .set(mouse.x * tan * aspect, mouse.y * tan, -1)
      .multiplyScalar(AIM_M)
      .applyQuaternion(scratchHead);
    scratchAim.add(scratchAt.set(position.x, position.y, position.z));
    // Hands stay level where the head tilts.
    const yawRad = 2 * Math.atan2(scratchHead.y, scratchHead.w);
    for (const side of ['left', 'right'] as const) {
      scratchAt.fromArray(PLACES[side]).applyAxisAngle(UP, yawRad);
      scratchAt.x += position.x;
      scratchAt.y += position.y;
      scratchAt.z += position.z;
      const { x, y, z } = scratchAt;
      scratchTurn.setFromRotationMatrix(scratchMatrix.lookAt(scratchAt, scratchAim, UP));
      for (const input of [device.controllers[side], device.hands[side]]) {
        input?.position.set(x, y, z);
        input?.quaternion.set(scratchTurn.x, scratchTurn.y, scratchTurn.z, scratchTurn.w);
      }
    }
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (!isHandKey(event)) return;
    event.preventDefault();
    if (event.repeat) return;
    const hold = HOLDS[event.code];
    if (hold) {
      held.add(event.code);
      shape(hold.side);
    } else if (event.code === LOSE) {
      isLost = !isLost;
      emulator.setHandTracked('right', !isLost);
      if (!isLost) shape('right');
    } else {
      mode = mode === 'hands' ? 'controllers' : 'hands';
      emulator.setInput(mode);
      show();
    }
  };
  const onKeyUp = (event: KeyboardEvent) => {
    const hold = HOLDS[event.code];
    if (hold && held.delete(event.code)) shape(hold.side);
  };
  const onBlur = () => {
    held.clear();
    shape('left');
    shape('right');
  };
  const onMove = (event: PointerEvent) => {
    const box = screen.getBoundingClientRect();
    mouse.x = (2 * (event.clientX - box.left)) / Math.max(1, box.width) - 1;
    mouse.y = 1 - (2 * (event.clientY - box.top)) / Math.max(1, box.height);
  };

  const listeners = new AbortController();
  const { signal } = listeners;
  window.addEventListener('keydown', onKeyDown, { signal });
  window.addEventListener('keyup', onKeyUp, { signal });
  window.addEventListener('blur', onBlur, { signal });
  screen.addEventListener('pointermove', onMove, { signal });
  show();
  hint.hidden = false;
  place();
  return {
    dispose: () => {
      clock.cancelFrame(frame);
      listeners.abort();
      hint.hidden = true;
    },
  };
}
