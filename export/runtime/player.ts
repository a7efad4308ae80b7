import type { PlayedModule } from '../../nodes/kit/cpu-filter.ts';
import type { ParamValue } from '../../nodes/kit/definition.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { ResetCause, SessionFrame } from '../../nodes/kit/session.ts';
import type { TakenPanorama } from '../../nodes/kit/taken-panorama.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from './assets/asset-source.ts';
import { createBrowserClock, type FrameClock } from './clock.ts';
import type { StartWorker } from './cpu/worker-source.ts';
import { createDiagnosticsBoard } from './diagnostics-board.ts';
import { createEngine, type Engine, type PlayerCounts } from './engine.ts';
import type { OwnedObjects } from './gl/owned-objects.ts';
import type { ShaderError } from './gl/program-cache.ts';
import type { Inspected } from './inspected.ts';
import { type Loading, loadProgram } from './loading.ts';
import { createPlayState } from './play-state.ts';
import type { SessionTraits } from './present/background.ts';
import type { LoopGuard } from './program-instance/loop-watch.ts';
import { disposeNodeInstances } from './program-instance/node-instances.ts';
import { createProgramInstance, type ProgramInstance, type RetainedState } from './program-instance/program-instance.ts';
import type { OperationMonitor } from './program-instance/step.ts';
import type { CreateSceneBackend } from './scene-backend.ts';
import type { CreateSpatial } from './spatial/spatial.ts';

export interface PlayerOptions {
  readonly gl: WebGL2RenderingContext;
  readonly canvas: HTMLCanvasElement | OffscreenCanvas;
  readonly program: Program;
  /** The runtimes of the node types in the program, by type id. */
  readonly modules: Readonly<Record<string, PlayedModule>>;
  /** Creates the scene backend; null for pages whose program neither draws objects nor loads models. */
  readonly createScenes: CreateSceneBackend | null;
  /** Creates hit tests and anchors; null or absent for pages whose program needs neither. */
  readonly createSpatial?: CreateSpatial | null;
  /** The element of the page over the canvas (`SessionService.overlay`). */
  readonly overlay?: HTMLElement | null;
  readonly assets: AssetSource;
  /** Seed of all random numbers: equal seeds give equal frames. */
  readonly seed: number;
  /** Called with all diagnostics of the running program whenever they change. Shader errors come with `PlayResult`. */
  readonly onDiagnostics: (diagnostics: readonly Diagnostic[]) => void;
  readonly clock?: FrameClock;
  /** Whether frames are drawn one by one, however long each takes, as in a render: videos then seek instead of play. */
  readonly held?: boolean;
  /** Starts the workers of nodes, such as CPU filters; by default from blobs. */
  readonly startWorker?: StartWorker;
  /** Follows every operation that draws; absent in pages. */
  readonly monitor?: OperationMonitor;
  /** Follows the GPU objects of nodes that draw themselves and of assets; absent in pages. */
  readonly owned?: OwnedObjects;
  /**
   * Creates what watches bounded loops: `createLoopGuard`, in hosts that compile with a loop budget. If it is absent, bounded loops are not
   * watched.
   */
  readonly createLoopGuard?: (engine: Engine) => LoopGuard;
}

/** The result of loading a program. */
export interface PlayResult {
  /**
   * `playing`: the program is drawn from the next frame on. `kept`: its shaders do not compile, so the last good program stays.
   * `superseded`: a newer program, a lost context or `dispose` came before it was ready.
   */
  readonly outcome: 'playing' | 'kept' | 'superseded';
  /**
   * Errors of shaders that do not compile. With `playing`, errors mean that there was no good program before: passes with broken shaders
   * copy their first input.
   */
  readonly shaderErrors: readonly ShaderError[];
}

/**
 * Plays a program on a WebGL 2 context. The context may be shared: the player assumes nothing about the GL state.
 *
 * @example
 * const player = createPlayer({ gl, canvas, program, modules, createScenes: null, assets, seed: 1, onDiagnostics });
 * await player.ready;
 * player.setSession(session);
 * player.draw(frame);
 */
