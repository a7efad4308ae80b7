import type { Program } from '../../export/program/program.ts';
import type { GlCounts } from '../../export/runtime/gl/gl-objects.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import * as cameraVideo from '../../nodes/source/camera-video/runtime.ts';
import { createGl, frame, HEIGHT, stand, texture, view, WIDTH } from './runtime-kit.ts';

const MODULES: Readonly<Record<string, NodeModule>> = { 'source/camera-video': cameraVideo };

export interface Drawn {
  /** Per program: RGBA of the whole canvas after a few frames, and the GPU objects there are then. */
  readonly programs: readonly { readonly pixels: readonly number[]; readonly counts: GlCounts }[];
  readonly leaks: Readonly<Record<string, number>>;
  readonly error: number;
}

const NOISE_SIDE_PX = 16;

/** Plays one program after the other on one player, in two views of different widths, over a noisy camera picture. */
export async function draw(programs: readonly Program[]): Promise<Drawn> {
  const [first, ...others] = programs;
  if (!first) throw new Error('There is nothing to draw.');
  const gl = createGl();
  const noise = Array.from({ length: NOISE_SIDE_PX ** 2 * 4 }, (_, i) => (i % 4 === 3 ? 255 : (i * 7919 + i ** 2 * 31) % 256));
  const cameraImage = {
    texture: texture(gl, NOISE_SIDE_PX, NOISE_SIDE_PX, noise),
    widthPx: NOISE_SIDE_PX,
    heightPx: NOISE_SIDE_PX,
    uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1),
  };
  const { player } = await stand(first, { gl, modules: MODULES });
  player.setSession({ world: 'image', blend: 'opaque' });
  const left = WIDTH / 2 - 4;
  const views = [view(0, 0, left, HEIGHT, { cameraImage }), view(left, 0, WIDTH - left, HEIGHT, { cameraImage })];
  const played: { pixels: number[]; counts: GlCounts }[] = [];
  const show = () => {
    for (let i = 0; i < 3; i++) player.draw(frame(i, views));
    const pixels = new Uint8Array(WIDTH * HEIGHT * 4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const { textures, framebuffers, renderbuffers, programs: linked, shaders, samplers, vertexArrays, buffers } = player.counts();
    played.push({
      pixels: [...pixels],
      counts: { textures, framebuffers, renderbuffers, programs: linked, shaders, samplers, vertexArrays, buffers },
    });
  };
  show();
  for (const next of others) {
    await player.replaceProgram(next);
    show();
  }
  player.dispose();
  const { scenes: _, spatial, ...objects } = player.counts();
  return { programs: played, leaks: { ...objects, ...spatial }, error: gl.getError() };
}
