/// <reference types="webxr" />
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import type { NodeOperation, Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createManualClock } from '../../export/runtime/clock.ts';
import type { Player } from '../../export/runtime/player.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { SESSION_INPUTS } from '../../export/runtime/sessions/input/session-inputs.ts';
import { createOrbitSession } from '../../export/runtime/sessions/orbit/orbit-session.ts';
import { requestWebXrSession } from '../../export/runtime/sessions/webxr/request-session.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { NodeModule } from '../../nodes/kit/runtime.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import { type GlLeaks, trackGl } from '../support/gl-leaks.ts';
import { createGl, frame, stand, view } from './runtime-kit.ts';

function assetsAt(url: string) {
  return createFetchAssetSource(new URL(url, location.href).href, (...args) => fetch(...args));
}

/** Goes into AR and out again, as a visitor of the page does: a few frames there, and a few of looking around between. */
export async function enterAndLeave(program: Program, assetUrl: string, times: number) {
  const gl = createGl({ depth: true });
  const leaks = trackGl(gl);
  const { player, diagnostics } = await stand(program, { gl, modules: RUNTIMES, createScenes, assets: assetsAt(assetUrl) });
  const emulator = installEmulator({ device: 'phone', room: 'studio', clock: 'manual', display: false, sizePx: [64, 48] });
  emulator.setPose({ position: [0, 1.5, 1] });
  const clock = createManualClock();
  const alive: string[] = [];
  let drawn = 0;
  const draw = (next: SessionFrame): void => {
    player.draw(next);
    drawn++;
  };
  for (let i = 0; i < times; i++) {
    const orbit = createOrbitSession({ inputs: SESSION_INPUTS, gl, canvas: gl.canvas as HTMLCanvasElement, clock });
    player.setSession(orbit);
    orbit.start(draw, () => {});
    clock.advance(1 / 60);
    await orbit.end();
    const { output: session } = await requestWebXrSession({
      xr: navigator.xr,
      inputs: SESSION_INPUTS,
      gl,
      needs: program.needs,
      antialias: true,
    });
    if (!session) throw new Error('There is no session.');
    player.setSession(session);
    session.start(draw, () => {});
    await emulator.stepFrame(3);
    // Every third time it is the device that ends it.
    if (i % 3 === 2) await emulator.endSession();
    await session.end();
    player.setSession(null);
    alive.push(JSON.stringify({ gl: leaks.alive(), player: player.counts() }));
  }
  await emulator.uninstall();
  const error = gl.getError();
  const said = diagnostics().filter(({ severity }) => severity === 'error');
  player.dispose();
  return { alive, drawn, error, said, after: leaks.report() };
}

let player: Player;
let leaks: GlLeaks;
const spied: Record<string, number> = {};
const next = frame(0, [view(0, 0, 8, 8)]) as { -readonly [K in keyof SessionFrame]: SessionFrame[K] };

/** Tells the values that reach it, by port. */
const spy: NodeModule = {
  create: (ctx) => {
    const inputs = Object.entries(ctx.inputs as unknown as Record<string, { readonly value: number }>);
    return {
      update: () => {
        for (const [port, { value }] of inputs) spied[port] = value;
      },
      dispose: () => {},
    };
  },
};

/** `watched`: `node.port` of values that are to be told. */
export async function startRun(program: Program, assetUrl: string, watched: readonly string[]) {
  const gl = createGl({ depth: true });
  leaks = trackGl(gl);
  const stage = await stand(withSpy(program, watched), { gl, modules: { ...RUNTIMES, spy }, createScenes, assets: assetsAt(assetUrl) });
  player = stage.player;
  player.setSession({ world: 'image', blend: 'opaque' });
}

/** Frames at 60 a second, from number `from` on. */
export function runFrames(from: number, count: number, framesPerS: number) {
  for (let i = from; i < from + count; i++) {
    next.index = i;
    next.timeS = i / framesPerS;
    next.deltaS = i === 0 ? 0 : 1 / framesPerS;
    player.draw(next);
  }
  return { spied, gl: leaks.alive(), player: player.counts() };
}

/** GL programs that are linked before the first frame and in it, and what the watched values are after it. */
export async function firstFrame(program: Program, assetUrl: string, watched: readonly string[]) {
  const gl = createGl({ depth: true });
  let linked = 0;
  const link = gl.linkProgram.bind(gl);
  gl.linkProgram = (made) => {
    linked++;
    link(made);
  };
  const plays = withSpy(program, watched);
  const stage = await stand(plays, { gl, modules: { ...RUNTIMES, spy }, createScenes, assets: assetsAt(assetUrl) });
  const before = linked;
  stage.player.setSession({ world: 'image', blend: 'opaque' });
  stage.player.draw(frame(0, [view(0, 0, 32, 32)]));
  const during = linked - before;
  const said = stage.diagnostics();
  stage.player.dispose();
  return { before, during, spied, said };
}

function withSpy(program: Program, watched: readonly string[]): Program {
  const inputs: Record<string, NodeOperation['inputs'][string]> = {};
  for (const name of watched) {
    const [node, port = ''] = name.split('.');
    const operation = program.operations.find((op) => op.node === node) as NodeOperation | undefined;
    const output = operation?.outputs[port];
    if (!output) throw new Error(`The program has no ${name}.`);
    inputs[name] = [output];
  }
  const operation: NodeOperation = {
    kind: 'value',
    id: 'spy',
    node: 'spy',
    type: 'spy',
    reads: [],
    writes: [],
    view: 'once',
    inputs,
    multiple: [],
    outputs: {},
    params: {},
    config: {},
    assets: {},
  };
  const first = program.operations.findIndex(({ kind }) => kind === 'pass' || kind === 'draw' || kind === 'shadow-maps');
  const operations = [...program.operations];
  operations.splice(first, 0, operation);
  return { ...program, operations };
}
