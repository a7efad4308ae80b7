import type { Result } from '../../nodes/kit/diagnostics.ts';
import type { Session, SessionEvent } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { FrameClock } from '../runtime/clock.ts';
import type { SessionInputs } from '../runtime/sessions/input/session-inputs.ts';
import type { EnteredSessions } from './entered-sessions.ts';
import type { Mounted } from './mount.ts';
import { showDiagnostics } from './notices.ts';
import type { PageRoot } from './page-root.ts';
import type { PanoramaStep } from './panorama-step/panorama-step.ts';
import type { SessionMode, SessionModes } from './session-modes.ts';

export interface SessionEntryOptions {
  readonly page: Window;
  readonly root: PageRoot;
  readonly program: Program;
  readonly modes: SessionModes;
  readonly mounted: Mounted;
  readonly step: PanoramaStep | null;
  readonly clock: FrameClock;
  readonly inputs: SessionInputs | null;
  readonly lookAround: () => Promise<void>;
}

/** Enters the sessions of a page (camera, AR, VR) and shows their notices. A page whose program plays in none does without. */
export interface SessionEntry {
  /**
   * Sets the sessions that can be entered, and offers them.
   *
   * @param loaded Null if they could not be loaded or this device has none.
   * @param reason Why no better mode is offered, as text for visitors, or null.
   */
  offer(loaded: EnteredSessions | null, reason: string | null): void;
  /** Enters a session mode that was offered. Call it from a click handler. On failure it shows the reason and the fallbacks and keeps the orbit view. */
  enter(mode: SessionMode): Promise<void>;
  /** Takes an event of a session that was entered. */
  onEvent(event: SessionEvent, session: Session): void;
}

export function createSessionEntry({
  page,
  root,
  program,
  modes,
  mounted,
  step,
  clock,
  inputs,
  lookAround,
}: SessionEntryOptions): SessionEntry {
  const { canvas, notices, panel } = root;
  /** Mode of the current WebXR session. */
  let immersive: 'ar' | 'vr' = 'ar';
  let { offers } = modes;
  let sessions: EnteredSessions | null = null;
  let noBetter = modes.noAr;
  const offer = () => panel.show({ kind: 'ready', offers: sessions ? offers : [], reason: noBetter });

  const take = (mode: SessionMode, event: SessionEvent, { hidesPage = false }: Session, { texts, offerRoomScan }: EnteredSessions) => {
    switch (event.kind) {
      case 'ended':
        for (const topic of ['tracking', 'missing', 'hint', 'room', ...Object.keys(texts.silent)]) notices.clear(topic);
        step?.end();
        offer();
        root.setMode(null);
        if (event.by === 'page') return;
        notices.show('ended', { text: texts.ended[mode], tone: 'hint' });
        void lookAround();
        return;
      case 'tracking':
        step?.setTracked(event.tracked);
        if (event.tracked) notices.clear('tracking');
        else notices.show('tracking', { text: texts.untracked[mode], tone: 'hint' });
        // The hint says to turn the device.
        if (mode === 'camera' && !event.tracked) notices.clear('hint');
        return;
      case 'sensing': {
        const text = texts.silent[event.capability];
        if (event.working) notices.clear(event.capability);
        else if (text !== undefined) notices.show(event.capability, { text, tone: 'hint' });
        return;
      }
      case 'problem':
        notices.show('session', { text: event.message, tone: 'problem' });
        return;
      case 'room-unknown':
        offerRoomScan?.({ document: page.document, notices, mounted, hidesPage, capture: event.capture });
        return;
      case 'visibility':
      case 'reset':
      case 'recentered':
        return;
      default:
        event satisfies never;
    }
  };
  const request = (
    mode: SessionMode,
    { requestCamera, requestWebXr, createLens, inputs: ofPanel }: EnteredSessions,
  ): Promise<Result<Session>> => {
    const { gl } = mounted;
    if (mode === 'camera' && requestCamera) {
      return requestCamera({ window: page, media: page.navigator.mediaDevices, gl, canvas, clock, inputs, createLens });
    }
    return requestWebXr({
      inputs: inputs ?? ofPanel,
      mode: mode === 'vr' ? 'immersive-vr' : 'immersive-ar',
      xr: page.navigator.xr,
      gl,
      needs: program.needs,
      antialias: program.presentation.antialias,
      screenDepth: program.presentation.screenDepth,
      overlayRoot: root.overlay,
    });
  };

  return {
    onEvent: (event, session) => {
      if (sessions) take(session.kind === 'camera' ? 'camera' : immersive, event, session, sessions);
    },
    offer: (loaded, reason) => {
      sessions = loaded;
      noBetter = reason;
      offer();
    },
    enter: async (mode) => {
      if (sessions === null) return;
      const { cameraHint } = sessions;
      panel.show({ kind: 'entering', mode });
      for (const topic of ['ended', 'session']) notices.clear(topic);
      const { output, diagnostics } = await request(mode, sessions);
      showDiagnostics(notices, 'missing', diagnostics);
      if (output === null) {
        // Offers the fallbacks and another attempt.
        offers = modes.fallbacks;
        offer();
        panel.focus();
        return;
      }
      if (mode !== 'camera') immersive = mode;
      root.setMode(mode);
      if (mode === 'camera' && cameraHint !== null) notices.show('hint', { text: cameraHint, tone: 'hint' });
      if (mode !== 'vr') await step?.begin(output);
      await mounted.play(output);
    },
  };
}
