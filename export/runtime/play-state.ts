import type { Session, SessionFrame, ViewFrame } from '../../nodes/kit/session.ts';
import type { TakenPanorama } from '../../nodes/kit/taken-panorama.ts';
import { createSessionInput } from './sessions/input/session-input.ts';

/** Current position of the player within a frame; one object that is changed in place. */
export interface PlayState {
  frame: SessionFrame;
  /** Number of sessions that have begun. */
  sessions: number;
  /** Whether the session hides the page. */
  hidesPage: boolean;
  /** How the display of the session mixes the image with the world. */
  blend: Session['blend'];
  /** The panorama of the room that the visitor has taken; null for none. */
  panorama: TakenPanorama | null;
  /** Index of the view that is drawn; that of the first view during operations that run once per frame. */
  viewIndex: number;
  view: ViewFrame | null;
  /** Size of the view, pixels. */
  widthPx: number;
  heightPx: number;
}

export const EMPTY_FRAME: SessionFrame = {
  index: 0,
  timeS: 0,
  deltaS: 0,
  viewCount: 0,
  views: [],
  framebuffer: null,
  framebufferWidthPx: 0,
  framebufferHeightPx: 0,
  light: null,
  jumps: 0,
  input: createSessionInput(),
};

export function createPlayState(): PlayState {
  return {
    frame: EMPTY_FRAME,
    sessions: 0,
    hidesPage: false,
    blend: 'opaque',
    panorama: null,
    viewIndex: 0,
    view: null,
    widthPx: 0,
    heightPx: 0,
  };
}

export function enterView(state: PlayState, viewIndex: number): void {
  const view = state.frame.views[viewIndex] ?? null;
  state.viewIndex = viewIndex;
  state.view = view;
  state.widthPx = view?.viewport.widthPx ?? 0;
  state.heightPx = view?.viewport.heightPx ?? 0;
}
