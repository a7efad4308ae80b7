import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { Session, SessionEvent, SessionFrame } from '../../../../nodes/kit/session.ts';
import { MAX_VIEWS } from '../../targets/target.ts';
import { FAR_M, NEAR_M, setRigidInverse } from '../matrix.ts';
import { createSessionFrame } from '../session-frame.ts';
import { createViewSources } from './view-sources.ts';
import { createWebXrInput } from './webxr-input.ts';
import { createWebXrLight } from './webxr-light.ts';
import type { XrBinding } from './webxr-types.ts';

export interface WebXrSessionParts {
  readonly gl: WebGL2RenderingContext;
  readonly session: XRSession;
  readonly world: XRReferenceSpace;
  readonly layer: XRWebGLLayer;
  readonly binding: XrBinding | null;
  readonly capabilities: ReadonlySet<Capability>;
}

/** Near and far planes that the browser makes its projections with. */
export const XR_DEPTH_RANGE = { depthNear: NEAR_M, depthFar: FAR_M } as const;

/** A running WebXR session with its own frame loop (ADR 7). */
export function createWebXrSession(parts: WebXrSessionParts): Session {
  const { gl, session, world, layer, binding, capabilities } = parts;
  const frame = createSessionFrame();
  const sources = createViewSources(gl, session, binding, capabilities.has('depth'));
  const light = capabilities.has('light-estimation') ? createWebXrLight(session) : null;
  const input = createWebXrInput(session, world);
  const wantsCamera = capabilities.has('camera-image');
  let onFrame: ((frame: SessionFrame) => void) | null = null;
  let onEvent: ((event: SessionEvent) => void) | null = null;
  let startMs: number | null = null;
  let tracked = true;
  let endedByPage = false;
  let ended: Promise<void> | null = null;

  const setTracked = (next: boolean): void => {
    if (next !== tracked) onEvent?.({ kind: 'tracking', tracked: next });
    tracked = next;
  };
  const fillViews = (xrFrame: XRFrame, pose: XRViewerPose): void => {
    let count = 0;
    for (const xrView of pose.views) {
      const view = frame.views[count];
      const viewport = layer.getViewport(xrView);
      // Emulators give a device of one view a second one of no width.
      if (!view || !viewport || viewport.width < 1 || viewport.height < 1) continue;
      view.eye = xrView.eye;
      view.clipFromView.set(xrView.projectionMatrix);
      view.worldFromView.set(xrView.transform.matrix);
      setRigidInverse(view.viewFromWorld, view.worldFromView);
      view.viewport.x = viewport.x;
      view.viewport.y = viewport.y;
      view.viewport.widthPx = viewport.width;
      view.viewport.heightPx = viewport.height;
      view.depth = sources.depth(xrFrame, xrView, count, view.worldFromView);
      view.cameraImage = wantsCamera ? sources.cameraImage(xrView, count) : null;
      count++;
      if (count === MAX_VIEWS) break;
    }
    frame.viewCount = count;
  };
  const tick = (timeMs: number, xrFrame: XRFrame): void => {
    session.requestAnimationFrame(tick);
    const pose = xrFrame.getViewerPose(world);
    setTracked(pose ? !pose.emulatedPosition : false);
    if (!pose) return;
    startMs ??= timeMs;
    const timeS = (timeMs - startMs) / 1000;
    frame.deltaS = Math.max(0, timeS - frame.timeS);
    frame.timeS = timeS;
    frame.framebuffer = layer.framebuffer;
    frame.framebufferWidthPx = layer.framebufferWidth;
    frame.framebufferHeightPx = layer.framebufferHeight;
    frame.light = light?.read(xrFrame, world) ?? null;
    fillViews(xrFrame, pose);
    if (frame.viewCount === 0) return;
    input.fill(frame.input, xrFrame);
    onFrame?.(frame);
    frame.index++;
  };
  const hasEnded = new Promise<void>((resolve) => {
    session.addEventListener('end', () => {
      sources.dispose();
      onFrame = null;
      onEvent?.({ kind: 'ended', by: endedByPage ? 'page' : 'user' });
      resolve();
    });
  });
  let visible = true;
  session.addEventListener('visibilitychange', () => {
    // Blurred behind a menu of the system, it is still seen.
    const next = session.visibilityState !== 'hidden';
    if (next !== visible) onEvent?.({ kind: 'visibility', visible: next });
    visible = next;
  });
  world.addEventListener('reset', () => onEvent?.({ kind: 'reset' }));
  return {
    kind: 'webxr',
    capabilities,
    world: session.environmentBlendMode === 'opaque' ? 'none' : 'device',
    blend: session.environmentBlendMode === 'additive' ? 'additive' : session.environmentBlendMode === 'opaque' ? 'opaque' : 'alpha',
    start: (frameHandler, eventHandler) => {
      onFrame = frameHandler;
      onEvent = eventHandler;
      session.requestAnimationFrame(tick);
    },
    end: () => {
      endedByPage = true;
      // The device may have ended it meanwhile, which is just as well.
      ended ??= Promise.race([
        hasEnded,
        session.end().then(
          () => hasEnded,
          () => {},
        ),
      ]);
      return ended;
    },
  };
}
