import type { Capability } from '../../../../nodes/kit/definition.ts';
import { isPose } from '../../../../nodes/kit/pose.ts';
import type { Session, SessionEvent, SessionFrame, XrAccess } from '../../../../nodes/kit/session.ts';
import { MAX_VIEWS } from '../../targets/target.ts';
import { createFrameTime } from '../frame-time.ts';
import type { SessionInputs } from '../input/session-inputs.ts';
import { setRigidInverse } from '../matrix.ts';
import { createSessionFrame } from '../session-frame.ts';
import { createRoomCapture } from './room-capture.ts';
import { createSensorWatch } from './sensor-watch.ts';
import { createSurfaceReader } from './webxr-detected-surfaces.ts';
import { createWebXrLight } from './webxr-light.ts';
import type { XrRenderTarget } from './xr-render-target.ts';

export interface WebXrSessionParts {
  readonly gl: WebGL2RenderingContext;
  readonly session: XRSession;
  /** The reference space that the browser resets when the visitor re-centers. */
  readonly origin: XRReferenceSpace;
  /** A space with its floor at y = 0. */
  readonly referenceSpace: XRReferenceSpace;
  readonly target: XrRenderTarget;
  /** Creates the target again for a restored context. Rejects if the device refuses. */
  readonly renewTarget: () => Promise<XrRenderTarget>;
  readonly capabilities: ReadonlySet<Capability>;
  /** Functions that read input; absent or null: frames have no input. */
  readonly inputs?: SessionInputs | null;
}

