import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { frame, stand } from '../browser/runtime-kit.ts';
import { createGl, lookingAt, readPixels, room, viewOf } from '../browser/scenes-kit.ts';

/** RGBA of a program, bottom row first: two meters before the origin, in a room whose only wall is `wallM` away. */
export async function shoot(program: Program, widthPx: number, heightPx: number, wallM: number): Promise<number[]> {
  const gl = createGl(widthPx, heightPx);
  const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes });
  const camera = lookingAt([0, 0, 2], [0, 0, 0], widthPx / heightPx);
  const view = { ...viewOf(camera, { x: 0, y: 0, widthPx, heightPx }), depth: room(gl, 1, 1, [wallM]) };
  for (const index of [0, 1]) player.draw(frame(index, [view], { framebufferWidthPx: widthPx, framebufferHeightPx: heightPx }));
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const pixels = [...readPixels(gl, widthPx, heightPx)];
  const told = diagnostics();
  player.dispose();
  if (told.length > 0 || gl.getError() !== 0) throw new Error(JSON.stringify(told));
  return pixels;
}
