import type { Session, SessionEvent, SessionFrame } from '../../../../nodes/kit/session.ts';
import type { FrameClock } from '../../clock.ts';
import { type CanvasFitter, createCanvasFitter } from '../fit-canvas.ts';
import { createFrameTime } from '../frame-time.ts';
import { createPageInput, type PageInput } from '../input/page-input.ts';
import { setRigidInverse } from '../matrix.ts';
import { listenForOrbit } from '../orbit/orbit-input.ts';
import { coverCanvas, createSessionFrame } from '../session-frame.ts';
import { createCameraStand } from './camera-stand.ts';
import type { CameraStream } from './camera-stream.ts';
import { createCameraView, LONG_SIDE_FOV_RAD } from './camera-view.ts';
import type { OrientationSensor } from './orientation-sensor.ts';

export interface CameraSessionParts {
  readonly gl: WebGL2RenderingContext;
  /** That of `gl`. Its drawing buffer follows its size on the page. */
  readonly canvas: HTMLCanvasElement;
  readonly clock: FrameClock;
  /** Started. */
  readonly stream: CameraStream;
  readonly sensor: OrientationSensor;
}

/** After so long without a reading there is no sensor, seconds. */
const SENSOR_PATIENCE_S = 1.5;

export interface CameraSession extends Session {
  /** The camera is gone, by no doing of the page. */
  lost(): void;
}

/**
 * The camera's picture with things in front of it that stay in their direction as the device turns. It knows nothing of how the
 * device moves, of the room's depth, surfaces or light. The camera is off while the page is hidden, and from `end` on.
 * `tracking` says whether the device tells how it is turned.
 */
export function createCameraSession({ gl, canvas, clock, stream, sensor }: CameraSessionParts): CameraSession {
  const frame = createSessionFrame();
  const time = createFrameTime();
  const stand = createCameraStand(sensor);
  const page = canvas.ownerDocument;
  const { video } = stream;
  let picture = createCameraView(gl);
  let fitter: CanvasFitter | null = null;
  let input: PageInput | null = null;
  let onFrame: ((frame: SessionFrame) => void) | null = null;
  let onEvent: ((event: SessionEvent) => void) | null = null;
  let handle = 0;
  let tracked = true;
  let fresh = true;
  let stop: (() => void) | null = null;
  let over = false;

  const finish = (by: 'page' | 'system'): void => {
    if (over) return;
    over = true;
    stop?.();
    stream.stop();
    sensor.dispose();
    picture.dispose();
    onFrame = null;
    onEvent?.({ kind: 'ended', by });
  };
  const lost = (): void => finish('system');
  const watchVideo = (): void => {
    fresh = true;
    if (!over) video.requestVideoFrameCallback(watchVideo);
  };
  const visibility = (): void => {
    const visible = page.visibilityState === 'visible';
    if (visible) stream.start().catch(lost);
    else stream.stop();
    onEvent?.({ kind: 'visibility', visible });
  };
  /** The context is back, and empty. */
  const restored = (): void => {
    picture = createCameraView(gl);
    fresh = true;
  };
  const setTracked = (next: boolean): void => {
    if (next !== tracked) onEvent?.({ kind: 'tracking', tracked: next });
    tracked = next;
  };
  const tick = (nowS: number): void => {
    handle = clock.requestFrame(tick);
    fitter?.update();
    if (gl.drawingBufferWidth === 0 || gl.drawingBufferHeight === 0) return;
    time.write(frame, nowS);
    setTracked(sensor.present || frame.timeS < SENSOR_PATIENCE_S);
    if (fresh && video.readyState >= video.HAVE_CURRENT_DATA) {
      picture.upload(video);
      fresh = !knowsFrames(video);
    }
    const view = coverCanvas(frame, gl);
    picture.fill(view);
    stand.writeWorldFromView(view.worldFromView);
    setRigidInverse(view.viewFromWorld, view.worldFromView);
    input?.fill(frame);
    onFrame?.(frame);
  };
  const begin = (): void => {
    fitter = createCanvasFitter(canvas);
    input = createPageInput(canvas);
    const unlisten = listenForOrbit(canvas, stand, () => Math.tan(LONG_SIDE_FOV_RAD / 2));
    page.addEventListener('visibilitychange', visibility);
    canvas.addEventListener('webglcontextrestored', restored);
    if (knowsFrames(video)) video.requestVideoFrameCallback(watchVideo);
    handle = clock.requestFrame(tick);
    stop = () => {
      clock.cancelFrame(handle);
      page.removeEventListener('visibilitychange', visibility);
      canvas.removeEventListener('webglcontextrestored', restored);
      unlisten();
      input?.dispose();
      fitter?.dispose();
    };
  };
  return {
    kind: 'camera',
    capabilities: new Set(['camera-image']),
    world: 'image',
    blend: 'opaque',
    start: (frameHandler, eventHandler) => {
      onFrame = frameHandler;
      onEvent = eventHandler;
      if (over) eventHandler({ kind: 'ended', by: 'system' });
      else if (!stop) begin();
    },
    end: async () => finish('page'),
    lost,
  };
}

/** Firefox before 132 does not say when a new picture is there: then every frame takes one. */
function knowsFrames(video: HTMLVideoElement): boolean {
  return 'requestVideoFrameCallback' in video;
}
