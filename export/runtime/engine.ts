import type { PlayedModule } from '../../nodes/kit/cpu-filter.ts';
import type { LinkedShader } from '../program/program.ts';
import type { AssetSource } from './assets/asset-source.ts';
import { type AssetStore, createAssetStore } from './assets/asset-store.ts';
import type { FrameClock } from './clock.ts';
import { type StartWorker, startBlobWorker } from './cpu/worker-source.ts';
import type { DiagnosticsBoard } from './diagnostics-board.ts';
import { COPY_SHADER } from './gl/copy-shader.ts';
import { createGlObjects, type GlCounts, type GlObjects } from './gl/gl-objects.ts';
import { createImageStore, type ImageStore } from './gl/image-store.ts';
import type { OwnedObjects } from './gl/owned-objects.ts';
import { createPassDrawer, type PassDrawer } from './gl/pass-drawer.ts';
import { createProgramCache, type GlProgram, type ProgramCache } from './gl/program-cache.ts';
import { type CameraMean, createCameraMean } from './light/camera-mean.ts';
import type { NodeHost } from './operations/node-instance.ts';
import type { PlayState } from './play-state.ts';
import type { OperationMonitor } from './program-instance/step.ts';
import type { CreateSceneBackend, SceneBackend } from './scene-backend.ts';
import type { Spatial, SpatialCounts } from './spatial/spatial.ts';
import { createMultisampling, type Multisampling } from './targets/multisampling.ts';
import type { NearestDepth } from './targets/nearest-depth.ts';

/** Everything that exists once per WebGL context, independent of the program. */
export interface Engine {
  readonly objects: GlObjects;
  readonly programs: ProgramCache;
  readonly drawer: PassDrawer;
  /** The program that copies an image. It is linked together with the shaders of the first program. */
  readonly copy: GlProgram;
  /** A program of the runtime itself, linked at the first request and kept. */
  tool(shader: LinkedShader): GlProgram;
  /** Created at the first call. */
  readonly multisampling: Multisampling;
  readonly assets: AssetStore;
  readonly images: ImageStore;
  readonly clock: FrameClock;
  readonly state: PlayState;
  readonly monitor: OperationMonitor | null;
  readonly host: NodeHost;
  /** The scene backend; null until a node has drawn objects or loaded a model. */
  scenesIfMade(): SceneBackend | null;
  counts(): PlayerCounts;
  dispose(): void;
}

/** Number of GPU objects: the player's own by kind, and those of three.js. */
export interface PlayerCounts extends GlCounts {
  readonly scenes: ReturnType<SceneBackend['counts']> | null;
  /** Number of open hit tests and anchors; absent in pages without them. */
  readonly spatial?: SpatialCounts;
}

export interface EngineOptions {
  readonly gl: WebGL2RenderingContext;
  readonly canvas: HTMLCanvasElement | OffscreenCanvas;
  readonly modules: Readonly<Record<string, PlayedModule>>;
  readonly createScenes: CreateSceneBackend | null;
  /** Hit tests and anchors; null if the program needs neither. */
  readonly spatial: Spatial | null;
  readonly overlay?: HTMLElement | null;
  readonly assets: AssetSource;
  readonly seed: number;
  readonly clock: FrameClock;
  readonly board: DiagnosticsBoard;
  readonly state: PlayState;
  readonly held?: boolean;
  readonly startWorker?: StartWorker;
  readonly monitor?: OperationMonitor;
  readonly owned?: OwnedObjects;
}

export function createEngine(options: EngineOptions): Engine {
  const { gl, canvas, state, clock } = options;
  const objects = createGlObjects(gl);
  const programs = createProgramCache(objects);
  const drawer = createPassDrawer(objects);
  const copy = programs.acquire(COPY_SHADER);
  let backend: SceneBackend | null = null;
  const scenes = (): SceneBackend => {
    if (!options.createScenes) throw new Error('The program draws objects, but the page was made without three.js.');
    backend ??= options.createScenes({ gl, canvas, delay: options.held ? null : clock.delay });
    return backend;
  };
  const spatial = (): Spatial => {
    if (!options.spatial) throw new Error('A node tests hits or anchors, and its definition needs neither `hit-test` nor `anchors`.');
    return options.spatial;
  };
  const tools = new Map<string, GlProgram>();
  let cameraMean: CameraMean | null = null;
  let nearestDepth: NearestDepth | null = null;
  let multisampling: Multisampling | null = null;
  const assets = createAssetStore({ objects, source: options.assets, scenes, delay: clock.delay, owned: options.owned ?? null });
  const tool = (shader: LinkedShader): GlProgram => {
    const made = tools.get(shader.id) ?? programs.acquire(shader);
    tools.set(shader.id, made);
    programs.finish(made);
    return made;
  };
  return {
    objects,
    programs,
    drawer,
    copy,
    tool,
    get multisampling() {
      multisampling ??= createMultisampling(objects, {
        createResolve: (...buffer) => {
          nearestDepth ??= scenes().createNearestDepth(objects, drawer, tool);
          return nearestDepth.createResolve(...buffer);
        },
      });
      return multisampling;
    },
    assets,
    images: createImageStore(objects),
    clock,
    state,
    monitor: options.monitor ?? null,
    host: {
      gl,
      modules: options.modules,
      seed: options.seed,
      clock: {
        get timeS() {
          return state.frame.timeS;
        },
        get deltaS() {
          return state.frame.deltaS;
        },
        get frame() {
          return state.frame.index;
        },
        held: options.held ?? false,
      },
      session: {
        get frame() {
          return state.frame;
        },
        get light() {
          return state.frame.light;
        },
        get overlay() {
          return options.held || state.hidesPage ? null : (options.overlay ?? null);
        },
        get sessions() {
          return state.sessions;
        },
        get blend() {
          return state.blend;
        },
        get panorama() {
          return state.panorama;
        },
        get cameraMean() {
          cameraMean ??= createCameraMean({ objects, drawer, tool }, options.held ?? false);
          return cameraMean.read(state.frame);
        },
        openHitTest: (hitTest) => spatial().openHitTest(hitTest),
        castRay: (worldFromRay, out, sources) => spatial().castRay(worldFromRay, out, sources),
        answerRays: (by) => spatial().answerRays(by),
        depthImage: (viewIndex) => spatial().depthImage(viewIndex),
        get anchors() {
          return spatial().anchors;
        },
        get keptFiles() {
          return spatial().keptFiles;
        },
      },
      assets,
      board: options.board,
      owned: options.owned ?? null,
      cpu: { objects, drawer, copy, clock, startWorker: options.startWorker ?? startBlobWorker },
      startWorker: options.startWorker ?? startBlobWorker,
      scenes,
    },
    scenesIfMade: () => backend,
    counts: () => ({
      ...objects.counts(),
      scenes: backend?.counts() ?? null,
      ...(options.spatial ? { spatial: options.spatial.counts() } : {}),
    }),
    dispose: () => {
      assets.dispose();
      backend?.dispose();
      cameraMean?.dispose();
      drawer.dispose();
      programs.dispose();
    },
  };
}
