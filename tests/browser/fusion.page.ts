import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { Twins } from '../support/fusion-kit.ts';
import { createGl, frame, HEIGHT, stand, WIDTH } from './runtime-kit.ts';

export interface Difference {
  /** Channels of pixels that differ, and by how many of 255 steps at most. */
  readonly differing: number;
  readonly most: number;
  readonly channels: number;
  /** The fraction of channels that are neither 0 nor 255: an image without any tests nothing. */
  readonly tones: number;
}

/** Frames that a program with content that is kept between frames plays. */
const FRAMES = 3;

/** Draws each pair of programs and compares the last frame. */
export async function compare(pairs: readonly Pick<Twins, 'separate' | 'fused'>[]): Promise<Difference[]> {
  const differences: Difference[] = [];
  for (const { separate, fused } of pairs) differences.push(difference(await draw(separate), await draw(fused)));
  return differences;
}

function frameCount({ resources }: Program): number {
  return resources.some((resource) => resource.kind === 'target' && resource.lifetime === 'persistent') ? FRAMES : 1;
}

const gl = createGl();
let stage: Awaited<ReturnType<typeof stand>> | null = null;

async function draw(program: Program): Promise<Uint8Array> {
  stage?.player.dispose();
  stage = await stand(program, { gl, modules: RUNTIMES, seed: 1, createScenes });
  stage.player.setSession({ world: 'none', blend: 'opaque' });
  gl.clearColor(0, 0, 0, 0);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.clear(gl.COLOR_BUFFER_BIT);
  for (let i = 0; i < frameCount(program); i++) stage.player.draw(frame(i));
  const errors = stage.diagnostics().filter(({ severity }) => severity === 'error');
  if (errors.length > 0) throw new Error(JSON.stringify(errors));
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const pixels = new Uint8Array(WIDTH * HEIGHT * 4);
  gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return pixels;
}

function difference(a: Uint8Array, b: Uint8Array): Difference {
  let differing = 0;
  let most = 0;
  let tones = 0;
  for (let i = 0; i < a.length; i++) {
    const value = a[i] ?? 0;
    const apart = Math.abs(value - (b[i] ?? 0));
    if (apart > 0) differing++;
    if (apart > most) most = apart;
    if (value > 0 && value < 255) tones++;
  }
  return { differing, most, channels: a.length, tones: tones / a.length };
}
