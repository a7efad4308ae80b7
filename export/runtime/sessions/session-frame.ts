import type {
  CameraImage,
  LightEstimate,
  ReflectionCube,
  RoomDepth,
  SessionFrame,
  ViewFrame,
  Viewport,
} from '../../../nodes/kit/session.ts';
import { MAX_VIEWS } from '../targets/target.ts';
import { createSessionInput, type MutableInput } from './input/session-input.ts';
import { createMatrix, FAR_M, NEAR_M } from './matrix.ts';

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

export type MutableView = Mutable<Omit<ViewFrame, 'viewport'>> & { readonly viewport: Mutable<Viewport> };
export type MutableFrame = Mutable<Omit<SessionFrame, 'views' | 'input'>> & {
  readonly views: readonly MutableView[];
  readonly input: MutableInput;
};
export type MutableCameraImage = Mutable<CameraImage>;
export type MutableRoomDepth = Mutable<RoomDepth>;
export type MutableLight = Mutable<LightEstimate>;
export type MutableReflection = Mutable<ReflectionCube>;

/** Creates the frame object that a session overwrites in every frame. */
export function createSessionFrame(): MutableFrame {
  return {
    index: 0,
    timeS: 0,
    deltaS: 0,
    viewCount: 0,
    views: Array.from({ length: MAX_VIEWS }, createView),
    framebuffer: null,
    framebufferWidthPx: 0,
    framebufferHeightPx: 0,
    light: null,
    surfaces: null,
    jumps: 0,
    worldFromFormer: null,
    roomFile: null,
    xr: null,
    input: createSessionInput(),
  };
}

function createView(): MutableView {
  return {
    eye: 'none',
    clipFromView: createMatrix(),
    worldFromView: createMatrix(),
    viewFromWorld: createMatrix(),
    nearM: NEAR_M,
    farM: FAR_M,
    viewport: { x: 0, y: 0, widthPx: 0, heightPx: 0 },
    cameraImage: null,
    depth: null,
  };
}

/** Sets the frame to one view that covers the canvas, and returns the view. */
export function coverCanvas(frame: MutableFrame, gl: WebGL2RenderingContext): MutableView {
  const [view] = frame.views;
  if (!view) throw new Error('A frame has at least one view.');
  frame.viewCount = 1;
  frame.framebuffer = null;
  frame.framebufferWidthPx = gl.drawingBufferWidth;
  frame.framebufferHeightPx = gl.drawingBufferHeight;
  view.viewport.widthPx = gl.drawingBufferWidth;
  view.viewport.heightPx = gl.drawingBufferHeight;
  return view;
}
