import type { DrawOperation, NodeOperation, Program } from '../../export/program/program.ts';
import type { PlayResult } from '../../export/runtime/player.ts';
import { readColor, readDepth } from '../../export/runtime/readback.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import type { NodeContext, NodeModule } from '../../nodes/kit/runtime.ts';
import { trackGl } from '../support/gl-leaks.ts';
import { colorSampler, createGl, frame, HEIGHT, pass, pixel, program, shader, stand, target, view, WIDTH } from './runtime-kit.ts';

const PICTURE = 'uniform sampler2D picture;';

function flat(body: string, id = body): Program {
  return program({
    resources: [target('flat.out', { samples: 4 })],
    shaders: [shader(id, body), shader('show', 'color = texture(picture, uv);', PICTURE)],
    operations: [pass('flat', 0, 'flat.out'), pass('show', 1, 'screen', { samplers: [colorSampler('picture', 'flat.out')] })],
  });
}

export function outcome(result: PlayResult) {
  return { outcome: result.outcome, errors: result.shaderErrors.map(({ shaderId, stage }) => ({ shaderId, stage })) };
}

/** Broken programs never reach the screen once a good one plays. */
export async function keepsTheLastGood() {
  const { gl, player } = await stand(flat('color = vec4(0.0, 1.0, 0.0, 1.0);'));
  const shown = (): number[] => {
    player.draw(frame(0));
    return pixel(gl, 3, 3);
  };
  const good = shown();
  const replacing = player.replaceProgram(flat('color = vec4(nonsense);', 'broken'));
  const meanwhile = shown();
  const broken = await replacing;
  const after = shown();
  const mended = await player.replaceProgram(flat('color = vec4(0.0, 0.0, 1.0, 1.0);'));
  const end = shown();
  player.dispose();
  const log = broken.shaderErrors[0]?.log ?? '';
  return { good, meanwhile, broken: outcome(broken), log, after, mended: outcome(mended), end, error: gl.getError() };
}

/** Without an earlier working program, passes with a broken shader pass their image through until a fixed one replaces them. */
export async function startsBroken() {
  const first = program({
    resources: [target('red.out'), target('broken.out')],
    shaders: [
      shader('red', 'color = vec4(1.0, 0.0, 0.0, 1.0);'),
      shader('broken', 'color = nonsense;', PICTURE),
      shader('show', 'color = texture(picture, uv);', PICTURE),
    ],
    operations: [
      pass('red', 0, 'red.out'),
      pass('broken', 1, 'broken.out', { samplers: [colorSampler('picture', 'red.out')] }),
      pass('show', 2, 'screen', { samplers: [colorSampler('picture', 'broken.out')] }),
    ],
  });
  const { gl, player } = await stand(first);
  const ready = await player.ready;
  player.draw(frame(0));
  const bypassed = pixel(gl, 3, 3);
  const superseded = player.replaceProgram(flat('color = vec4(1.0);'));
  const result = await player.replaceProgram(flat('color = vec4(0.0, 1.0, 0.0, 1.0);'));
  player.draw(frame(1));
  const end = pixel(gl, 3, 3);
  player.dispose();
  return { ready: outcome(ready), bypassed, superseded: outcome(await superseded), result: outcome(result), end, error: gl.getError() };
}

export function valueNode(type: string, slot: number, more: Partial<NodeOperation> = {}): NodeOperation {
  return {
    kind: 'value',
    id: type,
    node: type,
    type,
    reads: [],
    writes: [],
    view: 'once',
    inputs: {},
    multiple: [],
    outputs: { result: { kind: 'slot', slot } },
    params: {},
    config: {},
    assets: {},
    ...more,
  };
}

/** Counts its updates in steps of a param, which may sit in any slot. */
export function countingModule(log: string[]): NodeModule {
  return {
    create: (ctx) => {
      const { node, params, outputs } = ctx as unknown as {
        node: string;
        params: { step: { value: number } };
        outputs: { result: { value: number } };
      };
      log.push(`create ${node}`);
      let count = 0;
      return {
        update: () => {
          count += params.step.value;
          outputs.result.value = count;
        },
        reset: () => {
          count = 0;
        },
        dispose: () => {
          log.push(`dispose ${node}`);
        },
      };
    },
  };
}

