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

/** What the middle of each of two eyes shows, 10 m apart; after the program was replaced by itself, too. */
export async function eyes(program: Program) {
  const gl = createGl({ depth: true });
  const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes });
  const views = [-5, 5].map((x, i) => {
    const seen = view((i * WIDTH) / 2, 0, WIDTH / 2, HEIGHT, { eye: i === 0 ? 'left' : 'right' });
    seen.worldFromView[12] = x;
    seen.viewFromWorld[12] = -x;
    return seen;
  });
  player.setSession({ world: 'none', blend: 'opaque' });
  const { shaderErrors } = await player.ready;
  const middles = (): number[][] => [WIDTH / 4, (3 * WIDTH) / 4].map((x) => pixel(gl, x, HEIGHT / 2));
  player.draw(frame(0, views));
  const first = middles();
  await player.replaceProgram(structuredClone(program));
  player.draw(frame(1, views));
  const again = middles();
  const { textures } = player.counts();
  player.dispose();
  return { first, again, textures, left: player.counts().textures, shaderErrors, diagnostics: diagnostics(), error: gl.getError() };
}
