import type { AnchorService } from './anchors.ts';
import type { AssetService } from './assets.ts';
import type { CapturedPlace } from './captured-place.ts';
import type { InputPort, LayerEncoding, NodeDefinition, OutputPort, ParamDefinition } from './definition.ts';
import type { Diagnostic } from './diagnostics.ts';
import type { OcclusionView } from './early-occlusion.ts';
import type { HitRecord, HitSource, HitTest, HitTestOptions, MeasuredRoom } from './hit-test.ts';
import type { KeptFiles } from './kept-files.ts';
import type { PixelsView } from './layer-pixels.ts';
import type { BodyList } from './physics.ts';
import type { PoseOutput, PoseView } from './pose.ts';
import type { EnvironmentOutput, LightList, ObjectList, RoomDepthOutput } from './scene-lists.ts';
import type { SceneLook } from './scene-look.ts';
import type { DepthImage, LightEstimate, Session, SessionFrame, ViewFrame } from './session.ts';
import type { SoundOutput } from './sound.ts';
import type { TakenPanorama } from './taken-panorama.ts';
import type { TechniqueView } from './technique-view.ts';
import type { NumberView, ValueViews, Writable } from './value-views.ts';
import type { WireType } from './wire-types.ts';

/** The number of pulses that an output can emit in one frame. It is fixed so that a frame allocates nothing. */
export const PULSE_CAPACITY = 16;

/**
 * The module of a node's `runtime.ts`, as the player loads it.
 *
 * @example
 * export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
 *   return { update: () => { ctx.outputs.result.value = ctx.params.a.value + ctx.params.b.value; }, dispose: () => {} };
 * }
 */
export interface NodeModule {
  /** Called once when the program starts, and again after a recompile that changes the node. */
  create(ctx: NodeContext<NodeDefinition>): NodeRuntime;
}

/** A running node: the functions that the player calls. */
export interface NodeRuntime {
  /** Computes the outputs of the node. Called once per frame, in program order, before anything is drawn. Must allocate nothing. */
  update(frame: SessionFrame): void;
  /**
   * Lists the objects that the node may show as hidden items, so that their materials are compiled. Called once before the first frame,
   * instead of `update`, on value nodes and behaviors that output objects.
   */
  prepare?(): void;
  /**
   * Waits for content that loads asynchronously, such as a frame of a video. Called only while the clock is held (`Clock.held`); the frame
   * is drawn after the promise resolves.
   *
   * @returns Resolves when the content that the last `update` requested is available; null if it is available already.
   */
  settle?(): Promise<void> | null;
  /**
   * Reads the inputs for later frames. Called once per frame, after the `update` of all nodes, on nodes whose definition says `delay`;
   * their `update` reads no inputs.
   */
  remember?(): void;
  /** Draws the node's layer. Called once per view on nodes that draw, with the target bound and cleared. */
  draw?(view: DrawView): void;
  /** Returns to the initial state. Called when playback was reset or poses are no longer valid. */
  reset?(): void;
  /** Changes when objects, lights or images of the node may change while params, inputs and view stay (ADR 51). Absent: in every frame. */
  readonly version?: number;
  /** True if the node keeps its state while a recording repeats, because the visitor has created that state in the room. */
  readonly staysOnRepeat?: true;
  /** Releases all that `create` and later calls have acquired. */
  dispose(): void;
}

/**
 * What a runtime reads and writes: its inputs, outputs, params and services. The types of ports and params are derived from the definition.
 *
 * @example
 * export function create(ctx: NodeContext<typeof definition>): NodeRuntime { … }
 */
