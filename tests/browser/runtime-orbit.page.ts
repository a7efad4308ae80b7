import { createBrowserClock } from '../../export/runtime/clock.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { createOrbitSession } from '../../export/runtime/sessions/orbit/orbit-session.ts';
import type { Session, SessionEvent } from '../../nodes/kit/session.ts';

export interface Look {
  readonly position: readonly number[];
  /** What the view looks along, world space. */
  readonly forward: readonly number[];
  readonly sizePx: readonly number[];
  /** Tangents of half the angle seen across and down. */
  readonly tan: readonly number[];
  readonly timesRise: boolean;
}

let canvas: HTMLCanvasElement;
let session: Session;
let look: Look | null = null;
let frames = 0;
const events: SessionEvent[] = [];

/** An orbit on a canvas of 400 × 300 CSS pixels in the corner of the page. */
export function begin(): void {
  canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;left:0;top:0;width:400px;height:300px';
  document.body.append(canvas);
  const gl = canvas.getContext('webgl2') as WebGL2RenderingContext;
  session = createOrbitSession({
    inputs: SESSION_INPUTS,
    gl,
    canvas,
    clock: createBrowserClock(),
    start: { targetWorld: [0, 1, 0], distanceM: 2, elevationRad: 0 },
  });
  let lastS = -1;
  session.start(
    (frame) => {
      const [view] = frame.views;
      if (!view) return;
      frames++;
      const m = view.worldFromView;
      look = {
        position: [...m.slice(12, 15)],
        forward: [...m.slice(8, 11)].map((v) => -v),
        sizePx: [view.viewport.widthPx, view.viewport.heightPx],
        tan: [1 / (view.clipFromView[0] ?? 0), 1 / (view.clipFromView[5] ?? 0)],
        timesRise: frame.timeS > lastS,
      };
      lastS = frame.timeS;
    },
    (event) => events.push(event),
  );
}

/** After whatever was done before has reached a frame. */
export async function seen(): Promise<Look | null> {
  const before = frames;
  while (frames < before + 2) await new Promise((resolve) => requestAnimationFrame(resolve));
  return look;
}

export function resize(width: number, height: number): void {
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
}

/** Two fingers that start 100 px apart and end `apartPx` apart, both moved down by `downPx`. */
export function pinch(apartPx: number, downPx: number): void {
  const fire = (type: string, pointerId: number, x: number, y: number): void => {
    canvas.dispatchEvent(new PointerEvent(type, { pointerId, clientX: x, clientY: y, pointerType: 'touch', buttons: 1, bubbles: true }));
  };
  canvas.setPointerCapture = () => {};
  fire('pointerdown', 1, 150, 150);
  fire('pointerdown', 2, 250, 150);
  fire('pointermove', 1, 200 - apartPx / 2, 150 + downPx);
  fire('pointermove', 2, 200 + apartPx / 2, 150 + downPx);
  fire('pointerup', 1, 0, 0);
  fire('pointerup', 2, 0, 0);
}

export async function end() {
  const tabIndex = canvas.tabIndex;
  await session.end();
  await session.end();
  const stopped = frames;
  for (let i = 0; i < 3; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
  return { tabIndex, after: canvas.getAttribute('tabindex'), touchAction: canvas.style.touchAction, framesAfter: frames - stopped, events };
}
