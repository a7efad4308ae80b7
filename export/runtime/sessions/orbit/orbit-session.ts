import type { Session, SessionEvent, SessionFrame } from '../../../../nodes/kit/session.ts';
import type { FrameClock } from '../../clock.ts';
import { type CanvasFitter, createCanvasFitter } from '../fit-canvas.ts';
import { createFrameTime } from '../frame-time.ts';
import type { SessionInputs } from '../input/session-inputs.ts';
import { setFrustum, setRigidInverse } from '../matrix.ts';
import { coverCanvas, createSessionFrame } from '../session-frame.ts';
import { listenForOrbit } from './orbit-input.ts';
import { createOrbit, ORBIT_DEFAULTS, type OrbitPose } from './orbit-pose.ts';

export interface OrbitSessionOptions {
  readonly gl: WebGL2RenderingContext;
  /** The canvas of `gl`. */
  readonly canvas: HTMLCanvasElement;
  /** Sizes the drawing buffer. Default: the size of the canvas on the page. */
  readonly fitter?: CanvasFitter;
  readonly clock: FrameClock;
  readonly start?: Partial<OrbitPose>;
  /** Functions that read input; absent or null: frames have no input. */
  readonly inputs?: SessionInputs | null;
}

/** The field of view is 50° along the shorter side, so that portrait and landscape show equally much. */
const TAN_HALF_FOV = Math.tan((25 * Math.PI) / 180);

/**
 * Creates a session that shows the objects without a background, from all sides: the fallback of pages without AR and the default of the
 * preview.
 */
export function createOrbitSession(options: OrbitSessionOptions): Session {
  const { gl, canvas, clock } = options;
  const orbit = createOrbit({ ...ORBIT_DEFAULTS, ...options.start });
  const frame = createSessionFrame();
  const time = createFrameTime();
  const page = canvas.ownerDocument;
  let onFrame: ((frame: SessionFrame) => void) | null = null;
  let onEvent: ((event: SessionEvent) => void) | null = null;
  let handle = 0;
  let stop: (() => void) | null = null;

  const tanHalfFovY = (): number => TAN_HALF_FOV / Math.min(1, gl.drawingBufferWidth / gl.drawingBufferHeight);
  const begin = (): void => {
    const fitter = options.fitter ?? createCanvasFitter(canvas);
    const input = options.inputs?.page(canvas) ?? null;
    const gestures = listenForOrbit(canvas, orbit, tanHalfFovY, input ?? undefined);
    const visibility = (): void => onEvent?.({ kind: 'visibility', visible: page.visibilityState === 'visible' });
    page.addEventListener('visibilitychange', visibility);
    stop = () => {
      clock.cancelFrame(handle);
      page.removeEventListener('visibilitychange', visibility);
      gestures.dispose();
      input?.dispose();
      fitter.dispose();
    };
    const tick = (nowS: number): void => {
      handle = clock.requestFrame(tick);
      fitter.update();
      if (gl.drawingBufferWidth === 0 || gl.drawingBufferHeight === 0) return;
      time.write(frame, nowS);
      const view = coverCanvas(frame, gl);
      const y = tanHalfFovY();
      const x = (y * view.viewport.widthPx) / view.viewport.heightPx;
      setFrustum(view.clipFromView, -x, x, -y, y, view.nearM, view.farM);
      gestures.settle();
      orbit.writeWorldFromView(view.worldFromView);
      setRigidInverse(view.viewFromWorld, view.worldFromView);
      input?.fill(frame);
      onFrame?.(frame);
    };
    handle = clock.requestFrame(tick);
  };
  return {
    kind: 'orbit',
    capabilities: new Set(),
    world: 'none',
    blend: 'opaque',
    start: (frameHandler, eventHandler) => {
      onFrame = frameHandler;
      onEvent = eventHandler;
      if (!stop) begin();
    },
    end: async () => {
      if (!stop) return;
      stop();
      stop = null;
      onFrame = null;
      onEvent?.({ kind: 'ended', by: 'page' });
    },
  };
}
