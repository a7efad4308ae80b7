import type { Session, SessionEvent, SessionFrame } from '../../../../nodes/kit/session.ts';
import type { FrameClock } from '../../clock.ts';
import { type CanvasFitter, createCanvasFitter } from '../fit-canvas.ts';
import { createFrameTime } from '../frame-time.ts';
import type { PageInput } from '../input/page-input.ts';
import type { SessionInputs } from '../input/session-inputs.ts';
import { setRigidInverse } from '../matrix.ts';
import { listenForOrbit, type OrbitGestures } from '../orbit/orbit-input.ts';
import { coverCanvas, createSessionFrame } from '../session-frame.ts';
import type { CameraStream } from './camera-stream.ts';
import { createCameraView, LONG_SIDE_FOV_RAD } from './camera-view.ts';
import { createCameraViewer } from './camera-viewer.ts';
import type { CreateLens } from './lens.ts';
import type { OrientationSensor } from './orientation-sensor.ts';

export interface CameraSessionParts {
  readonly gl: WebGL2RenderingContext;
  /** The canvas of `gl`. Its drawing buffer follows its size on the page. */
  readonly canvas: HTMLCanvasElement;
  readonly clock: FrameClock;
  /** A started stream. */
  readonly stream: CameraStream;
  readonly sensor: OrientationSensor;
  /** Functions that read input; absent or null: frames have no input. */
  readonly inputs?: SessionInputs | null;
  /** Sizes the drawing buffer. Default: the size of the canvas on the page. */
  readonly fitter?: CanvasFitter;
  /** Creates the estimation of the field of view; absent or null: the field of view stays as assumed. */
  readonly createLens?: CreateLens | null;
}

/** Time without a reading after which the device is assumed to have no sensor, seconds. */
const SENSOR_TIMEOUT_S = 1.5;

export interface CameraSession extends Session {
  /** The image of the camera. */
  readonly video: HTMLVideoElement;
  /** To be called when the camera stops by itself. */
  lost(): void;
}

/**
 * A session that shows the camera image behind objects that keep their direction as the device rotates. It has no device position, depth,
 * surfaces or light estimation. The field of view of the camera is estimated while the device turns. The camera is off while the page is hidden and after `end`. `tracking` reports whether the orientation
 * sensor works.
 */
export function createCameraSession({
  gl,
  canvas,
  clock,
  stream,
  sensor,
  inputs,
  createLens,
  fitter: given,
}: CameraSessionParts): CameraSession {
  const frame = createSessionFrame();
  const time = createFrameTime();
  const page = canvas.ownerDocument;
  const viewer = createCameraViewer(sensor);
  const { video } = stream;
  const lens = createLens?.(page, sensor) ?? null;
  let image = createCameraView(gl);
  let fitter: CanvasFitter | null = null;
  let input: PageInput | null = null;
  let gestures: OrbitGestures | null = null;
  let onFrame: ((frame: SessionFrame) => void) | null = null;
  let onEvent: ((event: SessionEvent) => void) | null = null;
  const tanHalfLongSide = (): number => lens?.tanHalfLongSide ?? Math.tan(LONG_SIDE_FOV_RAD / 2);
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
    image.dispose();
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
  /** Recreates the camera view after the WebGL context was restored. */
  const restored = (): void => {
    image = createCameraView(gl);
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
    setTracked(sensor.present || frame.timeS < SENSOR_TIMEOUT_S);
    if (fresh && video.readyState >= video.HAVE_CURRENT_DATA) {
      image.upload(video);
      lens?.look(video);
      fresh = !hasFrameCallback(video);
    }
    const view = coverCanvas(frame, gl);
    lens?.update(frame.deltaS);
    image.fill(view, tanHalfLongSide());
    gestures?.settle();
    viewer.writeWorldFromView(view.worldFromView);
    setRigidInverse(view.viewFromWorld, view.worldFromView);
    input?.fill(frame);
    onFrame?.(frame);
  };
  const begin = (): void => {
    fitter = given ?? createCanvasFitter(canvas);
    input = inputs?.page(canvas) ?? null;
    gestures = listenForOrbit(canvas, viewer, tanHalfLongSide, input ?? undefined);
    page.addEventListener('visibilitychange', visibility);
    canvas.addEventListener('webglcontextrestored', restored);
    if (hasFrameCallback(video)) video.requestVideoFrameCallback(watchVideo);
    handle = clock.requestFrame(tick);
    stop = () => {
      clock.cancelFrame(handle);
      page.removeEventListener('visibilitychange', visibility);
      canvas.removeEventListener('webglcontextrestored', restored);
      gestures?.dispose();
      input?.dispose();
      fitter?.dispose();
    };
  };
  return {
    kind: 'camera',
    capabilities: new Set(['camera-image']),
    world: 'image',
    blend: 'opaque',
    video,
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

/**
 * Whether a video reports its new frames. Firefox before 132 lacks `requestVideoFrameCallback`; there the image is uploaded in every frame.
 */
function hasFrameCallback(video: HTMLVideoElement): boolean {
  return 'requestVideoFrameCallback' in video;
}