export function counting(slots: { step: number; result: number; value: number }, config: Record<string, number> = {}): Program {
  const numbers = [0, 0, 0, 0];
  numbers[slots.step] = slots.value;
  return program({
    slots: {
      numbers,
      texts: [],
      slots: numbers.map((_, offset) => ({ type: 'number' as const, offset })),
      params: { 'count.step': slots.step },
    },
    shaders: [shader('show', 'color = vec4(result / 255.0, 0.0, 0.0, 1.0);', 'uniform float result;')],
    operations: [
      valueNode('count', slots.result, { params: { step: slots.step }, config }),
      pass('show', 0, 'screen', { uniforms: [{ name: 'result', type: 'float', source: { slot: slots.result } }] }),
    ],
  });
}

/** A node keeps its state while its values move to other slots, and restarts when its structure changes. */
export async function nodesLiveOn() {
  const log: string[] = [];
  const { gl, player } = await stand(counting({ step: 0, result: 1, value: 10 }), { modules: { count: countingModule(log) } });
  const red = (): number | undefined => {
    player.draw(frame(0));
    return pixel(gl, 3, 3)[0];
  };
  const counted = [red(), red()];
  await player.replaceProgram(counting({ step: 3, result: 2, value: 1 }));
  counted.push(red());
  player.setParam('count', 'step', 2);
  counted.push(red());
  // Set while the next program, made before, is on its way: the newer value counts.
  const replacing = player.replaceProgram(counting({ step: 0, result: 1, value: 2 }));
  player.setParam('count', 'step', 5);
  await replacing;
  counted.push(red());
  player.reset();
  counted.push(red());
  const logBefore = [...log];
  await player.replaceProgram(counting({ step: 0, result: 1, value: 7 }, { other: 1 }));
  counted.push(red());
  player.dispose();
  return { counted, logBefore, log, error: gl.getError() };
}

/** A drawing node lives on while its picture goes to the screen, then through a pass, then to the screen again. */
export async function drawingLivesOn() {
  const log: string[] = [];
  const fills: NodeModule = {
    create: ({ gl }) => {
      log.push('create');
      return {
        update: () => {},
        draw: () => gl.clearBufferfv(gl.COLOR, 0, new Float32Array([1, 0, 0, 1])),
        dispose: () => log.push('dispose'),
      };
    },
  };
  const drawn = (to: 'screen' | 'layer'): Program =>
    program({
      resources: to === 'screen' ? [] : [target('layer')],
      shaders: to === 'screen' ? [] : [shader('swap', 'color = texture(picture, uv).grba;', PICTURE)],
      operations: [
        {
          ...valueNode('draw', 0),
          kind: 'draw',
          view: 'each',
          outputs: to === 'screen' ? {} : { layer: { kind: 'layer', layer: { color: 'layer', depth: null } } },
          target: to,
          shadowMaps: null,
          occlusion: null,
        } as DrawOperation,
        ...(to === 'screen' ? [] : [pass('swap', 0, 'screen', { samplers: [colorSampler('picture', 'layer')] })]),
      ],
    });
  const { gl, player } = await stand(drawn('screen'), { modules: { draw: fills }, createScenes });
  const shown: number[][] = [];
  for (const to of ['screen', 'layer', 'screen'] as const) {
    await player.replaceProgram(drawn(to));
    player.draw(frame(0));
    shown.push(pixel(gl, 3, 3));
  }
  player.dispose();
  return { shown, log, error: gl.getError() };
}

/** Fifty edits of every sort leave as many GPU objects as one, and the end leaves none. */
export async function leaks() {
  const gl = createGl();
  const leaks = trackGl(gl);
  const variant = (i: number): Program =>
    program({
      resources: [
        target('a.out', { samples: i % 2 === 0 ? 4 : 1, depth: i % 3 === 0 ? 'window' : 'none' }),
        target(i % 2 === 0 ? 'b.out' : 'c.out', { lifetime: 'persistent' }),
      ],
      shaders: [
        shader(`edit ${i}`, i % 5 === 4 ? 'color = nonsense;' : `color = vec4(${i}.0 / 255.0);`),
        shader('show', 'color = texture(picture, uv);', PICTURE),
      ],
      operations: [
        pass('a', 0, 'a.out'),
        pass('b', 1, i % 2 === 0 ? 'b.out' : 'c.out', { samplers: [colorSampler('picture', 'a.out')] }),
        pass('show', 1, 'screen', { samplers: [colorSampler('picture', 'a.out')] }),
      ],
    });
  const { player } = await stand(variant(0), { gl });
  player.draw(frame(0));
  const start = leaks.alive();
  const own = player.counts();
  const outcomes: string[] = [];
  for (let i = 1; i <= 50; i++) {
    const two = [view(0, 0, WIDTH / 2, HEIGHT), view(WIDTH / 2, 0, WIDTH / 2, HEIGHT)];
    // Every seventh is overtaken before it is linked.
    if (i % 7 === 0) void player.replaceProgram(variant(i + 1000));
    outcomes.push((await player.replaceProgram(variant(i))).outcome);
    player.draw(frame(i, i % 4 === 0 ? two : undefined));
  }
  await player.replaceProgram(variant(0));
  player.draw(frame(51));
  const end = leaks.alive();
  player.dispose();
  return { start, end, own, outcomes, after: leaks.report(), error: gl.getError() };
}

