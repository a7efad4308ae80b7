import type { Program } from '../../../export/program/program.ts';
import { createFetchAssetSource } from '../../../export/runtime/assets/asset-source.ts';
import { createBrowserClock, createManualClock } from '../../../export/runtime/clock.ts';
import { createPlayer } from '../../../export/runtime/player.ts';
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
  const assets = createFetchAssetSource(assetsUrl, fetch.bind(globalThis));
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
      const error = diagnostics.find(({ severity }) => severity === 'error');
      if (error) throw new Error(error.message);
    },
  });
  const session = createOrbitSession({ gl, canvas, clock, ...(around && { start: around }) });
  await player.ready;
  player.setSession(session);
  session.start(
    (frame) => player.draw(frame),
    () => {},
  );
  stage = { gl, draw: clock.advance };
}

/** See `measureFrames`. */
export function frameMs(count: number): number {
  if (!stage) throw new Error('Nothing is open.');
  return measureFrames(stage, count);
}

let stage: Drawn | null = null;
