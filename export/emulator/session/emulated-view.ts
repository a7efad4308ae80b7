import type { XRRigidTransform, XRSession } from 'iwer';
import { P_FRAME, XRView } from 'iwer';
import type { Eye } from '../display/eye.ts';
import { P_EYE } from '../private.ts';
import type { EmulatedFrame } from './emulated-frame.ts';

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
  readonly [P_EYE]: { readonly eye: Eye; readonly index: number; readonly frame: EmulatedFrame; camera: EmulatedCamera | null };

  constructor(eye: Eye, index: number, transform: XRRigidTransform, session: XRSession, frame: EmulatedFrame) {
    super(eye.name as string as XRView['eye'], Float32Array.from(eye.clipFromView), transform, session);
    this[P_EYE] = { eye, index, frame, camera: null };
  }

  /** Raw Camera Access §3.1, "obtain camera": aligned with the view, as large as its viewport. */
  get camera(): EmulatedCamera | null {
    const state = this[P_EYE];
    if (!state.frame.session.enabledFeatures.includes('camera-access')) return null;
    this.checkFrame();
    state.camera ??= new EmulatedCamera(this);
    return state.camera;
  }

  /** @throws DOMException when the frame that this view is of is over. */
  checkFrame(): void {
    if (!this[P_EYE].frame[P_FRAME].active) {
      throw new DOMException('The frame is over: views, depth and camera images are only there in its callback.', 'InvalidStateError');
    }
  }
}