/** Layers can be read while they are tapped: color, scaled color, depth, per view. */
export async function taps() {
  const drawing: NodeModule = {
    create: (ctx) => {
      const { gl } = ctx as unknown as NodeContext<never>;
      return {
        update: () => {},
        draw: ({ viewIndex, viewport }) => {
          // Left half of the layer: a flat color per view at window depth 0.5.
          gl.enable(gl.SCISSOR_TEST);
          gl.scissor(viewport.x, viewport.y, viewport.widthPx / 2, viewport.heightPx);
          gl.clearBufferfv(gl.COLOR, 0, new Float32Array([viewIndex, 1, 0, 1]));
          gl.clearBufferfv(gl.DEPTH, 0, new Float32Array([0.5]));
          gl.disable(gl.SCISSOR_TEST);
        },
        dispose: () => {},
      };
    },
  };
  const first = program({
    resources: [
      target('scene.layer', { samples: 4, depth: 'window' }),
      target('meters', { format: 'r32f' }),
      { id: 'outside', kind: 'external', domain: 'image' },
    ],
    shaders: [shader('meters', 'color = vec4(uv.y < 0.5 ? 2.5 : 0.0);'), shader('half', 'color = vec4(uv.y < 0.5 ? 1.0 : 0.0);')],
    operations: [
      {
        ...valueNode('draw', 0),
        kind: 'draw',
        view: 'each',
        outputs: {},
        target: 'scene.layer',
        shadowMaps: null,
        occlusion: null,
      } as DrawOperation,
      pass('meters', 0, 'meters'),
      pass('show', 1, 'screen'),
    ],
    taps: {
      'scene.layer': { color: 'scene.layer', depth: { resource: 'scene.layer', encoding: 'window' } },
      'meters.layer': { color: 'meters', depth: { resource: 'meters', encoding: 'meters' } },
      'outside.layer': { color: 'outside', depth: null },
    },
  });
  const { gl, player } = await stand(first, { modules: { draw: drawing }, createScenes });
  const undrawn = readColor(player.inspect('scene.layer'), 0);
  player.draw(frame(0, [view(0, 0, 32, 32), view(32, 0, 32, 32)]));
  const at = (picture: { widthPx: number; pixels: Uint8Array } | null, x: number, y: number) =>
    picture && [...picture.pixels.subarray((y * picture.widthPx + x) * 4, (y * picture.widthPx + x + 1) * 4)];
  const left = readColor(player.inspect('scene.layer'), 0);
  const right = readColor(player.inspect('scene.layer'), 1);
  const small = readColor(player.inspect('scene.layer'), 1, 8);
  const window = readDepth(player.inspect('scene.layer'), 1);
  const meters = readDepth(player.inspect('meters.layer'), 0);
  const result = {
    undrawn,
    left: [at(left, 2, 2), at(left, 30, 2)],
    right: [at(right, 2, 2), at(right, 30, 2)],
    small: small && [small.widthPx, small.heightPx, at(small, 1, 1), at(small, 6, 1)],
    window: window && [window.meters[2], window.meters[30]],
    // Rows from the top: the upper half of the layer has no depth.
    meters: meters && [meters.meters[0], meters.meters[meters.meters.length - 1]],
    missing: [
      readColor(player.inspect('nothing.layer'), 0),
      readColor(player.inspect('outside.layer'), 0),
      readDepth(player.inspect('outside.layer'), 0),
    ],
    error: gl.getError(),
  };
  player.dispose();
  return result;
}
