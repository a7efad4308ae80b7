import type { XRAnchor, XRPose, XRReferenceSpace, XRRigidTransform } from 'iwer';
import { P_ANCHOR, P_DEVICE, P_FRAME, P_SESSION, XRFrame, XRSpace, XRViewerPose } from 'iwer';
import { Matrix4 } from 'three';
import { EmulatedCpuDepthInformation } from '../depth/depth-information.ts';
import {
  computeHits,
  type EmulatedHitTestResult,
  type EmulatedHitTestSource,
  EmulatedTransientHitTestResult,
  type EmulatedTransientHitTestSource,
} from '../hit-test/hit-test-source.ts';
import { EmulatedLightEstimate, type EmulatedLightProbe, probeState } from '../light/light-probe.ts';
import { P_EMULATED, P_EYE } from '../private.ts';
import type { EmulatedSession } from './emulated-session.ts';
import { EmulatedView } from './emulated-view.ts';

// The messages of Chromium and of iwer, so that the author of a page can look them up.
const OVER = 'XRFrame access outside the callback that produced it is invalid.';
const NO_VIEWS = 'getViewerPose can only be called on XRFrame objects passed to XRSession.requestAnimationFrame callbacks.';

/** An `XRFrame` that computes hits from its own poses when a page requests them. */
export class EmulatedFrame extends XRFrame {
  readonly #session: EmulatedSession;

  constructor(session: EmulatedSession, id: number, timeMs: number) {
    super(session, id, true, false, timeMs);
    this.#session = session;
  }

  override get session(): EmulatedSession {
    return this.#session;
  }

  /** Ends the input events of this frame and starts its animation callbacks, in which views are available. */
  beginAnimation(): void {
    this[P_FRAME].animationFrame = true;
  }

  /** The pose and views of the viewer; null without tracking (WebXR Device API §8.1). */
  override getViewerPose(referenceSpace: XRReferenceSpace): XRViewerPose {
    this.#check();
    if (!this[P_FRAME].animationFrame) throw new DOMException(NO_VIEWS, 'InvalidStateError');
    const { world, eyes, viewportScales } = this.#session[P_EMULATED];
    const { device } = world;
    // iwer's type omits the null of the specification.
    if (!world.tracked && this.#session[P_SESSION].mode !== 'inline') return null as unknown as XRViewerPose;
    const views = eyes.map((eye, index) => {
      const space = device.viewSpaces[eye.name];
      return new EmulatedView(eye, index, viewportScales[index], this.getPose(space, referenceSpace).transform, this.#session, this);
    });
    return new XRViewerPose(this.getPose(device.viewerSpace, referenceSpace).transform, views, false);
  }

  /** The pose of a space in another one; null for an anchor that the device does not see at present (WebXR Anchors §4.2). */
  override getPose(space: XRSpace, baseSpace: XRSpace): XRPose {
    const { world } = this.#session[P_EMULATED];
    if (world.anchorState === 'lost' && this.#isAnchor(space)) return null as unknown as XRPose;
    return super.getPose(space, baseSpace);
  }

  #isAnchor(space: XRSpace): boolean {
    for (const anchor of this.#session[P_SESSION].trackedAnchors) if (anchor[P_ANCHOR].anchorSpace === space) return true;
    return false;
  }

  // Types of iwer require its own classes; pages get the interfaces of the specification.

  override getDepthInformation(view: object): never {
    const depth = this.#session.requireDepth();
    this.#check();
    if (!(view instanceof EmulatedView) || view[P_EYE].frame !== this) throw foreign('view');
    if (depth.usage !== 'cpu-optimized')
      throw new DOMException('The session uses GPU depth. Call getDepthInformation of XRWebGLBinding.', 'InvalidStateError');
    const shot = this.#session[P_EMULATED].world.tracked ? depth.shot(view[P_EYE].index) : null;
    return (shot ? new EmulatedCpuDepthInformation(view, depth, shot) : null) as never;
  }

  // --- Anchors: WebXR Anchors §4 ---

  override async createAnchor(pose: XRRigidTransform, space: XRSpace): Promise<XRAnchor> {
    this.#check();
    // A pose relative to the space in this frame, which stays at its point of the room.
    const { globalSpace } = this.#session[P_EMULATED].world.device[P_DEVICE];
    const worldFromSpace = new Matrix4().fromArray(this.getPose(space, globalSpace).transform.matrix);
    const worldFromAnchor = worldFromSpace.multiply(new Matrix4().fromArray(Array.from(pose.matrix)));
    return this.#session.anchorAt(new XRSpace(globalSpace, new Float32Array(worldFromAnchor.elements)));
  }

  // --- Light: WebXR Lighting Estimation §4.3 ---

  getLightEstimate(probe: EmulatedLightProbe): EmulatedLightEstimate | null {
    this.#check();
    if (probeState(probe)?.session !== this.#session) throw foreign('light probe');
    const light = this.#session[P_EMULATED].light.estimate();
    return light ? new EmulatedLightEstimate(light) : null;
  }

  // --- Hits: WebXR Hit Test §5 ---

  override getHitTestResults(source: object): never {
    this.#check();
    const { hitTests } = this.#session[P_EMULATED];
    const wishes = hitTests.wishes.get(source as EmulatedHitTestSource);
    if (!wishes?.space || !hitTests.active.has(source as EmulatedHitTestSource)) throw foreign('hit test source');
    return this.#hits(wishes.space, wishes) as never;
  }

  getHitTestResultsForTransientInput(source: EmulatedTransientHitTestSource): readonly EmulatedTransientHitTestResult[] {
    this.#check();
    const { hitTests } = this.#session[P_EMULATED];
    const wishes = hitTests.wishes.get(source);
    if (!wishes || !hitTests.active.has(source)) throw foreign('hit test source');
    return this.#session[P_SESSION].activeInputSources
      .filter((input) => input.profiles.some((profile) => profile === wishes.profile))
      .map((input) => new EmulatedTransientHitTestResult(input, this.#hits(input.targetRaySpace, wishes)));
  }

  #hits(space: Parameters<typeof computeHits>[3], wishes: Parameters<typeof computeHits>[4]): EmulatedHitTestResult[] {
    const { world, roomServices } = this.#session[P_EMULATED];
    if (!roomServices.room || !world.tracked) return [];
    return computeHits(this, roomServices.room, world.device[P_DEVICE].globalSpace, space, wishes);
  }

  #check(): void {
    if (!this[P_FRAME].active) throw new DOMException(OVER, 'InvalidStateError');
  }
}

function foreign(what: string): DOMException {
  return new DOMException(`The ${what} belongs to another frame or session, or is cancelled.`, 'InvalidStateError');
}
