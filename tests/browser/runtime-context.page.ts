import type { Program } from '../../export/program/program.ts';
import type { NodeContext, NodeModule } from '../../nodes/kit/runtime.ts';
import { createGl, frame, pass, pixel, program, shader, stand } from './runtime-kit.ts';
import { counting, countingModule, outcome, valueNode } from './runtime-swap.page.ts';

/** Resolves when the canvas loses or gets back its context. */
function heard(canvas: HTMLCanvasElement, name: 'webglcontextlost' | 'webglcontextrestored'): Promise<void> {
  return new Promise((resolve) => {
    const listener = (e: Event): void => {
      e.preventDefault();
      resolve();
    };
    canvas.addEventListener(name, listener, { once: true });
  });
}

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
  const lost = heard(canvas, 'webglcontextlost');
  lose?.loseContext();
  await lost;
  player.contextLost();
  player.draw(frame(0));
  const whileLost = player.counts().programs;
  const restored = heard(canvas, 'webglcontextrestored');
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
  const interrupt = async (meanwhile: () => void): Promise<void> => {
    const lost = heard(canvas, 'webglcontextlost');
    lose?.loseContext();
    await lost;
    player.contextLost();
    player.draw(frame(0));
    meanwhile();
    const restored = heard(canvas, 'webglcontextrestored');
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

/** Open hit tests and anchors of a node over changes of the graph and lost contexts. */
export async function spatialCounts() {
  const gl = createGl();
  const lose = gl.getExtension('WEBGL_lose_context');
  const canvas = gl.canvas as HTMLCanvasElement;
  const placer: NodeModule = {
    create: (ctx) => {
      const { gl: held, session } = ctx as unknown as NodeContext<never>;
      const texture = held.createTexture();
      const hitTest = session.openHitTest({ from: 'viewer' });
      const anchor = session.anchors.create(new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]));
      return {
        update: () => {
          hitTest.read();
        },
        dispose: () => {
          hitTest.close();
          anchor.delete();
          held.deleteTexture(texture);
        },
      };
    },
  };
  const empty = program({
    shaders: [shader('flat', 'color = vec4(1.0);')],
    operations: [pass('flat', 0, 'screen')],
  });
  const placing = { ...empty, operations: [valueNode('placer', 0, { outputs: {} }), ...empty.operations] };
  const { player } = await stand(empty, { gl, modules: { placer } });
  const counted: [hitTests: number, anchors: number][] = [];
  const count = () => {
    player.draw(frame(0));
    const { hitTests = -1, anchors = -1 } = player.counts().spatial ?? {};
    counted.push([hitTests, anchors]);
  };
  count();
  for (let i = 0; i < 3; i++) {
    await player.replaceProgram(placing);
    count();
    const lost = heard(canvas, 'webglcontextlost');
    lose?.loseContext();
    await lost;
    player.contextLost();
    const restored = heard(canvas, 'webglcontextrestored');
    await new Promise((resolve) => setTimeout(resolve, 0));
    lose?.restoreContext();
    await restored;
    await player.restore();
    count();
    await player.replaceProgram(empty);
    count();
  }
  player.dispose();
  return { counted, error: gl.getError() };
}
