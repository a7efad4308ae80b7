import type { PlayedModule } from '../../nodes/kit/cpu-filter.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { Program } from '../program/program.ts';
import type { AssetSource } from './assets/asset-source.ts';
import { createBrowserClock, type FrameClock } from './clock.ts';
import type { StartWorker } from './cpu/worker-source.ts';
import { createDiagnosticsBoard } from './diagnostics-board.ts';
import { createEngine, type Engine, type PlayerCounts } from './engine.ts';
import type { ShaderError } from './gl/program-cache.ts';
import type { Inspected } from './inspected.ts';
import { type Loading, loadProgram } from './loading.ts';
import { createPlayState } from './play-state.ts';
import type { SessionTraits } from './present/background.ts';
import type { CreateSceneBackend } from './scene-backend.ts';
import { releaseCast } from './stage/cast.ts';
import type { Meter } from './stage/meter.ts';
import { createStage, type Heritage, type Stage } from './stage/stage.ts';
import type { SlotValue } from './values/slots.ts';

export interface PlayerOptions {
  readonly gl: WebGL2RenderingContext;
  readonly canvas: HTMLCanvasElement | OffscreenCanvas;
  readonly program: Program;
  /** Runtimes of the node types that the program names. */
  readonly modules: Readonly<Record<string, PlayedModule>>;
  /** Null for pages whose program neither draws objects nor loads models. */
  readonly createScenes: CreateSceneBackend | null;
  readonly assets: AssetSource;
  /** Equal seeds give equal pictures. */
  readonly seed: number;
  /** Everything wrong with the running program, whenever that changes. Shader errors come with `PlayResult`. */
  readonly onDiagnostics: (diagnostics: readonly Diagnostic[]) => void;
  readonly clock?: FrameClock;
  /** Frames come one by one, however long each takes, as in a render: videos are sought instead of played. */
  readonly held?: boolean;
  /** Of CPU filters; from blobs unless given. */
  readonly startWorker?: StartWorker;
  /** Told of every operation that draws. */
  readonly meter?: Meter;
}

/** How a program was received. */
export interface PlayResult {
  /**
   * `playing`: it is the one drawn from the next frame on. `kept`: it is broken, and the last good one runs on. `superseded`:
   * another one, a lost context or the end of the player came before it was ready.
   */
  readonly outcome: 'playing' | 'kept' | 'superseded';
  /** `playing` with errors: no good one was there before; passes with broken shaders hand their first picture on. */
  readonly shaderErrors: readonly ShaderError[];
}

/** Plays a program on a WebGL 2 context that it may share with others: it assumes nothing about the GL state. */
export interface Player {
  /** Settles when the first program is set up, its assets loaded or failed, its materials compiled. Nothing is drawn before. */
  readonly ready: Promise<PlayResult>;
  /** What the frames to come are drawn for; null before there is a session. */
  setSession(session: SessionTraits | null): void;
  /** Draws all views of a frame into its framebuffer. */
  draw(frame: SessionFrame): void;
  /**
   * For a held player, and sessions whose frames last until the next: draws when everything that the frame shows is there, such as
   * its moment of a video. Resolves when it is drawn.
   */
  drawSettled(frame: SessionFrame): Promise<void>;
  /** For a held player: resolves when everything is there that the last frame asked for. The next one shows it. */
  settle(): Promise<void>;
  /** False where the running program has no such param or the value does not fit it. */
  setParam(node: string, param: string, value: SlotValue): boolean;
  /**
   * Links the new program beside the running one and swaps between two frames. What is the same in both is kept: GL programs,
   * targets, assets, and nodes with their state.
   */
  replaceProgram(program: Program): Promise<PlayResult>;
  /** State of nodes and pictures back to the first frame. */
  reset(): void;
  /**
   * Within a frame, after `draw`, and no longer: what `readColor`, `readDepth`, `showLayer` and `probeDepth` look at, with a tapped
   * layer (`node.port`) or without. Null where nothing was drawn.
   */
  inspect(tap: string | null): Inspected | null;
  counts(): PlayerCounts;
  /** Stops drawing; to be called on `webglcontextlost`, whose default the caller prevents. */
  contextLost(): void;
  /**
   * Sets everything up anew, with the params and the state of values as they were; to be called on `webglcontextrestored`. What
   * only the GPU knew is lost: persistent pictures begin anew.
   */
  restore(): Promise<PlayResult>;
  dispose(): void;
}

