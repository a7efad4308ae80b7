import type { NodeRuntime } from '../../../nodes/kit/runtime.ts';
import type { SessionFrame } from '../../../nodes/kit/session.ts';
import type { Operation, Program } from '../../program/program.ts';
import { createCpuStep, isCpu } from '../cpu/cpu-step.ts';
import type { Engine } from '../engine.ts';
import type { LoadedProgram } from '../loading.ts';
import { isDraw } from '../operations/node-key.ts';
import { createImports, type Imports } from '../passes/imports.ts';
import { createPass, type PassParts } from '../passes/pass.ts';
import { EMPTY_FRAME, enterView } from '../play-state.ts';
import { createBackground, type SessionTraits } from '../present/background.ts';
import { createResources, disposeUnused, type LiveResources, pointResources } from '../resources/resources.ts';
import { createSessionFrame } from '../sessions/session-frame.ts';
import { createTargetSizes } from '../targets/target-sizes.ts';
import { createSlots, type Slots } from '../values/slots.ts';
import { type Cast, createCast, isShadowMaps, releaseCast } from './cast.ts';
import { createDrawStep } from './draw-step.ts';
import { createLoopWatch, type LoopWatch } from './loop-watch.ts';
import { metered } from './meter.ts';
import type { Step } from './step.ts';

/** What one stage hands to the next. */
export interface Heritage {
  readonly resources: LiveResources;
  readonly cast: Cast;
  /** Null where no loops are bounded, as in exported pages. */
  readonly loops: LoopWatch | null;
}

/** A program set up on the GPU and ready to be drawn. */
export interface Stage extends Heritage {
  readonly program: Program;
  readonly slots: Slots;
  /** Lets the nodes work out the frame of the engine's play state. */
  update(): void;
  /** Resolves when what the nodes asked for in `update` is there. */
  settle(): Promise<void>;
  /** Draws that frame, all views. */
  draw(session: SessionTraits | null): void;
  /** State of nodes and persistent pictures back to the first frame. */
  reset(): void;
  /** Frees GL programs, assets and targets that the stage after this one did not take over. */
  release(next: Stage | null): void;
  /**
   * Before the first frame: has what the scenes of an empty world need compiled, without drawing them. Else the first frame would
   * stand still for it. Values are not worked out for it: their first frame is still to come.
   */
  prepare(): Promise<void>;
  /** The context is lost, and this stage with it; what is left are the values, and the nodes that make them, with their state. */
  outlive(): Heritage;
}

