import type { Program } from '../../export/program/program.ts';
import { readColor } from '../../export/runtime/readback.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { createGl, frame, HEIGHT, pixel, stand, texture, view, WIDTH } from './runtime-kit.ts';

const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** What to do before each frame is drawn. */
export type Act = 'nothing' | 'reset' | 'recompile';

/**
 * Plays a program over camera pictures of one color, each view its own, and gives for every frame what each view shows on screen,
 * and what the tap shows of the first. `cameras` is by frame and view.
 */
export async function play(first: Program, second: Program, cameras: readonly number[][][], acts: readonly Act[], tap: string) {
  const gl = createGl();
  const { player, diagnostics } = await stand(first, { gl, modules: RUNTIMES });
  player.setSession({ world: 'image', blend: 'opaque' });
  const shown: number[][][] = [];
  const tapped: number[][] = [];
  for (const [index, colors] of cameras.entries()) {
    if (acts[index] === 'reset') player.reset();
    if (acts[index] === 'recompile') await player.replaceProgram(second);
    const widthPx = WIDTH / colors.length;
    const views = colors.map((color, i) =>
      view(i * widthPx, 0, widthPx, HEIGHT, {
        cameraImage: { texture: texture(gl, 1, 1, color), widthPx: 1, heightPx: 1, uvFromViewUv: UPRIGHT },
      }),
    );
    player.draw(frame(index, views));
    shown.push(colors.map((_, i) => pixel(gl, (i + 0.5) * widthPx, HEIGHT / 2)));
    tapped.push([...(readColor(player.inspect(tap), 0)?.pixels.subarray(0, 4) ?? [])]);
  }
  player.dispose();
  return { shown, tapped, diagnostics: diagnostics(), error: gl.getError() };
}