export function createPlayer(options: PlayerOptions): Player {
  const clock = options.clock ?? createBrowserClock();
  const board = createDiagnosticsBoard(options.onDiagnostics);
  const state = createPlayState();
  const setUp = (): Engine => createEngine({ ...options, clock, board, state });
  let engine = setUp();
  let stage: Stage | null = null;
  let stageIsGood = false;
  /** Of the stage that was lost with the context. */
  let left: Heritage | null = null;
  let loading: Loading | null = null;
  /** The first stage is not to be drawn yet. */
  let preparing = false;
  let session: SessionTraits | null = null;
  /** Neither lost nor disposed. */
  let live = true;
  /** What to set up again when the context comes back: the newest program that is not known to be broken. */
  let wanted = options.program;
  /** Values set since the newest program came, which may have been made before them. */
  const values = new Map<string, SlotValue>();

  const setValue = (target: Stage, name: string, value: SlotValue): boolean => {
    const slot = target.slots.find(name);
    return slot !== undefined && target.slots.set(slot, value);
  };
  const play = async (program: Program): Promise<PlayResult> => {
    loading?.cancel();
    const mine = loadProgram(engine, program);
    loading = mine;
    const loaded = await mine.done;
    if (!loaded || loading !== mine) return { outcome: 'superseded', shaderErrors: [] };
    loading = null;
    const good = loaded.errors.length === 0;
    if (!good && stage && stageIsGood) {
      wanted = stage.program;
      loaded.release();
      return { outcome: 'kept', shaderErrors: loaded.errors };
    }
    const before = stage;
    const isFirst = before === null && left === null;
    const next = createStage(engine, loaded, before ?? left);
    stage = next;
    left = null;
    stageIsGood = good;
    before?.release(next);
    for (const [name, value] of values) setValue(next, name, value);
    if (isFirst) {
      preparing = true;
      await next.prepare().finally(() => {
        preparing = false;
      });
      if (stage !== next) return { outcome: 'superseded', shaderErrors: [] };
    }
    return { outcome: 'playing', shaderErrors: loaded.errors };
  };
  const tearDown = (contextLost: boolean): void => {
    live = false;
    loading?.cancel();
    loading = null;
    if (contextLost) left = stage?.outlive() ?? left;
    else stage?.release(null);
    stage = null;
    stageIsGood = false;
    engine.dispose();
  };
  const forget = (): void => {
    if (left) releaseCast(left.cast);
    left = null;
  };
  return {
    ready: play(wanted),
    setSession: (next) => {
      session = next;
    },
    draw: (frame) => {
      if (!live || !stage || preparing) return;
      state.frame = frame;
      stage.update();
      stage.draw(session);
    },
    drawSettled: async (frame) => {
      if (!live || !stage || preparing) return;
      const mine = stage;
      state.frame = frame;
      mine.update();
      await mine.settle();
      // The context may be lost by now, or another program be playing.
      if (live && stage === mine) mine.draw(session);
    },
    settle: async () => {
      await stage?.settle();
    },
    setParam: (node, param, value) => {
      const name = `${node}.${param}`;
      values.set(name, value);
      stage?.loops?.retry();
      return stage !== null && setValue(stage, name, value);
    },
    replaceProgram: (program) => {
      wanted = program;
      values.clear();
      return live ? play(program) : Promise.resolve({ outcome: 'superseded', shaderErrors: [] });
    },
    reset: () => {
      forget();
      stage?.reset();
    },
    inspect: (tap) => {
      if (!live || !stage) return null;
      const { program, slots, resources } = stage;
      return { engine, program, slots, resources, layer: (tap === null ? undefined : program.taps[tap]) ?? null };
    },
    counts: () => engine.counts(),
    contextLost: () => {
      if (live) tearDown(true);
    },
    restore: () => {
      engine = setUp();
      live = true;
      return play(wanted);
    },
    dispose: () => {
      if (live) tearDown(false);
      forget();
    },
  };
}