/** Takes over from `before` what is the same, and disposes the nodes of it that are not; call `before.release` afterwards. */
export function createStage(engine: Engine, loaded: LoadedProgram, before: Heritage | null): Stage {
  const { program } = loaded;
  const { state } = engine;
  const slots = createSlots(program.slots);
  const resources = createResources(program, engine.objects, before?.resources ?? null);
  pointResources(program, resources, engine, slots);
  const cast = createCast(engine, program, slots, resources, before?.cast ?? null);
  const runtimes: readonly NodeRuntime[] = [...cast.nodes.values()].map((node) => node.runtime);
  const delays = runtimes.filter((runtime) => runtime.remember !== undefined);
  const pulses = [...resources.values()].flatMap((resource) => (resource.kind === 'pulses' ? [resource.queue] : []));
  const loops = createLoopWatch(engine, loaded, before?.loops ?? null);
  const imports = createImports(engine, program);
  const once = createSteps(engine, loaded, slots, imports, cast, loops, 'once');
  const each = createSteps(engine, loaded, slots, imports, cast, loops, 'each');
  const sizes = createTargetSizes(program, resources, slots, engine.objects.limits.maxTextureSizePx);
  const background = createBackground(engine.objects.gl, engine.drawer, engine.copy, program.presentation.background);
  let viewCount = 0;

  const run = (steps: readonly Step[]): void => {
    for (let i = 0; i < steps.length; i++) steps[i]?.run(state);
  };
  return {
    program,
    slots,
    resources,
    cast,
    loops,
    update: () => {
      const { frame } = state;
      enterView(state, 0);
      for (let i = 0; i < pulses.length; i++) pulses[i]?.clear();
      for (let i = 0; i < runtimes.length; i++) runtimes[i]?.update(frame);
      for (let i = 0; i < delays.length; i++) delays[i]?.remember?.();
    },
    settle: async () => {
      await Promise.all(runtimes.map((runtime) => runtime.settle?.()));
    },
    draw: (session) => {
      const { frame } = state;
      if (frame.viewCount !== viewCount) sizes.trim(frame.viewCount);
      viewCount = frame.viewCount;
      enterView(state, 0);
      loops?.poll();
      sizes.resizeImages(state);
      run(once);
      for (let i = 0; i < frame.viewCount; i++) {
        enterView(state, i);
        // The emulator gives a monoscopic device a second view of no width.
        if (state.widthPx < 1 || state.heightPx < 1) continue;
        sizes.resizeViews(state);
        background.draw(state, session);
        run(each);
      }
    },
    reset: () => {
      for (const node of cast.nodes.values()) node.reset();
      loops?.retry();
      for (const resource of resources.values()) {
        if (resource.kind === 'target' && resource.target.resource.lifetime === 'persistent') resource.target.clear();
      }
    },
    prepare: async () => {
      const backend = engine.scenesIfMade();
      if (!backend) return;
      state.frame = createEmptyWorld();
      enterView(state, 0);
      for (const [id, { runtime }] of cast.nodes) if (!makesValues(program, id)) runtime.update(state.frame);
      const compiled = backend.prepare(() => {
        for (const step of [...once, ...each]) step.prepare?.(state);
      });
      state.frame = EMPTY_FRAME;
      await compiled;
    },
    release: (next) => {
      if (!next) releaseCast(cast);
      loops?.release(next?.loops ?? null);
      disposeUnused(resources, next?.resources ?? null);
      imports.release();
      loaded.release();
    },
    outlive: () => {
      const nodes = new Map([...cast.nodes].filter(([id, { usesGpu }]) => !usesGpu && makesValues(program, id)));
      const left: Cast = { resources: new Map([...resources].filter(([, { kind }]) => kind !== 'target')), nodes, shadowMaps: new Map() };
      releaseCast(cast, left);
      loops?.release(null);
      disposeUnused(resources, null);
      imports.release();
      loaded.release();
      return { resources: left.resources, cast: left, loops: null };
    },
  };
}

const PREPARED_SIDE_PX = 64;

/** One view, and nothing to be seen. */
function createEmptyWorld(): SessionFrame {
  const frame = createSessionFrame();
  const [view] = frame.views;
  frame.viewCount = 1;
  if (view) {
    view.viewport.widthPx = PREPARED_SIDE_PX;
    view.viewport.heightPx = PREPARED_SIDE_PX;
  }
  return frame;
}

/** Others hold what three.js has put on the GPU, if only in the objects that they pass on. */
function makesValues({ operations }: Program, id: string): boolean {
  return operations.some((operation) => operation.id === id && (operation.kind === 'value' || operation.kind === 'behaviour'));
}

/** What draws, in order; nodes that draw nothing have done their work in `update`. */
function createSteps(
  engine: Engine,
  loaded: LoadedProgram,
  slots: Slots,
  imports: Imports,
  cast: Cast,
  loops: LoopWatch | null,
  view: 'once' | 'each',
): Step[] {
  const { resources } = cast;
  const { objects, drawer, clock, copy } = engine;
  const parts: PassParts = { gl: objects.gl, drawer, clock, resources, slots, imports, copy };
  const steps: Step[] = [];
  const add = (operation: Operation, step: Step) => void steps.push(metered(step, operation, engine.meter));
  for (const operation of loaded.program.operations) {
    if (operation.view !== view) continue;
    if (operation.kind === 'pass') {
      const glProgram = loaded.glPrograms[operation.shader];
      if (!glProgram) throw new Error(`The program has no shader ${operation.shader}.`);
      add(operation, createPass(operation, glProgram, parts, loops?.guardOf(operation) ?? null));
    } else if (isShadowMaps(operation)) {
      const maps = cast.shadowMaps.get(operation.id)?.maps;
      const render = (): void => {
        engine.scenesIfMade()?.invalidateState();
        maps?.update();
      };
      add(operation, { run: render, prepare: render });
    } else if (isDraw(operation)) {
      const instance = cast.nodes.get(operation.id);
      if (instance) add(operation, createDrawStep(engine, operation, instance, resources));
    } else if (isCpu(operation)) {
      const instance = cast.nodes.get(operation.id);
      if (instance) add(operation, createCpuStep(operation, instance.runtime, resources));
    }
  }
  return steps;
}