/** A running WebXR session with its own frame loop (ADR 7). */
export function createWebXrSession(parts: WebXrSessionParts): Session {
  const { gl, session, origin, referenceSpace, capabilities } = parts;
  const frame = createSessionFrame();
  const time = createFrameTime();
  /** The current render target; null while the context is lost. */
  let target: XrRenderTarget | null = parts.target;
  const light = capabilities.has('light-estimation') ? createWebXrLight(session) : null;
  const surfaces = createSurfaceReader(capabilities);
  const roomCapture = createRoomCapture(session, capabilities, (capture) => onEvent?.({ kind: 'room-unknown', capture }));
  const watchOf = (capability: Capability) => createSensorWatch((working) => onEvent?.({ kind: 'sensing', capability, working }));
  const depthWatch = capabilities.has('depth') ? watchOf('depth') : null;
  const lightWatch = light ? watchOf('light-estimation') : null;
  const input = parts.inputs?.webXr(session, referenceSpace) ?? null;
  const access: { -readonly [K in keyof XrAccess]: XrAccess[K] } = { session, frame: session, referenceSpace, capabilities };
  frame.xr = access;
  const wantsCamera = capabilities.has('camera-image');
  let onFrame: ((frame: SessionFrame) => void) | null = null;
  let onEvent: ((event: SessionEvent) => void) | null = null;
  let tracked = true;
  let endedBy: 'user' | 'system' | 'page' = 'user';
  let ended: Promise<void> | null = null;

  const setTracked = (next: boolean): void => {
    if (next !== tracked) onEvent?.({ kind: 'tracking', tracked: next });
    tracked = next;
  };
  const fillViews = ({ layer, sources, room }: XrRenderTarget, xrFrame: XRFrame, pose: XRViewerPose): void => {
    let count = 0;
    for (const xrView of pose.views) {
      const view = frame.views[count];
      const viewport = layer.getViewport(xrView);
      // Emulators give a monoscopic device a second view of zero width.
      if (!view || !viewport || viewport.width < 1 || viewport.height < 1) continue;
      view.eye = xrView.eye;
      view.clipFromView.set(xrView.projectionMatrix);
      view.worldFromView.set(xrView.transform.matrix);
      setRigidInverse(view.viewFromWorld, view.worldFromView);
      view.viewport.x = viewport.x;
      view.viewport.y = viewport.y;
      view.viewport.widthPx = viewport.width;
      view.viewport.heightPx = viewport.height;
      view.depth = sources.depth(xrFrame, xrView, count, view);
      view.cameraImage = room ? room.image(view, count) : wantsCamera ? sources.cameraImage(xrView, count) : null;
      count++;
      if (count === MAX_VIEWS) break;
    }
    frame.viewCount = count;
  };
  const tick = (timeMs: number, xrFrame: XRFrame): void => {
    session.requestAnimationFrame(tick);
    const found = xrFrame.getViewerPose(referenceSpace);
    const pose = found && isPose(found.transform.matrix) ? found : null;
    setTracked(pose ? !pose.emulatedPosition : false);
    if (!pose) input?.skip();
    if (!pose || !target) return;
    time.write(frame, timeMs / 1000);
    const { layer } = target;
    frame.framebuffer = layer.framebuffer;
    frame.framebufferWidthPx = layer.framebufferWidth;
    frame.framebufferHeightPx = layer.framebufferHeight;
    frame.light = light?.read(xrFrame, referenceSpace, target.binding) ?? null;
    frame.surfaces = surfaces?.read(xrFrame, referenceSpace) ?? null;
    if (frame.surfaces) roomCapture?.update(frame.timeS, frame.surfaces);
    fillViews(target, xrFrame, pose);
    if (frame.viewCount === 0) return;
    lightWatch?.update(frame.timeS, frame.light !== null);
    depthWatch?.update(frame.timeS, hasDepth(frame));
    input?.fill(frame.input, xrFrame);
    access.frame = xrFrame;
    onFrame?.(frame);
  };
  const lost = (): void => {
    target = null;
  };
  const restored = async (): Promise<void> => {
    try {
      const renewed = await parts.renewTarget();
      if (onFrame && !gl.isContextLost()) target = renewed;
      else renewed.dispose();
    } catch {
      // The session ended meanwhile, or the device refused.
      endedBy = 'system';
      await session.end().catch(() => {});
    }
  };
  const onRestored = (): void => void restored();
  gl.canvas.addEventListener('webglcontextlost', lost);
  gl.canvas.addEventListener('webglcontextrestored', onRestored);
  const hasEnded = new Promise<void>((resolve) => {
    session.addEventListener('end', () => {
      gl.canvas.removeEventListener('webglcontextlost', lost);
      gl.canvas.removeEventListener('webglcontextrestored', onRestored);
      target?.dispose();
      target = null;
      onFrame = null;
      onEvent?.({ kind: 'ended', by: endedBy });
      resolve();
    });
  });
  let visible = true;
  session.addEventListener('visibilitychange', () => {
    // `visible-blurred`, behind a system menu, still counts as visible.
    const next = session.visibilityState !== 'hidden';
    if (next !== visible) onEvent?.({ kind: 'visibility', visible: next });
    visible = next;
  });
  // Not every browser dispatches `reset` to an offset space.
  origin.addEventListener('reset', ({ transform }) => {
    // The event has the new origin in the former space. An offset of the height of the eyes changes nothing: re-centering turns about y.
    frame.worldFromFormer = transform ? Float32Array.from(transform.inverse.matrix) : null;
    frame.jumps++;
    onEvent?.({ kind: 'recentered' });
  });
  return {
    kind: 'webxr',
    capabilities,
    world: parts.target.room ? 'image' : session.environmentBlendMode === 'opaque' ? 'none' : 'device',
    blend: session.environmentBlendMode === 'additive' ? 'additive' : session.environmentBlendMode === 'opaque' ? 'opaque' : 'alpha',
    hidesPage: !session.domOverlayState,
    start: (frameHandler, eventHandler) => {
      onFrame = frameHandler;
      onEvent = eventHandler;
      session.requestAnimationFrame(tick);
    },
    end: () => {
      endedBy = 'page';
      // The device may have ended it meanwhile.
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

function hasDepth({ views, viewCount }: SessionFrame): boolean {
  for (let i = 0; i < viewCount; i++) if (views[i]?.depth) return true;
  return false;
}
