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
  /** Whether the view before this one, in the same frame, has the same size. */
  sizeIsKnown: boolean;
  /** Whether the view's part of the screen is transparent, because nothing is drawn to it yet. */
  screenIsEmpty: boolean;
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
    sizeIsKnown: false,
    screenIsEmpty: false,
  };
}

export function enterView(state: PlayState, viewIndex: number): void {
  const view = state.frame.views[viewIndex] ?? null;
  const { widthPx = 0, heightPx = 0 } = view?.viewport ?? {};
  state.sizeIsKnown = viewIndex > 0 && widthPx === state.widthPx && heightPx === state.heightPx;
  state.viewIndex = viewIndex;
  state.view = view;
  state.widthPx = widthPx;
  state.heightPx = heightPx;
  state.screenIsEmpty = false;
}
