import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { frame, stand } from '../browser/runtime-kit.ts';
import { createGl, HEIGHT, lookingAt, readPixels, room, viewOf, WIDTH } from '../browser/scenes-kit.ts';

/** Two meters before what stands at the origin. */
const FACING = lookingAt([0, 0, 2], [0, 0, 0]);

/** Pictures of programs in a room that is so far away in its left half, and 5 m in its right one; bottom row first. */
export async function shoot(programs: readonly Program[], model: string, leftM: number): Promise<number[][]> {
  const load = async (): Promise<ArrayBuffer> => (await fetch(model)).arrayBuffer();
  const pictures: number[][] = [];
  for (const program of programs) {
    const gl = createGl();
    const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes, assets: { load } });
    const view = { ...viewOf(FACING), depth: room(gl, 2, 1, [leftM, 5]) };
    for (const index of [0, 1]) player.draw(frame(index, [view], { framebufferWidthPx: WIDTH, framebufferHeightPx: HEIGHT }));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    pictures.push([...readPixels(gl, WIDTH, HEIGHT)]);
    const told = diagnostics();
    player.dispose();
    if (told.length > 0 || gl.getError() !== 0) throw new Error(JSON.stringify(told));
  }
  return pictures;
}