export interface Player {
  /** Resolves when the first program is set up: assets can be drawn or failed, materials compiled. Nothing is drawn before. */
  readonly ready: Promise<PlayResult>;
  /** Resolves when the assets of the first program have their final form or failed. Pages draw captures before they are complete. */
  readonly complete: Promise<void>;
  /** Sets the session that the next frames are drawn for; null without a session. */
  setSession(session: SessionTraits | null): void;
  /** Sets the panorama that the visitor has taken, from the next frame on; null for none. Its pixels are kept. */
  setPanorama(panorama: TakenPanorama | null): void;
  /** Draws all views of a frame into its framebuffer. */
  draw(frame: SessionFrame): void;
  /**
   * Draws a frame like `draw`, but draws nothing if it would look like the last one. For frames on a canvas that nothing else draws to: it
   * keeps showing what was drawn last.
   *
   * @returns Whether it has drawn.
   */
  drawChanges(frame: SessionFrame): boolean;
  /**
   * For a held player, and sessions whose frames last until the next: waits for everything that the frame shows, such as the seek of
   * a video, then draws. Resolves when the frame is drawn.
   */
  drawSettled(frame: SessionFrame): Promise<void>;
  /** For a held player: resolves when everything that the last frame requested has loaded. The next frame shows it. */
  settle(): Promise<void>;
  /**
   * Sets a uniform param from the next frame on.
   *
   * @param node Id of the node in the program.
   * @param param Name of the param.
   * @param value In the param's stored unit, as the node's definition names it.
   * @returns False if the running program has no such param, or the value does not fit its type.
   */
  setParam(node: string, param: string, value: ParamValue): boolean;
  /**
   * Links a new program while the current one runs, and swaps them between two frames. What both have in common is kept: GL
   * programs, targets, assets, and nodes with their state.
   *
   * @returns Whether the program plays. Never rejects because of a shader error.
   */
  replaceProgram(program: Program): Promise<PlayResult>;
  /**
   * Resets the state of nodes and persistent targets to the first frame.
   *
   * @param cause Default: `restart`. After a `repeat`, nodes keep what the visitor has made in the room.
   */
  reset(cause?: ResetCause): void;
  /**
   * What `readColor`, `readDepth`, `showLayer` and `probeDepth` read. Valid after `draw` until the frame ends.
   *
   * @param tap A viewed layer as `node.port`, or null for none.
   * @returns Null if nothing was drawn.
   */
  inspect(tap: string | null): Inspected | null;
  counts(): PlayerCounts;
  /** Stops drawing. Call it on `webglcontextlost`, and prevent the default of that event. */
  contextLost(): void;
  /**
   * Sets everything up again with the current params and the state of value nodes. Call it on `webglcontextrestored`. Content that
   * existed only on the GPU is lost: persistent targets start empty.
   */
  restore(): Promise<PlayResult>;
  dispose(): void;
}

const SUPERSEDED: PlayResult = { outcome: 'superseded', shaderErrors: [] };

/**
 * Creates a player and loads its first program.
 *
 * @param options The context, the program, the runtimes of its node types and the source of its assets.
 * @returns The player. `ready` resolves when the program can be drawn; `dispose` releases everything that the player created.
 * @throws Error from `draw` or `ready` if `modules` lacks a node type of the program, or `createScenes` is null and it draws objects.
 */
