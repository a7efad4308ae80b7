import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createRenderClock } from '../../export/runtime/clock.ts';
import { createPlayer, type Player } from '../../export/runtime/player.ts';
import { readScreen } from '../../export/runtime/readback.ts';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { readRadiance } from '../../export/runtime/scenes/environments/read-radiance.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { createRecordedSession, type RecordedSession } from '../../export/runtime/sessions/recorded/recorded-session.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { FilmRequest, FromPreview, ToPreview } from '../preview-protocol.ts';
import { previewDecoderFile } from './decoder-files.ts';
import { createFilmEncoder, type FilmEncoder } from './film-encoder.ts';
import { pageFetch } from './network.ts';

/** Draws frames of a recording one by one, as `scrim render` does: the same pixels each time. A page films one, and is then left. */
export interface Film {
  /** False where the message is not for it. */
  take(message: ToPreview): boolean;
}

/** As the preview and exported pages have it. */
const SEED = 1;

/** What a film is made with. */
interface FilmSet {
  readonly gl: WebGL2RenderingContext;
  readonly session: RecordedSession;
  readonly encoder: FilmEncoder | null;
  readonly drawn: () => Promise<void>;
}

export function createFilm(send: (message: FromPreview, transfer?: Transferable[]) => void): Film {
  let set: FilmSet | null = null;
  let problems: readonly Diagnostic[] = [];
  const fail = (error: unknown) => {
    const reason = error instanceof Error ? error.message : String(error);
    send({ kind: 'film-failed', diagnostic: { code: 'SCR053', severity: 'error', message: `The frames cannot be drawn: ${reason}` } });
  };
  const begin = async (request: FilmRequest) => {
    const { program, video, widthPx, heightPx } = request;
    const canvas = document.createElement('canvas');
    canvas.width = widthPx;
    canvas.height = heightPx;
    const { antialias } = program.presentation;
    const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false });
    if (!gl || gl.drawingBufferWidth !== widthPx || gl.drawingBufferHeight !== heightPx) {
      throw new Error(`this computer draws no pictures of ${widthPx} × ${heightPx}.`);
    }
    const encoder = video === null ? null : await createFilmEncoder({ canvas, widthPx, heightPx, frameRateHz: video.frameRateHz });
    const createScenes = createScenesWith({ decoders: ALL_DECODERS, files: previewDecoderFile, readRadiance });
    const player = createPlayer({
      gl,
      canvas,
      program,
      modules: RUNTIMES,
      createScenes,
      assets: createFetchAssetSource(request.assetBaseUrl, pageFetch),
      seed: SEED,
      clock: createRenderClock(),
      held: true,
      onDiagnostics: (diagnostics) => {
        problems = diagnostics;
      },
    });
    await player.ready;
    const session = createRecordedSession({ gl, files: createFetchAssetSource(request.url, pageFetch), mode: { kind: 'manual' } });
    const { output, diagnostics } = await session.ready;
    const [broken] = [...diagnostics, ...problems].filter(({ severity }) => severity === 'error');
    if (broken) return send({ kind: 'film-failed', diagnostic: broken });
    if (output === null) throw new Error('the recording cannot be read.');
    set = { gl, session, encoder, drawn: startDrawing(player, session) };
    send({ kind: 'filmed', frame: null });
  };
  const draw = async ({ gl, session, encoder, drawn }: FilmSet, timeS: number, keep: boolean) => {
    if (!(await session.stepTo(timeS))) throw new Error('a picture of the recording is broken.');
    await drawn();
    if (gl.isContextLost()) throw new Error('the graphics device was lost.');
    if (keep && encoder) await encoder.add();
    if (!keep || encoder) return send({ kind: 'filmed', frame: null });
    const { pixels } = readScreen(gl);
    send({ kind: 'filmed', frame: pixels }, [pixels.buffer]);
  };
  const end = async ({ encoder }: FilmSet) => send({ kind: 'film-over', file: (await encoder?.finish()) ?? null });
  return {
    take: (message) => {
      switch (message.kind) {
        case 'film':
          begin(message.request).catch(fail);
          return true;
        case 'film-frame':
          if (set) draw(set, message.timeS, message.keep).catch(fail);
          return true;
        case 'film-end':
          if (set) end(set).catch(fail);
          return true;
        default:
          return false;
      }
    },
  };
}

/** The returned function resolves when everything of the frame that was stepped to is drawn. */
function startDrawing(player: Player, session: RecordedSession): () => Promise<void> {
  let drawing: Promise<void> = Promise.resolve();
  const onFrame = (frame: SessionFrame) => {
    drawing = player.drawSettled(frame);
  };
  player.setSession(session);
  session.start(onFrame, () => {});
  return () => drawing;
}
