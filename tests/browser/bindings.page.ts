import type { Program } from '../../export/program/program.ts';
import * as expressionBinding from '../../nodes/binding/expression/runtime.ts';
import * as trackBinding from '../../nodes/binding/track/runtime.ts';
import { type Easing, ease } from '../../nodes/kit/ease.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import * as cameraVideo from '../../nodes/source/camera-video/runtime.ts';
import * as expression from '../../nodes/value/expression/runtime.ts';
import { createGl, frame, HEIGHT, pixel, stand, texture, view, WIDTH } from './runtime-kit.ts';

const MODULES: Readonly<Record<string, NodeModule>> = {
  'binding/expression': expressionBinding,
  'binding/track': trackBinding,
  'source/camera-video': cameraVideo,
  'value/expression': expression,
};

export interface Played {
  readonly center: readonly number[];
  readonly diagnostics: readonly unknown[];
  readonly error: number;
}

/** Plays a compiled program over a camera picture of one color; the frame is the first one drawn. */
export async function play(program: Program, timeS: number, camera: number[]): Promise<Played> {
  const gl = createGl();
  const { player, diagnostics } = await stand(program, { gl, modules: MODULES });
  const uvFromViewUv = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);
  const cameraImage = { texture: texture(gl, 1, 1, camera), widthPx: 1, heightPx: 1, uvFromViewUv };
  player.setSession({ world: 'image', blend: 'opaque' });
  player.draw(frame(0, [view(0, 0, WIDTH, HEIGHT, { cameraImage })], { timeS }));
  const played = { center: pixel(gl, WIDTH / 2, HEIGHT / 2), diagnostics: diagnostics(), error: gl.getError() };
  player.dispose();
  return played;
}

/** How far an animation of the browser's own is, and how far a track, at the same times. */
export function easings(list: readonly Easing[], times: readonly number[]): { readonly css: number; readonly track: number }[] {
  return list.flatMap((easing) => {
    const css = typeof easing === 'string' ? easing : `cubic-bezier(${easing.join(', ')})`;
    const animation = document.body.animate({ opacity: [0, 1] }, { duration: 1000, easing: css, fill: 'both' });
    animation.pause();
    const both = times.map((time) => {
      animation.currentTime = time * 1000;
      return { css: animation.effect?.getComputedTiming().progress ?? -1, track: ease(easing, time) };
    });
    animation.cancel();
    return both;
  });
}
