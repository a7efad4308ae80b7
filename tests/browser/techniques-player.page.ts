import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { setRigidInverse } from '../../export/runtime/sessions/matrix.ts';
import { createOrbit, ORBIT_DEFAULTS } from '../../export/runtime/sessions/orbit/orbit-pose.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { createGl, frame, HEIGHT, pixel, stand, view, WIDTH } from './runtime-kit.ts';

/** What to do before a frame is drawn. */
export type Act = { readonly program: Program } | { readonly node: string; readonly param: string; readonly value: number[] | number };

/** Plays a program that shows something at the origin from 1 m away: what its middle shows after each act, and what drivers said. */
export async function play(first: Program, acts: readonly Act[]) {
  const gl = createGl({ depth: true });
  const { player, diagnostics } = await stand(first, { gl, modules: RUNTIMES, createScenes });
  const seen = view(0, 0, WIDTH, HEIGHT);
  createOrbit({ ...ORBIT_DEFAULTS, targetWorld: [0, 0, 0], distanceM: 1, elevationRad: 0 }).writeWorldFromView(seen.worldFromView);
  setRigidInverse(seen.viewFromWorld, seen.worldFromView);
  player.setSession({ world: 'none', blend: 'opaque' });
  const shown: number[][] = [];
  const show = (): void => {
    player.draw(frame(shown.length, [seen]));
    shown.push(pixel(gl, WIDTH / 2, HEIGHT / 2));
  };
  show();
  const { shaderErrors } = await player.ready;
  const outcomes: unknown[] = [];
  const errors = [...shaderErrors];
  for (const act of acts) {
    if ('program' in act) {
      const result = await player.replaceProgram(act.program);
      outcomes.push(result.outcome);
      errors.push(...result.shaderErrors);
    } else player.setParam(act.node, act.param, act.value);
    show();
  }
  const programs = player.counts().scenes?.programs;
  player.dispose();
  return { shown, outcomes, errors, programs, diagnostics: diagnostics(), error: gl.getError() };
}
