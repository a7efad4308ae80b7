import type { AnchorService } from '../../../nodes/kit/anchors.ts';
import type { KeptFiles } from '../../../nodes/kit/kept-files.ts';
import type { SessionService } from '../../../nodes/kit/runtime.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { KeptStorage } from './anchor-memory.ts';

/**
 * Hit tests and anchors of a player. Pages whose program needs neither `hit-test` nor `anchors` are bundled without it. It lives as
 * long as the player, because the state of nodes outlives a lost context.
 */
export interface Spatial extends Pick<SessionService, 'openHitTest' | 'castRay' | 'answerRays' | 'depthImage'> {
  readonly anchors: AnchorService;
  readonly keptFiles: KeptFiles;
  /** Sets the current frame and updates anchors. Called once per frame, before nodes are updated. */
  enterFrame(frame: SessionFrame): void;
  /** Leaves the session: its anchors end; hit tests stay open and continue with the frames of the next session. */
  leaveSession(): void;
  /** Resolves when the device has answered requests that need no further frame; null if there are none. */
  settle(): Promise<void> | null;
  contextLost(): void;
  counts(): SpatialCounts;
  dispose(): void;
}

/** Number of open requests, for leak tests. */
export interface SpatialCounts {
  readonly hitTests: number;
  /** Hit-test sources that the device holds. */
  readonly deviceSources: number;
  readonly anchors: number;
}

/** Where a page stores which anchors the device keeps for it, and its kept files. */
export interface KeptAnchors {
  readonly storage: KeptStorage | null;
  /** Path of the page, which distinguishes its anchors from those of other pages of the origin. */
  readonly page: string;
}

export type CreateSpatial = (parts: {
  readonly gl: WebGL2RenderingContext;
  readonly held: boolean;
  /** Where kept anchors are stored; absent: they are known until the player is disposed. */
  readonly keptAnchors?: KeptAnchors;
}) => Spatial;
