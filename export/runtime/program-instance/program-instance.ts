import type { NodeRuntime } from '../../../nodes/kit/runtime.ts';
import type { ResetCause } from '../../../nodes/kit/session.ts';
import type { Operation, PassOperation, Program } from '../../program/program.ts';
import { createCpuStep, isCpu } from '../cpu/cpu-step.ts';
import type { Engine } from '../engine.ts';
import type { LoadedProgram } from '../loading.ts';
import { isDraw } from '../operations/node-key.ts';
import { type ChangeWatch, createChangeWatch } from '../passes/change-watch.ts';
import { type DirectDraw, findDirectDraws } from '../passes/direct-draw.ts';
import { createImports, type Imports } from '../passes/imports.ts';
import { createPass, type Pass, type PassParts } from '../passes/pass.ts';
import { createReadbackStep, isReadback } from '../pixels/pixels-step.ts';
import { enterView } from '../play-state.ts';
import { createBackground, type SessionTraits } from '../present/background.ts';
import { createResources, disposeUnused, type LiveResources, pointResources } from '../resources/resources.ts';
import { createTargetSizes } from '../targets/target-sizes.ts';
import { createSlots, type Slots } from '../values/slots.ts';
import { createDrawStep } from './draw-step.ts';
import type { LoopGuard, LoopWatch } from './loop-watch.ts';
import { reportMissingFloats } from './missing-floats.ts';
import { createNodeInstances, disposeNodeInstances, isShadowMaps, makesValues, type NodeInstances } from './node-instances.ts';
import { prepareMaterials } from './prepare-materials.ts';
import { createRestWatch } from './rest-watch.ts';
import type { Step } from './step.ts';
import { monitored } from './step.ts';

/** What a program instance passes to the instance that replaces it. */
export interface RetainedState {
  readonly resources: LiveResources;
  readonly instances: NodeInstances;
  /** The watch of the program's loops; null if no loops are bounded, as in exported pages. */
  readonly loops: LoopWatch | null;
}

/** A program set up on the GPU and ready to be drawn. */
export interface ProgramInstance extends RetainedState {
  readonly program: Program;
  readonly slots: Slots;
  /** Updates all nodes for the frame of the engine's play state. */
  update(): void;
  /** Resolves when everything that the nodes requested in `update` has loaded. */
  settle(): Promise<void>;
  /** Draws all views of the frame for which `update` was called. */
  draw(session: SessionTraits | null): void;
  /** Draws it like `draw`, but draws nothing if the screen shows it already. Returns whether it has drawn. */
  drawChanges(session: SessionTraits | null): boolean;
  /** Resets the state of nodes and persistent targets to the first frame. */
  reset(cause: ResetCause): void;
  /** Disposes GL programs, assets and targets that `next` did not take over. */
  release(next: ProgramInstance | null): void;
  /**
   * Compiles the materials of an empty world without drawing them, so that the first frame does not block on the driver. Value nodes
   * are not updated: their first frame is still to come.
   */
  prepare(): Promise<void>;
  /** Disposes this instance after a lost context. Returns what needs no GPU: the value nodes with their state. */
  outlive(): RetainedState;
}

/**
 * Sets a loaded program up. Nodes and resources of `before` that are unchanged are kept; its other nodes are disposed. The caller
 * calls `before.release` afterwards.
 */
export function createProgramInstance(
  engine: Engine,
  loaded: LoadedProgram,
  before: RetainedState | null,
  guard: LoopGuard | null,
): ProgramInstance {
  const { program } = loaded;
  const { state } = engine;
  const slots = createSlots(program.slots);
  const resources = createResources(program, engine, before?.resources ?? null);
  pointResources(program, resources, engine, slots);
  reportMissingFloats(program, engine);
  const instances = createNodeInstances(engine, program, slots, resources, before?.instances ?? null);
  const runtimes: readonly NodeRuntime[] = [...instances.nodes.values()].map((node) => node.runtime);
  const delays = runtimes.filter((runtime) => runtime.remember !== undefined);
  const pulses = [...resources.values()].flatMap((resource) => (resource.kind === 'pulses' ? [resource.queue] : []));
  const loops = guard?.watch(loaded, before?.loops ?? null) ?? null;
  const imports = createImports(engine, program);
  const sizes = createTargetSizes(program, resources, slots, engine.objects.limits.maxTextureSizePx);
  // Bounded loops change what their passes draw without a change of what they read.
  const watch = loops === null ? createChangeWatch(program, { resources, slots, imports }) : null;
  const rest = loops === null ? createRestWatch(program, { resources, slots, nodes: instances.nodes }) : null;
  const direct = loops === null ? findDirectDraws(program, resources) : new Map<PassOperation, DirectDraw>();
  const directDraws = [...new Set(direct.values())];
  const once = createSteps(engine, loaded, slots, imports, instances, { loops, watch, direct }, 'once');
  const each = createSteps(engine, loaded, slots, imports, instances, { loops, watch, direct }, 'each');
  const background = createBackground(engine.objects.gl, engine.drawer, engine.copy, program.presentation.background);
  let viewCount = 0;

  const run = (steps: readonly Step[]): void => {
    for (let i = 0; i < steps.length; i++) steps[i]?.run(state);
  };
  const draw = (session: SessionTraits | null, onlyChanges: boolean): boolean => {
    const { frame } = state;
    if (frame.viewCount !== viewCount) sizes.trim(frame.viewCount);
    viewCount = frame.viewCount;
    enterView(state, 0);
    loops?.poll();
    sizes.resizeImages(state);
    for (let i = 0; i < directDraws.length; i++) if (directDraws[i]?.decide(state)) watch?.forget();
    const changed = watch?.look(state, session) ?? true;
    const needed = rest?.look(state, session) ?? changed;
    if (onlyChanges && !needed) return false;
    run(once);
    for (let i = 0; i < frame.viewCount; i++) {
      enterView(state, i);
      // Emulators give a monoscopic device a second view of zero width.
      if (state.widthPx < 1 || state.heightPx < 1) continue;
      sizes.resizeViews(state);
      background.draw(state, session);
      run(each);
    }
    return true;
  };
  return {
    program,
    slots,
    resources,
    instances,
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
    draw: (session) => void draw(session, false),
    drawChanges: (session) => draw(session, true),
    reset: (cause) => {
      for (const node of instances.nodes.values()) node.reset(cause);
      loops?.retry();
      watch?.forget();
      rest?.forget();
      for (const resource of resources.values()) {
        if (resource.kind === 'target' && resource.target.resource.lifetime === 'persistent') resource.target.clear();
        if (resource.kind === 'pixels') resource.pixels.forget();
      }
    },
    prepare: () => prepareMaterials(engine, program, instances, [...once, ...each]),
    release: (next) => {
      if (!next) disposeNodeInstances(instances);
      loops?.release(next?.loops ?? null);
      disposeUnused(resources, next?.resources ?? null);
      imports.release();
      loaded.release();
    },
    outlive: () => {
      const nodes = new Map([...instances.nodes].filter(([id, { usesGpu }]) => !usesGpu && makesValues(program, id)));
      const left: NodeInstances = {
        resources: new Map([...resources].filter(([, { kind }]) => kind !== 'target' && kind !== 'pixels')),
        nodes,
        shadowMaps: new Map(),
      };
      disposeNodeInstances(instances, left);
      loops?.release(null);
      disposeUnused(resources, null);
      imports.release();
      loaded.release();
      return { resources: left.resources, instances: left, loops: null };
    },
  };
}