export interface NodeContext<D extends NodeDefinition> {
  /** Id of the node in the graph, for messages. */
  readonly node: string;
  /** The inputs by name. An unconnected input is null, or an empty list if it takes several wires. */
  readonly inputs: { readonly [K in keyof D['inputs']]: InputView<D['inputs'][K]> };
  /** The outputs by name. An output with `whenRead` is absent while nothing reads it. */
  readonly outputs: { readonly [K in keyof D['outputs']]: OutputView<D['outputs'][K]['type']> | AbsentOutput<D['outputs'][K]> };
  /** Live values of the `uniform` params. */
  readonly params: {
    readonly [K in keyof D['params'] as D['params'][K]['stage'] extends 'uniform' ? K : never]: ParamView<D['params'][K]>;
  };
  /** Values of the `structure` params; constant. */
  readonly config: {
    readonly [K in keyof D['params'] as D['params'][K]['stage'] extends 'structure' ? K : never]: ConfigValue<D['params'][K]>;
  };
  /** Ids of the `asset` params; null where none is chosen. */
  readonly assetIds: { readonly [K in keyof D['params'] as D['params'][K]['stage'] extends 'asset' ? K : never]: string | null };
  readonly gl: WebGL2RenderingContext;
  readonly clock: Clock;
  /** A pseudorandom number in [0, 1), seeded per node, so that renders are reproducible. */
  readonly random: () => number;
  readonly assets: AssetService;
  readonly scenes: SceneService;
  readonly session: SessionService;
  readonly workers: WorkerService;
  /** The occlusion that a node with `ownDrawing.hidesBehindRoom` applies while it draws; null if there is none. */
  readonly occlusion: OcclusionView | null;
  /** Shows a problem at the node. Use it for mistakes of users; the frame continues. */
  report(diagnostic: Omit<Diagnostic, 'nodeId'>): void;
}

// --- Pulses -----------------------------------------------------------------------------------------------------------

/** An event of this frame. Fields that it does not use are 0, empty or null. */
export interface Pulse {
  readonly number: number;
  readonly text: string;
  /** The pose of the event, column-major 4×4; for a ray, its -z axis points along the ray. Null if the event has no pose. */
  readonly worldFromPose: Readonly<Float32Array> | null;
  /** The key of a physics body. */
  readonly bodyKey: string;
}

/**
 * The pulses of this frame, oldest first; for an input with several wires, in the order of the wires. It is empty where no wire is
 * connected. The objects are reused every frame: do not keep them.
 */
export interface PulseList {
  readonly count: number;
  /**
   * Returns one of the pulses.
   *
   * @param index From 0 to `count - 1`.
   */
  at(index: number): Pulse;
}

/** A pulse output. The player clears it before each frame. Pulses beyond 16 per frame are dropped, with one diagnostic (SCR056). */
export interface PulseOutput extends PulseList {
  /**
   * Adds a pulse.
   *
   * @param like A pulse to copy.
   * @returns The new pulse, to set its fields.
   *
   * @example
   * ctx.outputs.pulse.emit().number = count;
   */
  emit(like?: Pulse): NewPulse;
}

/** A pulse that was just emitted. */
export interface NewPulse extends Writable<Omit<Pulse, 'worldFromPose'>> {
  /**
   * Gives the pulse a pose.
   *
   * @param worldFromPose Column-major 4×4; copied.
   */
  setPose(worldFromPose: ArrayLike<number>): void;
}

// --- What other wires carry -------------------------------------------------------------------------------------------

/** The layer that a source node outputs. View domain: one entry per view. Image domain: entry 0 is for all views. */
export interface LayerOutput {
  readonly views: readonly Writable<LayerTexture>[];
}

/** The texture of a layer in one view. */
export interface LayerTexture {
  /** Premultiplied display-referred sRGB, RGBA8; null is transparent. */
  readonly texture: WebGLTexture | null;
  readonly widthPx: number;
  readonly heightPx: number;
  /** The UV matrix, column-major 3×3: texture UV from view UV. In the image domain it is the identity. */
  readonly uvFromViewUv: Float32Array;
  /** An integer that changes whenever the pixels, the size or the UV matrix change. `MAY_CHANGE`: they may change in every frame. */
  readonly version: number;
}

/** The version of a layer whose owner does not tell when it changes. */
export const MAY_CHANGE = -1;

/** What a runtime reads from an input, by wire type. */
export interface WireViews extends ValueViews {
  layer: LayerOutput;
  depth: RoomDepthOutput;
  objects: ObjectList;
  technique: TechniqueView;
  lights: LightList;
  environment: EnvironmentOutput;
  audio: SoundOutput;
  pulse: PulseList;
  pose: PoseView;
  body: BodyList;
  capture: CapturedPlace;
  surfaces: never; // No node has them yet.
}

