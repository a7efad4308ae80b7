import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { frame, stand } from '../browser/runtime-kit.ts';
import { createGl, HEIGHT, lookingAt, readPixels, viewOf, WIDTH } from '../browser/scenes-kit.ts';

const CAMERA = lookingAt([0.4, 1.6, 1.6], [0.2, 0.1, 0]);

export interface Played {
  /** Of the last frame, bottom row first. */
  readonly picture: number[];
  /** Draws of the last frame, shadow maps too. */
  readonly draws: number;
  readonly error: number;
}

/** Plays a program for some frames, before the last of which a param is set. */
export async function play(program: Program, set: readonly [string, string, number | readonly number[]] | null): Promise<Played> {
  const gl = createGl();
  let draws = 0;
  for (const name of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced'] as const) {
    const own = gl[name].bind(gl) as (...args: number[]) => void;
    gl[name] = (...args: number[]) => {
      draws++;
      own(...args);
    };
  }
  const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes });
  for (const index of [0, 1, 2]) {
    if (index === 2 && set) player.setParam(set[0], set[1], set[2] as number);
    draws = 0;
    player.draw(frame(index, [viewOf(CAMERA)], { framebufferWidthPx: WIDTH, framebufferHeightPx: HEIGHT }));
  }
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const picture = [...readPixels(gl, WIDTH, HEIGHT)];
  const told = diagnostics();
  player.dispose();
  if (told.length > 0) throw new Error(JSON.stringify(told));
  return { picture, draws, error: gl.getError() };
}