export function createPlayer(options: PlayerOptions): Player {
  const clock = options.clock ?? createBrowserClock();
  const board = createDiagnosticsBoard(options.onDiagnostics);
  const state = createPlayState();
  const spatial = options.createSpatial?.({ gl: options.gl, held: options.held ?? false }) ?? null;
  let engine: Engine;
  let loopGuard: LoopGuard | null;
  const setUp = (): void => {
    engine = createEngine({ ...options, clock, board, state, spatial });
    loopGuard = options.createLoopGuard?.(engine) ?? null;
  };
  setUp();
  let instance: ProgramInstance | null = null;
  let instanceIsGood = false;
  /** What remains of the program instance that was lost with the context. */
  let retained: RetainedState | null = null;
  let loading: Loading | null = null;
  /** True while the first instance compiles its materials; it is not drawn then. */
  let preparing = false;
  let session: SessionTraits | null = null;
  /** False while the context is lost and after `dispose`. */
  let live = true;
  /** The program to set up when the context is restored: the newest whose shaders are not known to be broken. */
  let restorable = options.program;
  /** Values set since the newest program was passed, which may have been compiled before they were set. */
  const values = new Map<string, ParamValue>();

  let isComplete = (): void => {};
  const complete = new Promise<void>((resolve) => {
    isComplete = resolve;
  });
  const setValue = (target: ProgramInstance, name: string, value: ParamValue): boolean => {
    const slot = target.slots.find(name);
    return slot !== undefined && target.slots.set(slot, value);
  };
  const play = async (program: Program): Promise<PlayResult> => {
    loading?.cancel();
    const current = loadProgram(engine, program);
    loading = current;
    const loaded = await current.done;
    if (!loaded || loading !== current) return SUPERSEDED;
    loading = null;
    const good = loaded.errors.length === 0;
    if (!good && instance && instanceIsGood) {
      restorable = instance.program;
      loaded.release();
      return { outcome: 'kept', shaderErrors: loaded.errors };
    }
    const before = instance;
    const isFirst = before === null && retained === null;
    const next = createProgramInstance(engine, loaded, before ?? retained, loopGuard);
    instance = next;
    void loaded.complete.then(isComplete);
    retained = null;
    instanceIsGood = good;
    before?.release(next);
    for (const [name, value] of values) setValue(next, name, value);
    if (isFirst) {
      preparing = true;
      await next.prepare().finally(() => {
        preparing = false;
      });
      if (instance !== next) return SUPERSEDED;
    }
    return { outcome: 'playing', shaderErrors: loaded.errors };
  };
  const tearDown = (contextLost: boolean): void => {
    live = false;
    loading?.cancel();
    loading = null;
    if (contextLost) retained = instance?.outlive() ?? retained;
    else instance?.release(null);
    instance = null;
    instanceIsGood = false;
    loopGuard?.dispose();
    engine.dispose();
  };
  /** Updates the nodes for a frame. Returns null if nothing can be drawn. */
  const enter = (frame: SessionFrame): ProgramInstance | null => {
    if (!live || !instance || preparing) return null;
    state.frame = frame;
    spatial?.enterFrame(frame);
    instance.update();
    return instance;
  };
  const forget = (): void => {
    if (retained) disposeNodeInstances(retained.instances);
    retained = null;
  };
  return {
    ready: play(restorable),
    complete,
    setSession: (next) => {
      if (next !== session) spatial?.leaveSession();
      if (next !== null && next !== session) state.sessions++;
      session = next;
      state.hidesPage = next?.hidesPage === true;
      state.blend = next?.blend ?? 'opaque';
    },
    setPanorama: (panorama) => {
      state.panorama = panorama;
    },
    draw: (frame) => enter(frame)?.draw(session),
    drawChanges: (frame) => enter(frame)?.drawChanges(session) ?? false,
    drawSettled: async (frame) => {
      const current = enter(frame);
      if (current === null) return;
      await Promise.all([current.settle(), spatial?.settle()]);
      // Meanwhile the context may be lost, or another program may play.
      if (live && instance === current) current.draw(session);
    },
    settle: async () => {
      await Promise.all([instance?.settle(), spatial?.settle()]);
    },
    setParam: (node, param, value) => {
      const name = `${node}.${param}`;
      values.set(name, value);
      instance?.loops?.retry();
      return instance !== null && setValue(instance, name, value);
    },
    replaceProgram: (program) => {
      restorable = program;
      values.clear();
      return live ? play(program) : Promise.resolve(SUPERSEDED);
    },
    reset: (cause = 'restart') => {
      forget();
      instance?.reset(cause);
    },
    inspect: (tap) => {
      if (!live || !instance) return null;
      const { program, slots, resources } = instance;
      return { engine, program, slots, resources, layer: (tap === null ? undefined : program.taps[tap]) ?? null };
    },
    counts: () => engine.counts(),
    contextLost: () => {
      if (!live) return;
      spatial?.contextLost();
      tearDown(true);
    },
    restore: () => {
      setUp();
      live = true;
      return play(restorable);
    },
    dispose: () => {
      if (live) tearDown(false);
      forget();
      spatial?.dispose();
    },
  };
}