/** Draws a pass only in frames that change its image. */
function ifNeeded(step: Step, pass: PassOperation, watch: ChangeWatch): Step {
  return {
    run: (state) => {
      if (watch.takeNeeded(pass)) step.run(state);
    },
  };
}

/** Runs `onScreen` instead of a step while the image is drawn to the screen directly; null for nothing. */
function unlessDirect(step: Step, direct: DirectDraw, onScreen: Step | null): Step {
  return {
    run: (state) => {
      if (direct.active) onScreen?.run(state);
      else step.run(state);
    },
  };
}

/** What decides per frame how passes are drawn. */
interface Overseers {
  readonly loops: LoopWatch | null;
  readonly watch: ChangeWatch | null;
  readonly direct: ReadonlyMap<PassOperation, DirectDraw>;
}

/** A pass that is left out for a view of the size of an earlier one. */
function unlessKnown({ run }: Pass): Pass {
  return { run: (state) => (state.sizeIsKnown ? undefined : run(state)) };
}

/** Creates the steps of all operations that draw, in order. Other nodes have no step; their work is done in `update`. */
function createSteps(
  engine: Engine,
  loaded: LoadedProgram,
  slots: Slots,
  imports: Imports,
  instances: NodeInstances,
  { loops, watch, direct }: Overseers,
  view: 'once' | 'each',
): Step[] {
  const { resources } = instances;
  const { objects, drawer, clock, copy } = engine;
  const parts: PassParts = { gl: objects.gl, drawer, clock, resources, slots, imports, copy };
  const steps: Step[] = [];
  const add = (operation: Operation, step: Step) => void steps.push(monitored(step, operation, engine.monitor));
  for (const operation of loaded.program.operations) {
    if (operation.view !== view) continue;
    if (operation.kind === 'pass') {
      const glProgram = loaded.glPrograms[operation.shader];
      if (!glProgram) throw new Error(`The program has no shader ${operation.shader}.`);
      const drawn = createPass(operation, glProgram, parts, loops?.guardOf(operation) ?? null);
      // A bounded pass may be drawn or not, view by view.
      const pass = operation.sameForViews && loops === null ? unlessKnown(drawn) : drawn;
      const needed = view === 'once' && watch ? ifNeeded(pass, operation, watch) : pass;
      const directDraw = direct.get(operation);
      if (directDraw === undefined) add(operation, needed);
      else if (view === 'once') add(operation, unlessDirect(needed, directDraw, null));
      else {
        const shownProgram = loaded.glPrograms[directDraw.onScreen.shader];
        if (!shownProgram) throw new Error(`The program has no shader ${directDraw.onScreen.shader}.`);
        add(operation, unlessDirect(needed, directDraw, createPass(directDraw.onScreen, shownProgram, parts, null)));
      }
    } else if (isShadowMaps(operation)) {
      const maps = instances.shadowMaps.get(operation.id)?.maps;
      const render = (): void => maps?.update();
      add(operation, { run: render, prepare: render });
    } else if (isReadback(operation)) {
      add(operation, createReadbackStep(operation, resources, engine.host.clock));
    } else if (isDraw(operation)) {
      const instance = instances.nodes.get(operation.id);
      if (instance) add(operation, createDrawStep(engine, loaded.program, operation, instance, resources));
    } else if (isCpu(operation)) {
      const instance = instances.nodes.get(operation.id);
      if (instance) add(operation, createCpuStep(operation, instance.runtime, resources));
    }
  }
  return steps;
}