type WireView<T extends WireType> = WireViews[T];
type InputView<P extends InputPort> = P extends { readonly type: 'pulse' }
  ? PulseList
  : P extends { readonly pixels: true }
    ? PixelsView | null
    : P extends { readonly multiple: true }
      ? readonly WireView<P['type']>[]
      : // If the type of the port is not known statically, all are possible.
        InputPort extends P
        ? readonly WireView<P['type']>[] | WireView<P['type']> | PixelsView | null
        : WireView<P['type']> | null;
type OutputView<T extends WireType> = T extends keyof ValueViews | 'capture'
  ? Writable<WireViews[T]>
  : T extends 'pulse'
    ? PulseOutput
    : T extends 'pose'
      ? PoseOutput
      : WireView<T>;
type AbsentOutput<P extends OutputPort> = P extends { readonly whenRead: true }
  ? undefined
  : // If the port is not known statically, it may be absent.
    OutputPort extends P
    ? undefined
    : never;
type ParamView<P extends ParamDefinition> = P extends { type: 'choice' }
  ? NumberView
  : P extends { type: infer T }
    ? T extends keyof ValueViews
      ? ValueViews[T]
      : never
    : never;
type ConfigValue<P extends ParamDefinition> = P extends { type: 'choice'; options: readonly { value: infer V }[] }
  ? V
  : P['default'] extends boolean
    ? boolean
    : P['default'] extends number
      ? number
      : P['default'] extends readonly number[]
        ? readonly number[]
        : string;

// --- Services ---------------------------------------------------------------------------------------------------------

/** The time of the program. It pauses and seeks with the preview. */
export interface Clock {
  /** Seconds since the session began. */
  readonly timeS: number;
  /** Seconds since the previous frame of the program. */
  readonly deltaS: number;
  /** The number of frames since the session began. */
  readonly frame: number;
  /**
   * True while frames are drawn one by one, independent of real time, as in a frame render. Asynchronous content is then awaited
   * (`NodeRuntime.settle`).
   */
  readonly held: boolean;
}

/** Runs the node's `worker.ts`. Only for definitions with `worker`. */
export interface WorkerService {
  /**
   * Starts a worker. The node disposes it.
   *
   * @throws Error where the browser starts none, and for nodes without `worker.ts`.
   *
   * @example
   * const worker = ctx.workers.start({ onMessage: (data) => take(data as Answer), onFailure: restart });
   */
  start(listener: WorkerListener): NodeWorker;
}

/** The functions that receive what a worker sends. */
export interface WorkerListener {
  onMessage(data: unknown): void;
  /** Called when the worker has ended because of an error; it answers no more. */
  onFailure(reason: string): void;
}

/** A running worker. */
export interface NodeWorker {
  /** Sends a message. The buffers in `transfer` belong to the worker from then on. */
  post(message: unknown, transfer: readonly ArrayBuffer[]): void;
  dispose(): void;
}

