import type { AnchorService } from '../../../nodes/kit/anchors.ts';
import type { SessionService } from '../../../nodes/kit/runtime.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';

/**
 * Hit tests and anchors of a player. Pages whose program needs neither `hit-test` nor `anchors` are bundled without it. It lives as
 * long as the player, because the state of nodes outlives a lost context.
 */
export interface Spatial extends Pick<SessionService, 'openHitTest' | 'castRay'> {
  readonly anchors: AnchorService;
  /** Once a frame, before nodes are updated. */
  enterFrame(frame: SessionFrame): void;
  /** Another session begins, or none: hit tests go on in the next one, anchors are gone. */
  leaveSession(): void;
  /** Resolves when the device has answered what it answers without another frame; null where nothing is asked. */
  settle(): Promise<void> | null;
  contextLost(): void;
  counts(): SpatialCounts;
  dispose(): void;
}

/** What is open, for leak tests. */
export interface SpatialCounts {
  readonly hitTests: number;
  /** Hit-test sources that the device holds. */
  readonly deviceSources: number;
  readonly anchors: number;
}

export type CreateSpatial = (parts: { readonly gl: WebGL2RenderingContext; readonly held: boolean }) => Spatial;
