import type { AssetService } from './assets.ts';
import type { InputPort, NodeDefinition, ParamDefinition } from './definition.ts';
import type { Diagnostic } from './diagnostics.ts';
import type { EnvironmentOutput, LightList, ObjectList, RoomDepthOutput } from './scene-lists.ts';
import type { SceneLook } from './scene-look.ts';
import type { LightEstimate, SessionFrame, ViewFrame } from './session.ts';
import type { SoundOutput } from './sound.ts';
import type { TechniqueView } from './technique-view.ts';
import type { NumberView, ValueViews, Writable } from './value-views.ts';
import type { WireType } from './wire-types.ts';

/**
 * The contract between a node's `runtime.ts` and the player. Types only.
 *
 * @example
 * export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
 *   return { update: () => { ctx.outputs.result.value = ctx.params.a.value + ctx.params.b.value; }, dispose: () => {} };
 * }
 */
export interface NodeModule {
  create(ctx: NodeContext<NodeDefinition>): NodeRuntime;
}

export interface NodeRuntime {
  /** Once per frame, in program order, before anything is drawn. Allocates nothing. */
  update(frame: SessionFrame): void;
  /**
   * For nodes that bring something in which takes time to get, such as a moment of a video: resolves when what the last `update`
   * asked for is there, and is null when it is already. Asked only while the clock is held (`Clock.held`); the frame is drawn then.
   */
  settle?(): Promise<void> | null;
  /**
   * For definitions with `delay`: once per frame, after the `update` of all nodes. Reads the inputs for the frames to come, while
   * `update` reads none of them.
   */
  remember?(): void;
  /** For nodes that draw: once per view, with the target bound and cleared. */
  draw?(view: DrawView): void;
  /** Back to the first frame: the transport's reset, or poses became void. */
  reset?(): void;
  dispose(): void;
}

export interface NodeContext<D extends NodeDefinition> {
  /** Id of the node in the graph, for messages. */
  readonly node: string;
  readonly inputs: { readonly [K in keyof D['inputs']]: InputView<D['inputs'][K]> };
  readonly outputs: { readonly [K in keyof D['outputs']]: OutputView<D['outputs'][K]['type']> };
  readonly params: {
    readonly [K in keyof D['params'] as D['params'][K]['stage'] extends 'uniform' ? K : never]: ParamView<D['params'][K]>;
  };
  readonly config: {
    readonly [K in keyof D['params'] as D['params'][K]['stage'] extends 'structure' ? K : never]: ConfigValue<D['params'][K]>;
  };
  readonly assetIds: { readonly [K in keyof D['params'] as D['params'][K]['stage'] extends 'asset' ? K : never]: string | null };
  readonly gl: WebGL2RenderingContext;
  readonly clock: Clock;
  /** Uniform in [0, 1), seeded per node, so that a render repeats. */
  readonly random: () => number;
  readonly assets: AssetService;
  readonly scenes: SceneService;
  readonly session: SessionService;
  /** A problem the user can mend, shown at the node; the frame goes on without the node's work. */
  report(diagnostic: Omit<Diagnostic, 'nodeId'>): void;
}

// --- Pulses -----------------------------------------------------------------------------------------------------------

/** Something that happened in this frame. What it does not bring is 0, empty or null. */
export interface Pulse {
  readonly number: number;
  readonly text: string;
  /** Column-major 4×4; of a ray, its -z axis points along it. */
  readonly worldFromPose: Readonly<Float32Array> | null;
  /** Which physics body it is about. */
  readonly bodyKey: string;
}

/**
 * What happened in this frame, oldest first: of a port with several wires, wire by wire. An unwired port has an empty one. The
 * same objects every frame: read them during the frame, keep none.
 */
export interface PulseList {
  readonly count: number;
  /** From 0 to `count - 1`. */
  at(index: number): Pulse;
}

/** Emptied by the player before each frame. Beyond 16 pulses a frame the rest are dropped, which the user is told once. */
export interface PulseOutput extends PulseList {
  /**
   * Adds a pulse, with all that `like` brings, and returns it to be completed.
   *
   * @example
   * ctx.outputs.pulse.emit().number = count;
   */
  emit(like?: Pulse): NewPulse;
}

export interface NewPulse extends Writable<Omit<Pulse, 'worldFromPose'>> {
  /** Copies the matrix. */
  setPose(worldFromPose: ArrayLike<number>): void;
}

// --- What other wires carry -------------------------------------------------------------------------------------------

/** A layer brought in from outside. View domain: one entry per view; image domain: entry 0 serves all. */
export interface LayerOutput {
  readonly views: readonly Writable<LayerTexture>[];
}

export interface LayerTexture {
  /** Premultiplied display-referred sRGB, RGBA8; null stands for transparent. */
  readonly texture: WebGLTexture | null;
  readonly widthPx: number;
  readonly heightPx: number;
  /** Column-major 3×3: texture UV from view UV (view domain) or from image UV (image domain). */
  readonly uvFromViewUv: Float32Array;
}

export interface WireViews extends ValueViews {
  layer: LayerOutput;
  depth: RoomDepthOutput;
  objects: ObjectList;
  technique: TechniqueView;
  lights: LightList;
  environment: EnvironmentOutput;
  audio: SoundOutput;
  pulse: PulseList;
  // No node has these yet.
  surfaces: never;
  pose: never;
  body: never;
  capture: never;
}

type WireView<T extends WireType> = WireViews[T];
type InputView<P extends InputPort> = P extends { readonly type: 'pulse' }
  ? PulseList
  : P extends { readonly multiple: true }
    ? readonly WireView<P['type']>[]
    : // Of a port that is not known, either.
      InputPort extends P
      ? readonly WireView<P['type']>[] | WireView<P['type']> | null
      : WireView<P['type']> | null;
type OutputView<T extends WireType> = T extends keyof ValueViews ? Writable<ValueViews[T]> : T extends 'pulse' ? PulseOutput : WireView<T>;
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

export interface Clock {
  readonly timeS: number;
  readonly deltaS: number;
  readonly frame: number;
  /** Frames come one by one, however long each takes, as in a render: what takes time is waited for (`NodeRuntime.settle`). */
  readonly held: boolean;
}

export interface SessionService {
  readonly frame: SessionFrame;
  readonly light: LightEstimate | null;
  /**
   * Mean linear-sRGB color of what the camera of the first view sees, where the session has its image; null where it has none, and
   * until it has been measured. Measured while somebody asks, some frames late; at once while the clock is held.
   */
  readonly cameraMean: Readonly<Float32Array> | null;
}

/** Where `draw` draws. */
export interface DrawView {
  readonly view: ViewFrame;
  readonly viewIndex: number;
  readonly framebuffer: WebGLFramebuffer | null;
  readonly viewport: { readonly x: number; readonly y: number; readonly widthPx: number; readonly heightPx: number };
}

/** three.js, for nodes that draw objects; one renderer serves all. */
export interface SceneService {
  /** A scene of flat proxies for the given lists. `look` decides what each object is drawn with. */
  createScene(look: SceneLook): DrawnScene;
}

export interface DrawnScene {
  /** Takes over changed lists and this frame's matrices. */
  update(objects: readonly ObjectList[], lights: readonly LightList[]): void;
  /** Draws into the bound target; shadow maps and occlusion come from the operation. */
  draw(view: DrawView): void;
  dispose(): void;
}
