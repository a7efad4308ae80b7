import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import type { FrameClock } from '../../export/runtime/clock.ts';
import { createRecordedSession } from '../../export/runtime/sessions/recorded/recorded-session.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { Session } from '../../nodes/kit/session.ts';
import type { PreviewSource } from '../preview-protocol.ts';
import { pageFetch } from './network.ts';
import { createWalk } from './walk.ts';

/** A session of the preview's, and how its time goes. */
export interface OpenSession {
  /** Null where it could not be opened; the diagnostics say why. */
  readonly session: Session | null;
  readonly diagnostics: readonly Diagnostic[];
  /** One frame of the recording, or of the display. */
  readonly frameS: number;
  rewind(): void;
  /** Of an emulated device's screen, from the next frame on; null: as it was. Recordings follow the canvas. */
  resize(sizePx: readonly [width: number, height: number] | null): void;
  end(): Promise<void>;
}

export interface SessionPlace {
  readonly gl: WebGL2RenderingContext;
  readonly clock: FrameClock;
  readonly program: Program;
  /** Where an emulated device shows its picture. */
  readonly screen: HTMLElement;
}

const DISPLAY_FRAME_S = 1 / 60;
const MAX_PIXEL_RATIO = 2;

/** Never rejects. */
export function openSession(source: PreviewSource, place: SessionPlace): Promise<OpenSession> {
  return source.kind === 'recorded' ? openRecording(source.url, place) : openRoom(source, place);
}

async function openRecording(url: string, { gl, clock }: SessionPlace): Promise<OpenSession> {
  const session = createRecordedSession({ gl, files: createFetchAssetSource(url, pageFetch), mode: { kind: 'clock', clock } });
  const { output, diagnostics } = await session.ready;
  return {
    session: output === null ? null : session,
    diagnostics,
    frameS: output === null ? DISPLAY_FRAME_S : output.durationS / output.frameCount,
    rewind: () => session.seek(0),
    resize: () => {},
    end: () => session.end(),
  };
}

async function openRoom(source: Extract<PreviewSource, { kind: 'room' }>, place: SessionPlace): Promise<OpenSession> {
  const { gl, clock, program, screen } = place;
  const room = await loadRoom(source.captureUrl);
  if (room === null) {
    const message = 'The emulated room could not be read.';
    const broken: Diagnostic = { code: 'SCR054', severity: 'error', message, fix: 'Install Scrim again, or choose another source.' };
    return { session: null, diagnostics: [broken], frameS: DISPLAY_FRAME_S, rewind: () => {}, resize: () => {}, end: async () => {} };
  }
  const ratio = Math.min(window.devicePixelRatio, MAX_PIXEL_RATIO);
  const sizePx = [Math.max(1, Math.round(window.innerWidth * ratio)), Math.max(1, Math.round(window.innerHeight * ratio))] as const;
  const device = source.views === 2 ? 'headset' : 'phone';
  const emulator = installEmulator({ device, views: source.views, room, frameClock: clock, container: screen, sizePx });
  const walk = createWalk(emulator, screen, clock);
  const { output, diagnostics } = await requestWebXrSession({
    xr: navigator.xr,
    gl,
    needs: program.needs,
    antialias: program.presentation.antialias,
  });
  return {
    session: output,
    diagnostics,
    frameS: DISPLAY_FRAME_S,
    rewind: walk.rewind,
    resize: (asked) => emulator.setSize(asked ?? sizePx),
    end: async () => {
      walk.dispose();
      await output?.end();
      await emulator.uninstall();
    },
  };
}

async function loadRoom(captureUrl: string | null): Promise<NonNullable<EmulatorOptions['room']> | null> {
  if (captureUrl === null) return 'studio';
  const response = await pageFetch(captureUrl).catch(() => null);
  if (!response?.ok) return null;
  const capture: unknown = await response.json().catch(() => null);
  return capture === null ? null : { capture };
}
