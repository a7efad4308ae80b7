import type { XRFrame, XRRigidTransform, XRSession } from 'iwer';
import { P_FRAME, XRView } from 'iwer';
import type { Eye } from '../display/eye.ts';
import { P_EYE } from '../private.ts';
import { requestScale, scaledViewport, type ViewportPx, type ViewportScale } from './viewport-scale.ts';

/** XRCamera of WebXR Raw Camera Access §3.2. */
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
    /** Undefined where the viewport cannot be scaled. */
    readonly scale: ViewportScale | undefined;
    camera: EmulatedCamera | null;
  };

  constructor(eye: Eye, index: number, scale: ViewportScale | undefined, transform: XRRigidTransform, session: XRSession, frame: XRFrame) {
    super(eye.name as string as XRView['eye'], Float32Array.from(eye.clipFromView), transform, session);
    this[P_EYE] = { eye, index, frame, scale, camera: null };
  }

  /** Raw Camera Access §3.1, "obtain camera": aligned with the view, as large as its viewport. */
  get camera(): EmulatedCamera | null {
    const state = this[P_EYE];
    if (!state.frame.session.enabledFeatures.includes('camera-access')) return null;
    this.checkFrame();
    state.camera ??= new EmulatedCamera(this);
    return state.camera;
  }

  /** WebXR Device API §7.2: holds from the next question for the viewport on, in this frame and those that follow. */
  override requestViewportScale(scale: number | null | undefined): void {
    const { scale: current } = this[P_EYE];
    if (current) requestScale(current, scale);
  }

  /** The part of `full` that this view is drawn into. */
  viewportIn(full: ViewportPx): ViewportPx {
    const { frame, scale } = this[P_EYE];
    return scale ? scaledViewport(scale, full, frame) : full;
  }

  /** @throws DOMException when the frame that this view is of is over. */
  checkFrame(): void {
    if (!this[P_EYE].frame[P_FRAME].active) {
      throw new DOMException('The frame is over: views, depth and camera images are only there in its callback.', 'InvalidStateError');
    }
  }
}
