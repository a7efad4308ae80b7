import type { XRFrame, XRRigidTransform, XRSession } from 'iwer';
import { P_FRAME, XRView } from 'iwer';
import type { Eye } from '../display/eye.ts';
import { P_EYE } from '../private.ts';
import { requestScale, scaledViewport, type ViewportPx, type ViewportScale } from './viewport-scale.ts';

/** `XRCamera` of WebXR Raw Camera Access §3.2. */
export class EmulatedCamera {
  readonly width: number;
  readonly height: number;
  readonly [P_EYE]: EmulatedView;

  constructor(view: EmulatedView) {
    const { widthPx, heightPx } = view[P_EYE].eye.viewport;
    this.width = widthPx;
    this.height = heightPx;
    this[P_EYE] = view;
  }
}

export class EmulatedView extends XRView {
  readonly [P_EYE]: {
    readonly eye: Eye;
    readonly index: number;
    readonly frame: XRFrame;
    /** Undefined if the viewport cannot be scaled. */
    readonly scale: ViewportScale | undefined;
    camera: EmulatedCamera | null;
  };

  constructor(eye: Eye, index: number, scale: ViewportScale | undefined, transform: XRRigidTransform, session: XRSession, frame: XRFrame) {
    super(eye.name as string as XRView['eye'], Float32Array.from(eye.clipFromView), transform, session);
    this[P_EYE] = { eye, index, frame, scale, camera: null };
  }

  /** “Obtain camera” of Raw Camera Access §3.1: aligned with the view, of the viewport's size. */
  get camera(): EmulatedCamera | null {
    const state = this[P_EYE];
    if (!state.frame.session.enabledFeatures.includes('camera-access')) return null;
    this.checkFrame();
    state.camera ??= new EmulatedCamera(this);
    return state.camera;
  }

  /** WebXR Device API §7.2: applies from the next `getViewport` on, in this and later frames. */
  override requestViewportScale(scale: number | null | undefined): void {
    const { scale: current } = this[P_EYE];
    if (current) requestScale(current, scale);
  }

  /** The part of `full` that the page draws this view into. */
  viewportIn(full: ViewportPx): ViewportPx {
    const { frame, scale } = this[P_EYE];
    return scale ? scaledViewport(scale, full, frame) : full;
  }

  /** @throws DOMException InvalidStateError if the frame of this view is over. */
  checkFrame(): void {
    if (!this[P_EYE].frame[P_FRAME].active) {
      throw new DOMException('The frame has ended. Views, depth and camera images are valid only in its callback.', 'InvalidStateError');
    }
  }
}
