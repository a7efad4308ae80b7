import type { Program } from '../../export/program/program.ts';
import { readColor } from '../../export/runtime/readback.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { ViewFrame } from '../../nodes/kit/session.ts';
import type { Twins } from '../support/fusion-kit.ts';
import { type Difference, difference } from './fusion-difference.ts';
import { createGl, frame, HEIGHT, type Stand, stand, view, WIDTH } from './runtime-kit.ts';

/** Frames that a program with content that is kept between frames plays. */
const FRAMES = 3;

/** Draws each pair of programs and compares the last frame. The view may be smaller than the canvas. */
export async function compare(
  pairs: readonly Pick<Twins, 'separate' | 'fused'>[],
  widthPx: number = WIDTH,
  heightPx: number = HEIGHT,
): Promise<Difference[]> {
  const differences: Difference[] = [];
  const views = [view(0, 0, widthPx, heightPx)];
  const pixelsOf = async (program: Program) => {
    await draw('single', program, views);
    const pixels = new Uint8Array(WIDTH * HEIGHT * 4);
    gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  };
  for (const { separate, fused } of pairs) differences.push(difference(await pixelsOf(separate), await pixelsOf(fused)));
  return differences;
}

/** Draws two programs with many viewed layers, and compares each layer. */
export async function compareViewed({ separate, fused }: Pick<Twins, 'separate' | 'fused'>): Promise<Difference[]> {
  const before = await drawViewed('separate', separate);
  const after = await drawViewed('fused', fused);
  return before.map((pixels, i) => difference(pixels, after[i] ?? new Uint8Array(pixels.length)));
}

export interface StereoFrame {
  /** Draw calls of the second frame. */
  readonly draws: number;
  readonly left: Uint8Array;
  readonly right: Uint8Array;
}

/** Draws a program for two views side by side, of equal width unless another is given. */
export async function drawStereo(program: Program, rightWidthPx = WIDTH / 2): Promise<StereoFrame> {
  const { player } = await draw('single', program);
  const eyes = [view(0, 0, WIDTH / 2, HEIGHT, { eye: 'left' }), view(WIDTH / 2, 0, rightWidthPx, HEIGHT, { eye: 'right' })];
  player.draw(frame(1, eyes));
  let draws = 0;
  const { drawArrays } = gl;
  gl.drawArrays = (...args) => {
    draws += 1;
    drawArrays.apply(gl, args);
  };
  player.draw(frame(2, eyes));
  gl.drawArrays = drawArrays;
  const pixelsFrom = (x: number) => {
    const pixels = new Uint8Array((WIDTH / 2) * HEIGHT * 4);
    gl.readPixels(x, 0, WIDTH / 2, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  };
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return { draws, left: pixelsFrom(0), right: pixelsFrom(WIDTH / 2) };
}

async function drawViewed(role: Role, program: Program): Promise<Uint8Array[]> {
  const { player } = await draw(role, program);
  return Object.keys(program.taps)
    .sort()
    .map((tap) => {
      const pixels = readColor(player.inspect(tap), 0)?.pixels;
      if (pixels === undefined) throw new Error(`${tap} was not drawn.`);
      return pixels;
    });
}

function frameCount({ resources }: Program): number {
  return resources.some((resource) => resource.kind === 'target' && resource.lifetime === 'persistent') ? FRAMES : 1;
}

const gl = createGl();

/**
 * Players, each for programs that have most shaders in common with its last one. It replaces programs, because most of the time goes into
 * compiling shaders: those of single effects are the same in all parts of a sweep.
 */
type Role = 'single' | 'separate' | 'fused';
const stages = new Map<Role, Stand>();

/** Draws all frames of a program from its first state, and leaves the canvas bound for reading. */
async function draw(role: Role, program: Program, views?: readonly ViewFrame[]): Promise<Stand> {
  const earlier = stages.get(role);
  const stage = earlier ?? (await stand(program, { gl, modules: RUNTIMES, seed: 1, createScenes }));
  stages.set(role, stage);
  const { player, diagnostics } = stage;
  const { outcome, shaderErrors } = await (earlier ? player.replaceProgram(program) : player.ready);
  if (outcome !== 'playing' || shaderErrors.length > 0) throw new Error(`${outcome}: ${JSON.stringify(shaderErrors)}`);
  player.setSession({ world: 'none', blend: 'opaque' });
  player.reset();
  gl.clearColor(0, 0, 0, 0);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.clear(gl.COLOR_BUFFER_BIT);
  for (let i = 0; i < frameCount(program); i++) player.draw(frame(i, views));
  const errors = diagnostics().filter(({ severity }) => severity === 'error');
  if (errors.length > 0) throw new Error(JSON.stringify(errors));
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return stage;
}
