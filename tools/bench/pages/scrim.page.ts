import type { Program } from '../../../export/program/program.ts';
import { createOrbitSession } from '../../../export/runtime/sessions/orbit/orbit-session.ts';
import { countFrame, type FrameFacts } from './frame-facts.ts';
import { type Drawn, drawnPixel, drawnPixels, measureFrames } from './frame-ms.ts';
import { type MeasuredPlayer, openPlayer } from './measured-player.ts';

/** Plays a program like a page without AR, with a manual clock. */
export async function open(program: Program, assetsUrl: string, widthPx: number, heightPx: number): Promise<void> {
  const canvas = document.createElement('canvas');
  canvas.style.width = `${widthPx}px`;
  canvas.style.height = `${heightPx}px`;
  document.body.append(canvas);
  const { antialias, around, screenDepth } = program.presentation;
  const gl = canvas.getContext('webgl2', { alpha: true, antialias, depth: screenDepth !== 'none', stencil: false });
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const measured = await openPlayer(gl, canvas, program, new URL(assetsUrl, document.baseURI).href);
  const { player, clock } = measured;
  const session = createOrbitSession({ gl, canvas, clock, ...(around && { start: around }) });
  player.setSession(session);
  session.start(
    (frame) => player.draw(frame),
    () => {},
  );
  stage = { gl, measured, draw: clock.advance };
}

/** Replaces the program that is measured. */
export async function show(program: Program): Promise<void> {
  const result = await stage?.measured.player.replaceProgram(program);
  if (result?.outcome !== 'playing') throw new Error(`The program is not played: ${JSON.stringify(result)}`);
}

/** Milliseconds per frame over `count` frames; see `measureFrames`. */
export function frameMs(count: number): number {
  if (!stage) throw new Error('Nothing is open.');
  const { wrong } = stage.measured;
  if (wrong !== null) throw new Error(`What is measured is not what is to be drawn: ${wrong}`);
  return measureFrames(stage, count);
}

/** The color of a pixel after a frame, RGBA. Origin bottom left. */
export function pixelAt(x: number, y: number): number[] {
  if (!stage) throw new Error('Nothing is open.');
  return drawnPixel(stage, x, y);
}

/** The colors of pixels after a frame, RGBA. Origin bottom left. */
export function pixelsAt(places: readonly (readonly [x: number, y: number])[]): number[][] {
  if (!stage) throw new Error('Nothing is open.');
  return drawnPixels(stage, places);
}

/** Passes and targets of a frame without objects. */
export function facts(): FrameFacts {
  if (!stage) throw new Error('Nothing is open.');
  return countFrame(stage);
}

let stage: (Drawn & { readonly measured: MeasuredPlayer }) | null = null;
