import { type Diagnostic, hasErrors } from '../../nodes/kit/diagnostics.ts';
import type { Session, SessionEvent } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from '../runtime/assets/asset-source.ts';
import { createBrowserClock } from '../runtime/clock.ts';
import { createOrbitSession } from '../runtime/sessions/orbit/orbit-session.ts';
import { requestWebXrSession } from '../runtime/sessions/webxr/request-session.ts';
import { type Mounted, mount } from './mount.ts';
import type { Notices } from './notices.ts';
import type { Stage } from './stage.ts';
import type { PageParts } from './start-page.ts';

export interface VisitOptions extends PageParts {
  readonly page: Window;
  readonly stage: Stage;
  readonly program: Program;
  readonly assets: AssetSource;
}

/** A visitor's time with the page: looking around, or in AR, and the notices of both. */
export interface Visit {
  /** When the first picture can be drawn. */
  readonly ready: Promise<void>;
  readonly isReady: boolean;
  /** To be called from a click. Says why where it fails, and goes on with looking around. */
  enterAr(): Promise<void>;
  lookAround(): Promise<void>;
}

/** Throws where the browser has no WebGL 2. */
export function createVisit({ page, stage, program, ...parts }: VisitOptions): Visit {
  const { canvas, notices, panel } = stage;
  const clock = createBrowserClock();
  let isReady = false;
  const orbit = (gl: WebGL2RenderingContext) => createOrbitSession({ gl, canvas, clock });
  const mounted: Mounted = mount(canvas, {
    ...parts,
    program,
    session: orbit,
    onDiagnostics: (diagnostics) => showDiagnostics(notices, 'player', diagnostics),
    onSessionEvent: (event, session) => {
      if (session.kind === 'webxr') onArEvent(event);
      else if (event.kind === 'problem') notices.show('session', { text: event.message, tone: 'problem' });
    },
    onContext: (state) => {
      if (state === 'restored') notices.clear('context');
      else
        notices.show('context', {
          text: 'The graphics were interrupted. They come back by themselves, or when the page is reloaded.',
          tone: 'problem',
        });
    },
  });
  const lookAround = () => mounted.play(orbit(mounted.gl));

  const onArEvent = (event: SessionEvent) => {
    switch (event.kind) {
      case 'ended':
        stage.setInAr(false);
        notices.clear('tracking');
        notices.clear('missing');
        panel.show({ kind: 'ar' });
        if (event.by !== 'page') {
          notices.show('ar', { text: 'AR has ended. You can enter it again.', tone: 'hint' });
          void lookAround();
        }
        return;
      case 'tracking':
        if (event.tracked) notices.clear('tracking');
        else notices.show('tracking', { text: 'Looking for the room: move slowly, with enough light.', tone: 'hint' });
        return;
      case 'problem':
        notices.show('ar', { text: event.message, tone: 'problem' });
        return;
      case 'visibility':
      case 'reset':
        return;
    }
  };
  const showAr = async (session: Session) => {
    stage.setInAr(true);
    await mounted.play(session);
  };

  return {
    ready: mounted.player.ready.then(({ shaderErrors }) => {
      isReady = true;
      if (shaderErrors.length === 0) return;
      notices.show('shaders', { text: 'A part of the picture cannot be drawn with this device’s graphics.', tone: 'problem' });
    }),
    get isReady() {
      return isReady;
    },
    enterAr: async () => {
      panel.show({ kind: 'entering' });
      notices.clear('ar');
      const { xr } = page.navigator;
      const { antialias } = program.presentation;
      const { output, diagnostics } = await requestWebXrSession({
        xr,
        gl: mounted.gl,
        needs: program.needs,
        antialias,
        overlayRoot: stage.overlay,
      });
      showDiagnostics(notices, 'missing', diagnostics);
      if (output === null) panel.show({ kind: 'ar' });
      else await showAr(output);
    },
    lookAround,
  };
}

/** One notice for all of a topic: what is wrong, and what a visitor can do about it. */
function showDiagnostics(notices: Notices, topic: string, diagnostics: readonly Diagnostic[]): void {
  const texts = diagnostics.map(({ code, message, fix }) => (fix !== undefined && FOR_VISITORS.has(code) ? `${message} ${fix}` : message));
  if (texts.length === 0) notices.clear(topic);
  else notices.show(topic, { text: [...new Set(texts)].join(' '), tone: hasErrors(diagnostics) ? 'problem' : 'hint' });
}

/** What the device and the browser refuse; what to do about all else is said to designers. */
const FOR_VISITORS: ReadonlySet<string> = new Set(['SCR050', 'SCR051']);
