import { FAR_M, NEAR_M } from '../matrix.ts';
import { type AuthoredRoom, createAuthoredRoom } from './authored-room.ts';
import { createViewSources, type ViewSources } from './view-sources.ts';
import type { XrBinding } from './webxr-types.ts';

/** What a session and the page's graphics context share: where views are drawn, and what the device sees. */
export interface WebXrSurface {
  readonly layer: XRWebGLLayer;
  readonly sources: ViewSources;
  /** Null where the browser has none. */
  readonly binding: XrBinding | null;
  readonly room: AuthoredRoom | null;
  dispose(): void;
}

export interface SurfaceWishes {
  readonly antialias: boolean;
  readonly wantsDepth: boolean;
  /** Height of the floor of a room that stands in for the visitor's; null where that is seen. */
  readonly authoredFloorM: number | null;
}

/** Near and far planes that the browser makes its projections with. */
const DEPTH_RANGE = { depthNear: NEAR_M, depthFar: FAR_M } as const;

/**
 * Joins the two. A lost context takes its layers and bindings with it, and must be made compatible again when it is back
 * (WebXR Device API §11.4): then this is done once more for the session that went on meanwhile.
 */
export async function createSurface(gl: WebGL2RenderingContext, session: XRSession, wishes: SurfaceWishes): Promise<WebXrSurface> {
  await gl.makeXRCompatible();
  const layer = new XRWebGLLayer(session, gl, { antialias: wishes.antialias, alpha: true, depth: true, stencil: false });
  await session.updateRenderState({ baseLayer: layer, ...DEPTH_RANGE });
  const binding = typeof XRWebGLBinding === 'undefined' ? null : (new XRWebGLBinding(session, gl) as XrBinding);
  const room = wishes.authoredFloorM === null ? null : createAuthoredRoom(gl, wishes.authoredFloorM);
  const sources = createViewSources(gl, session, binding, wishes.wantsDepth);
  const dispose = () => {
    sources.dispose();
    room?.dispose();
  };
  return { layer, sources, binding, room, dispose };
}
