import type { Program } from '../../export/program/program.ts';
import type { NodeContext, NodeModule } from '../../nodes/kit/runtime.ts';
import { createGl, frame, pass, pixel, program, shader, stand } from './runtime-kit.ts';
import { counting, countingModule, outcome, valueNode } from './runtime-swap.page.ts';

/** The context goes and comes back: what was on screen is there again, params included. */
export async function contextLoss() {
  const gl = createGl();
  const lose = gl.getExtension('WEBGL_lose_context');
  const canvas = gl.canvas as HTMLCanvasElement;
  const tinted = program({
    slots: { numbers: [1, 0, 0, 1], texts: [], slots: [{ type: 'color', offset: 0 }], params: { 'flat.color': 0 } },
    shaders: [shader('flat', 'color = tint;', 'uniform vec4 tint;')],
    operations: [pass('flat', 0, 'screen', { uniforms: [{ name: 'tint', type: 'vec4', source: { slot: 0 } }] })],
  });
  const { player } = await stand(tinted, { gl });
  player.setParam('flat', 'color', [0, 1, 0, 1]);
  const event = (name: string): Promise<void> =>
    new Promise((resolve) => {
      const listener = (e: Event): void => {
        e.preventDefault();
        resolve();
      };
      canvas.addEventListener(name, listener, { once: true });
    });
  const lost = event('webglcontextlost');
  lose?.loseContext();
  await lost;
  player.contextLost();
  player.draw(frame(0));
  const whileLost = player.counts().programs;
  const restored = event('webglcontextrestored');
  // Not allowed within the event's own task.
  await new Promise((resolve) => setTimeout(resolve, 0));
  lose?.restoreContext();
  await restored;
  const result = await player.restore();
  player.draw(frame(1));
  const shown = pixel(gl, 3, 3);
  player.dispose();
  return { whileLost, result: outcome(result), shown, error: gl.getError() };
}

/**
 * Three losses: a node that counts goes on where it was, with its param as it was set, while one that holds something of the GPU's
 * is created again; the same objects are made each time. Then a program that came while nothing could be drawn, and a reset.
 */
export async function stateOutlivesContext() {
  const log: string[] = [];
  const onGpu: NodeModule = {
    create: (ctx) => {
      const { gl } = ctx as unknown as NodeContext<never>;
      log.push('create painter');
      const texture = gl.createTexture();
      return {
        update: () => {},
        dispose: () => {
          log.push('dispose painter');
          gl.deleteTexture(texture);
        },
      };
    },
  };
  const gl = createGl();
  const lose = gl.getExtension('WEBGL_lose_context');
  const canvas = gl.canvas as HTMLCanvasElement;
  const plays = (value: number): Program => {
    const counts = counting({ step: 0, result: 1, value });
    return { ...counts, operations: [valueNode('painter', 2, { outputs: {} }), ...counts.operations] };
  };
  const { player, diagnostics } = await stand(plays(1), { gl, modules: { count: countingModule(log), painter: onGpu } });
  const red = (): number | undefined => {
    player.draw(frame(0));
    return pixel(gl, 3, 3)[0];
  };
  const heard = (name: string): Promise<void> =>
    new Promise((resolve) => {
      const listener = (e: Event): void => {
        e.preventDefault();
        resolve();
      };
      canvas.addEventListener(name, listener, { once: true });
    });
  const interrupt = async (meanwhile: () => void): Promise<void> => {
    const lost = heard('webglcontextlost');
    lose?.loseContext();
    await lost;
    player.contextLost();
    player.draw(frame(0));
    meanwhile();
    const restored = heard('webglcontextrestored');
    await new Promise((resolve) => setTimeout(resolve, 0));
    lose?.restoreContext();
    await restored;
    await player.restore();
  };
  player.setParam('count', 'step', 10);
  const counted = [red(), red()];
  const objects = [player.counts()];
  for (let i = 0; i < 3; i++) {
    await interrupt(() => {});
    counted.push(red());
    objects.push(player.counts());
  }
  // Set while there was nothing to set it in.
  await interrupt(() => player.setParam('count', 'step', 3));
  counted.push(red());
  await interrupt(() => void player.replaceProgram(plays(5)));
  counted.push(red());
  await interrupt(() => player.reset());
  counted.push(red());
  const logged = [...log];
  player.dispose();
  return {
    counted,
    sameObjects: objects.every((counts) => JSON.stringify(counts) === JSON.stringify(objects[0])),
    made: logged.filter((line) => line === 'create count').length,
    painted: logged.filter((line) => line === 'create painter').length,
    live: log.filter((line) => line.startsWith('create')).length - log.filter((line) => line.startsWith('dispose')).length,
    diagnostics: diagnostics(),
    error: gl.getError(),
  };
}
