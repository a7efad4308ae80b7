import type { Program } from '../../../export/program/program.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createBrowserClock, createManualClock } from '../../../export/runtime/clock.ts';
import { createPlayer, type Player } from '../../../export/runtime/player.ts';
import { createScenesWith } from '../../../export/runtime/scenes/create-scenes.ts';
import { createOrbitSession } from '../../../export/runtime/sessions/orbit/orbit-session.ts';
import { RUNTIMES } from '../../../nodes/generated/runtimes.gen.ts';
import { type Drawn, measureFrames } from './frame-ms.ts';

/** Plays a program as a page without AR does, at a clock of its own. */
export async function open(program: Program, assetsUrl: string, widthPx: number, heightPx: number): Promise<void> {
  const canvas = document.createElement('canvas');
  canvas.style.width = `${widthPx}px`;
  canvas.style.height = `${heightPx}px`;
  document.body.append(canvas);
  const { antialias, around } = program.presentation;
  const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const clock = createManualClock();
  const assets = createFetchAssetSource(new URL(assetsUrl, document.baseURI).href, fetch.bind(globalThis));
  const player = createPlayer({
    gl,
    canvas,
    program,
    modules: RUNTIMES,
    createScenes: createScenesWith({ decoders: {}, files: assets.load }),
    assets,
    seed: 1,
    clock: { ...clock, delay: createBrowserClock().delay },
    onDiagnostics: (diagnostics) => {
      failure = diagnostics.find(({ severity }) => severity === 'error')?.message ?? null;
    },
  });
  const session = createOrbitSession({ gl, canvas, clock, ...(around && { start: around }) });
  await player.ready;
  player.setSession(session);
  session.start(
    (frame) => player.draw(frame),
    () => {},
  );
  stage = { gl, player, draw: clock.advance };
}

/** Plays another program in the place of the one that was opened. */
export async function show(program: Program): Promise<void> {
  const result = await stage?.player.replaceProgram(program);
  if (result?.outcome !== 'playing') throw new Error(`The program is not played: ${JSON.stringify(result)}`);
}

/** See `measureFrames`. */
export function frameMs(count: number): number {
  if (!stage) throw new Error('Nothing is open.');
  if (failure !== null) throw new Error(`What is measured is not what is to be drawn: ${failure}`);
  return measureFrames(stage, count);
}

/** What is missing on the stage, such as a model. */
let failure: string | null = null;
let stage: (Drawn & { readonly player: Player }) | null = null;