/** What the session provides, besides the frame that `update` receives. */
export interface SessionService {
  readonly frame: SessionFrame;
  readonly light: LightEstimate | null;
  /**
   * The element of the page over the canvas, of the same size, for nodes that show elements aligned with the room. Null while the page is
   * not visible, as in headsets, and in renders; absent in the preview, whose frames show everything. Such nodes draw objects instead.
   */
  readonly overlay?: HTMLElement | null;
  /**
   * A number that is raised when another session begins, with another world space and room. Compare it to forget what belongs to the old
   * room.
   */
  readonly sessions: number;
  /** The panorama that the visitor has taken for `source/panorama-capture`; null until then. A new panorama is another object. */
  readonly panorama: TakenPanorama | null;
  /** How the display mixes the image with the world: `additive` displays cannot darken, and black is transparent on them. */
  readonly blend: Session['blend'];
  /**
   * Mean linear-sRGB color of the camera image of the first view. It is measured only while it is read, with a delay of some frames;
   * without delay while the clock is held. Null without a camera image and until the first measurement.
   */
  readonly cameraMean: Readonly<Float32Array> | null;
  /**
   * Begins a hit test of the real room. Only for nodes whose definition needs `hit-test`. Closed with `HitTest.close`.
   *
   * @throws Error where no node of the program needs `hit-test` or `anchors`.
   *
   * @example
   * const hits = ctx.session.openHitTest({ from: 'viewer' });
   */
  openHitTest(options: HitTestOptions): HitTest;
  /**
   * The first hit of a ray with detected planes, detected meshes, room depth, measured rooms and the floor; the device's own hit test
   * follows no such ray. Only for nodes whose definition needs `hit-test`.
   *
   * @param worldFromRay Column-major 4×4, rigid: the ray begins at its origin, along its -z axis.
   * @param out Receives the hit.
   * @param sources Sources that may answer. Default: all.
   * @returns Whether something is hit.
   *
   * @example
   * if (ctx.session.castRay(pose.worldFromPose, hit)) distance.value = hit.distanceM;
   */
  castRay(worldFromRay: ArrayLike<number>, out: HitRecord, sources?: readonly HitSource[]): boolean;
  /**
   * Lets a room that the node measures answer hit tests and rays, as the source `voxels`. Only for nodes whose definition needs
   * `hit-test`.
   *
   * @returns Ends it; the node calls it in `dispose`.
   *
   * @example
   * const endAnswers = ctx.session.answerRays(createVoxelRays());
   */
  answerRays(by: MeasuredRoom): () => void;
  /**
   * The newest room depth of a view that is available on the CPU: that of this frame, or the last one that was read back from the GPU. Only
   * for nodes whose definition needs `hit-test`.
   *
   * @returns Null while there is none.
   *
   * @example
   * const picture = ctx.session.depthImage(0);
   */
  depthImage(viewIndex: number): DepthImage | null;
  /** Creates and restores anchors. Only for nodes whose definition needs `anchors`. */
  readonly anchors: AnchorService;
  /** Files that the page keeps for later visits. Only for nodes whose definition needs `hit-test` or `anchors`. */
  readonly keptFiles: KeptFiles;
}

/** The image behind a layer while the layer is drawn, which glass objects in the layer show. */
export interface UnderLayer {
  /** What glass shows where the layer has no objects; null: nothing, or `color`. */
  readonly texture: WebGLTexture | null;
  /** The UV matrix, column-major 3×3: texture UV from view UV. */
  readonly uvFromViewUv: Readonly<Float32Array>;
  readonly encoding: LayerEncoding;
  /** A color that takes the place of the texture: display-referred sRGB, premultiplied. */
  readonly color: Readonly<Float32Array> | null;
  /** Whether the target already contains what is visible through the layer, so that glass must not replace it. */
  readonly isInTarget: boolean;
}

/** The view and the target of a `draw` call. */
export interface DrawView {
  readonly view: ViewFrame;
  /** False if nothing reads the depth of the layer, which the node then need not write. */
  readonly readsDepth?: boolean;
  readonly viewIndex: number;
  readonly framebuffer: WebGLFramebuffer | null;
  /** The image behind the layer. Absent or null: there is none. */
  readonly under?: UnderLayer | null;
  readonly viewport: { readonly x: number; readonly y: number; readonly widthPx: number; readonly heightPx: number };
}

/**
 * Draws objects with three.js; all nodes share one renderer.
 *
 * @example
 * const scene = ctx.scenes.createScene({ kind: 'shaded' });
 * return { update: () => scene.update(objects, lights), draw: (view) => scene.draw(view), dispose: () => scene.dispose() };
 */
export interface SceneService {
  /**
   * Creates a scene of flat proxies (ADR 6).
   *
   * @param look How objects are drawn.
   * @returns The caller disposes it.
   */
  createScene(look: SceneLook): DrawnScene;
}

/** A three.js scene of flat proxies, which draws object lists. */
export interface DrawnScene {
  /** Updates the proxies from the lists. Call it once per frame. */
  update(objects: readonly ObjectList[], lights: readonly LightList[]): void;
  /** Draws into the bound target. The operation provides shadow maps and occlusion. */
  draw(view: DrawView): void;
  dispose(): void;
}
