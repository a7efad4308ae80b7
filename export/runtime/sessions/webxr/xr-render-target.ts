import type { Presentation } from '../../../program/program-presentation.ts';
import { FAR_M, NEAR_M } from '../matrix.ts';
import { type AuthoredRoom, createAuthoredRoom } from './authored-room.ts';
import { createViewSources, type ViewSources } from './view-sources.ts';
import type { XrBinding } from './webxr-types.ts';

/** Connects a session to the page's WebGL context: the layer that views are drawn into, and the device's images. */
export interface XrRenderTarget {
  readonly layer: XRWebGLLayer;
  readonly sources: ViewSources;
  /** Gives the images of the device; null if the browser has no `XRWebGLBinding`. */
  readonly binding: XrBinding | null;
  readonly room: AuthoredRoom | null;
  dispose(): void;
}

export interface XrRenderTargetOptions {
  readonly antialias: boolean;
  readonly screenDepth: Presentation['screenDepth'] | undefined;
  readonly wantsDepth: boolean;
  /** Whether an authored room replaces the visitor's room. */
  readonly authoredRoom: boolean;
}

/** Near and far planes of the browser's projection matrices. */
const DEPTH_RANGE = { depthNear: NEAR_M, depthFar: FAR_M } as const;

/**
 * Creates the layer and the binding of a session. A lost context loses its layers and bindings, and must be made XR compatible again
 * after it is restored (WebXR Device API §11.4). The session survives, so the caller creates a new target for it.
 */
export async function createXrRenderTarget(
  gl: WebGL2RenderingContext,
  session: XRSession,
  options: XrRenderTargetOptions,
): Promise<XrRenderTarget> {
  await gl.makeXRCompatible();
  const { antialias, screenDepth, authoredRoom } = options;
  const depth = screenDepth !== 'none';
  // A headset that shifts the image by depth shifts wrongly what the depth does not show, as the authored room (ADR 47).
  const ignoreDepthValues = screenDepth !== 'whole' || authoredRoom;
  const layer = new XRWebGLLayer(session, gl, { antialias, alpha: true, depth, stencil: false, ignoreDepthValues });
  await session.updateRenderState({ baseLayer: layer, ...DEPTH_RANGE });
  const binding = typeof XRWebGLBinding === 'undefined' ? null : (new XRWebGLBinding(session, gl) as XrBinding);
  const room = authoredRoom ? createAuthoredRoom(gl) : null;
  const sources = createViewSources(gl, session, binding, options.wantsDepth);
  const dispose = () => {
    sources.dispose();
    room?.dispose();
  };
  return { layer, sources, binding, room, dispose };
}
