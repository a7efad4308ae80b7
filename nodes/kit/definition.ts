import type { Curve } from './curve.ts';
import type { OwnDrawing, ShadowMapUse } from './drawing-options.ts';
import type { ComputedOutputs } from './expression.ts';
import type { Gradient } from './gradient.ts';
import type { Handle, HandleAxes } from './handles.ts';
import type { TableType, ValueType, WireType } from './wire-types.ts';

/**
 * A node type as data: ports, params, lowering and needs.
 *
 * The editor, the compiler and the docs share definitions; the behavior is in `runtime.ts` beside it, which only the runtime loads.
 *
 * @example
 * export const definition = defineNode({
 *   type: 'value/double',
 *   version: 1,
 *   title: 'Double',
 *   doc: 'Doubles a number.',
 *   inputs: {},
 *   outputs: { result: { type: 'number', label: 'Result', doc: 'The doubled number.' } },
 *   params: { number: { type: 'number', stage: 'uniform', label: 'Number', doc: 'The number to double.', default: 1 } },
 *   lowering: { kind: 'value' },
 * });
 */
export interface NodeDefinition {
  /** `category/name`: the folder below `nodes/`, or `filter|operator|generator/NAME` for an ISF file. Projects store it. */
  readonly type: string;
  /** Increased by one when the meaning of saved params changes; each increase needs a migration. */
  readonly version: number;
  readonly title: string;
  /** What the node does, then when to use it. Markdown without headings. */
  readonly doc: string;
  /** Other words that users search for. */
  readonly keywords?: readonly string[];
  /** Ports without a param. Names are unique across inputs and params. */
  readonly inputs: Readonly<Record<string, InputPort>>;
  readonly outputs: Readonly<Record<string, OutputPort>>;
  /** Values in the inspector. A `uniform` param of a value type is also an input port: a wire binds it. */
  readonly params: Readonly<Record<string, ParamDefinition>>;
  readonly lowering: Lowering;
  /**
   * Marks a node whose outputs depend only on inputs of earlier frames. The runtime reads the inputs in `remember`, after all nodes have
   * updated, so wires may form a loop through the node. Every loop needs such a node.
   */
  readonly delay?: true;
  /**
   * Says when the outputs depend on frames before the previous one, so that a render has to play all earlier frames. Absent: they never do.
   * An `image` lowering with `access: 'persistent'` is stateful too.
   */
  readonly stateful?: Stateful;
  /**
   * Makes the node a control on the visitor's screen, of this kind. The node needs params of these names: `label` (structure text) and
   * `place` (structure number); `value` (uniform number or toggle), except buttons, which have `presses` (uniform number); sliders also
   * `min`, `max` and `step` (structure numbers); choices also `options` (structure text, separated by commas), whose value is the index
   * from 0.
   */
  readonly control?: 'slider' | 'toggle' | 'button' | 'choice';
  /** Uniform params that become controls on the visitor's screen if the structure toggle that `by` names is on. */
  readonly visitorParams?: { readonly by: string; readonly params: readonly VisitorParam[] };
  readonly needs?: readonly Need[];
  /** Only for nodes whose outputs depend on their params alone: how, so that the compiler can compute constants. */
  readonly computes?: ComputedOutputs;
  /**
   * The name of an input port whose source nodes this node changes, as a physics world moves bodies. The node is then played if such a
   * source is, even if the output does not depend on this node.
   */
  readonly actsOn?: string;
  /** Marks a node that the visitor notices other than on the screen, as by a sound. It is played if its required inputs are connected. */
  readonly heard?: true;
  /** Marks a type of which a graph may contain only one node (SCR027). */
  readonly single?: true;
  /** Marks a node whose runtime starts a worker, from `worker.ts` in its folder; `npm run gen` bundles the worker's text. */
  readonly worker?: true;
  /**
   * Marks a node whose runtime reads `SessionFrame.input`. A page that has no such node, no hit test and no controls listens to no input.
   */
  readonly readsInput?: true;
  /** Element `i` migrates saved params from version `i + 1` to `i + 2`. */
  readonly migrations?: readonly Migration[];
  /** The same for shader files, which contain no code (`SCRIM_RENAMED` in a header): element `i` renames params. */
  readonly renamed?: readonly Readonly<Record<string, Renamed>>[];
  /** The author, shown in the docs and in the credits of exported pages. */
  readonly credit?: string;
  /** The license, if it is not that of Scrim; shown where `credit` is shown. */
  readonly licence?: string;
}

/**
 * When a node is stateful: always; if a uniform number is above a limit; or if one of the params changes over time, by a wire, a track
 * or an expression. (With a constant speed, for example, time is a function of the clock.)
 */
export type Stateful = true | { readonly param: string; readonly above: number } | { readonly moves: readonly string[] };

/** A number, choice or toggle for the visitor. `around`: how far from the set value a number may be moved; absent: its whole range. */
export interface VisitorParam {
  readonly param: string;
  readonly around?: number;
}

/** An input that is not a param. */
export interface InputPort {
  readonly type: WireType;
  readonly label: string;
  readonly doc: string;
  /** Whether the input must be connected: if it is not, a required input is an error; for an optional one, `doc` says what happens. */
  readonly required: boolean;
  /** Whether the input accepts several wires; their order is that of the document. */
  readonly multiple?: boolean;
  /**
   * Only for inputs of type `depth`. `raw`: the node measures with the depth, as physics does; surfaces smoothed between near and far would
   * be wrong. A session is asked for raw depth only if all readers say `raw`, because other uses, such as occlusion, flicker with it.
   */
  readonly depthType?: 'raw';
  /** Only for layer inputs: the encoding that the node reads. All inputs with `either` get the same encoding. Default: `display`. */
  readonly encoding?: LayerEncoding | 'either';
  /**
   * Names of params of the node that it does not read while something is connected to this input, as the wire carries their values. The
   * compiler ignores what is bound to them, the inspector says so.
   */
  readonly replaces?: readonly string[];
  /** Only for layer inputs of behaviors: the node reads a reduced image of an earlier frame on the CPU, as `PixelsView` (ADR 46). */
  readonly pixels?: true;
}

/** An output. */
export interface OutputPort {
  readonly type: WireType;
  readonly label: string;
  readonly doc: string;
  /** Only for layer outputs: the domain. `same`: that of the first layer input. */
  readonly domain?: LayerDomain | 'same';
  /** Only for layer outputs: whether the layer has depth. `same`: if the first layer input has. */
  readonly depth?: boolean | 'same';
  /**
   * Only for layer outputs: the encoding. `same`: that of the first input with `either`. `param`: the value of this structure choice, whose
   * options are the two encodings. Default: `display`.
   */
  readonly encoding?: LayerEncoding | 'same' | { readonly param: string };
  /**
   * Whether the runtime computes this output only if something reads it. If nothing does, the output is absent from `ctx.outputs`. Only for
   * nodes with a `runtime.ts`.
   */
  readonly whenRead?: true;
  /**
   * Only for nodes that draw, and outputs besides their layer: the folder in `nodes/part/` whose runtime writes the output, such as
   * `part/capture-place`. It gets the params of the node and no inputs, and is played before anything is drawn, if something reads the output.
   */
  readonly part?: `part/${string}`;
}

/**
 * How a layer stores color (ADR 38), premultiplied in both cases. `display`: sRGB as a screen shows it, clamped to [0, 1], 8 bits.
 * `scene`: linear sRGB, unclamped and finite, 16-bit floats.
 */
export type LayerEncoding = 'display' | 'scene';

/** `view`: aligned with the pixels of the view, one texture per view. `image`: its own size, one texture for all views. */
export type LayerDomain = 'view' | 'image';

/** When a param takes effect. `uniform`: at once. `structure`: recompiles. `asset`: recompiles; names an entry of the asset table. */
export type ParamStage = 'uniform' | 'structure' | 'asset';

/** The unit of the stored value. The inspector shows `rad` in degrees and the others as stored. */
export type Unit = 'm' | 's' | 'rad' | 'px' | 'K' | 'Hz' | 'cd' | 'ratio' | 'none';

interface ParamBase {
  readonly label: string;
  readonly doc: string;
}

/** A number, shown as a slider or a field. */
export interface NumberParam extends ParamBase {
  readonly type: 'number';
  readonly stage: 'uniform' | 'structure';
  /** The part of the gizmo that changes the param. Only for uniform params. */
  readonly handle?: Extract<Handle, 'scale' | 'azimuth' | 'elevation' | 'radius' | 'turn' | 'extent' | 'angle' | 'feather'>;
  readonly handleAxes?: HandleAxes;
  readonly default: number;
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly unit?: Unit;
}

/** A param of two to four numbers. */
export interface VectorParam extends ParamBase {
  readonly type: 'vector2' | 'vector3' | 'vector4';
  readonly stage: 'uniform';
  /** The part of the gizmo that changes the param: `center`, `low`, `high` and `size` of a `vector2`, the others of a `vector3`. */
  readonly handle?: Extract<Handle, 'position' | 'rotation' | 'scale' | 'aim' | 'step' | 'center' | 'low' | 'high' | 'size'>;
  readonly handleAxes?: HandleAxes;
  readonly default: readonly number[];
  readonly min?: readonly number[];
  readonly max?: readonly number[];
  readonly unit?: Unit;
}

/** A color: display-referred sRGB, straight alpha, `[r, g, b, a]` in [0, 1]. */
export interface ColorParam extends ParamBase {
  readonly type: 'color';
  readonly stage: 'uniform' | 'structure';
  readonly default: readonly [number, number, number, number];
}

/** A param that is on or off. */
export interface ToggleParam extends ParamBase {
  readonly type: 'toggle';
  readonly stage: 'uniform' | 'structure';
  readonly default: boolean;
}

/** A param whose value is a text, which the inspector edits in one line. */
export interface TextParam extends ParamBase {
  readonly type: 'text';
  readonly stage: 'uniform' | 'structure';
  readonly default: string;
  /** The text is an expression (`expression.ts`) with these params as names; the runtime gets it in postfix notation. */
  readonly expression?: { readonly names: readonly string[] };
  /**
   * The text lists the characters that the param `of`, which is a uniform text, may show while a wire sets it. The runtime gets the
   * outlines of what it may show (`glyphs.ts`): of these characters, or of the text itself if no wire sets it.
   */
  readonly glyphs?: { readonly of: string; readonly font: string };
  /** The text names an animation of the model that the asset param `of` has: empty the first one, `none` none. Editors list the names. */
  readonly animation?: { readonly of: string };
}

/** One of several options. A `uniform` choice has numbers (ISF `long`), a `structure` choice has words. Projects store the value. */
export interface ChoiceParam extends ParamBase {
  readonly type: 'choice';
  readonly stage: 'uniform' | 'structure';
  readonly default: string | number;
  readonly options: readonly { readonly value: string | number; readonly label: string }[];
}

/** A curve over the unit square (`curve.ts`) or a gradient (`gradient.ts`). No wire, track or expression carries one. */
export interface TableParam extends ParamBase {
  readonly type: TableType;
  readonly stage: 'uniform';
  readonly default: Curve | Gradient;
}

/** A param whose value is the id of an entry of the project's asset table; empty means none. */
export interface AssetParam extends ParamBase {
  readonly type: 'asset';
  readonly stage: 'asset';
  readonly default: '';
  readonly accept: AssetKind;
  /** The asset is used only if a structure param has this value; the depth meshes of a capture likewise. */
  readonly where?: { readonly param: string; readonly is: string | number | boolean };
  readonly depthMeshes?: { readonly param: string; readonly is: string };
}

/** The kinds of files in the asset table. */
export const ASSET_KINDS = ['image', 'model', 'video', 'audio', 'environment', 'capture', 'splats'] as const;

/** The kind of a file in the asset table. */
export type AssetKind = (typeof ASSET_KINDS)[number];

/** A param of any type. */
export type ParamDefinition = NumberParam | VectorParam | ColorParam | ToggleParam | TextParam | ChoiceParam | TableParam | AssetParam;

/**
 * The value of a param while it is bound to nothing else. Numbers in stored units; a vector, a color, a curve or a gradient is a list of
 * numbers; a choice is the value of its option, an asset its id.
 */
export type ParamValue = number | boolean | string | readonly number[];

/**
 * Which pixels of its inputs an image operation reads, from the cheapest: `pointwise` the same pixel; `displaced` one other pixel;
 * `neighborhood` several; `persistent` its own earlier output; `resize` inputs or targets of another size.
 */
export type Access = 'pointwise' | 'displaced' | 'neighborhood' | 'persistent' | 'resize';

/** How the compiler translates the node to operations of the program. */
export type Lowering =
  /** One or more full-screen passes of an ISF shader, without three.js. `shader` is its name in the library or the project. */
  | {
      readonly kind: 'image';
      readonly shader: string;
      readonly access: Access;
      /**
       * For a filter that hides parts of a layer: if its input is a Scene, the compiler can get the same result by discarding fragments
       * while the scene is drawn (ADR 26).
       */
      readonly early?: 'occlusion';
    }
  /** Pixels of one layer, changed on the CPU in a worker (`worker.ts` of the node); the output is one frame late (ADR 21). */
  | { readonly kind: 'cpu' }
  /** Creates, arranges or draws objects and lights. It draws if it has a layer output: by three.js, or (`ownDrawing`) by its own program. */
  | { readonly kind: 'geometry'; readonly shadowMap?: ShadowMapUse; readonly ownDrawing?: OwnDrawing }
  /** A custom material from a technique file. `shader` is its name in the library or the project. */
  | { readonly kind: 'technique'; readonly shader: string }
  /** A function of values, evaluated on the CPU once per frame. */
  | { readonly kind: 'value' }
  /** An input from outside the graph: files, the camera, the room. */
  | { readonly kind: 'source'; readonly background?: 'world' }
  /** Behavior over time, such as physics or placement. */
  | { readonly kind: 'behavior' }
  /** The Output node; one per graph. */
  | { readonly kind: 'present' };

/** A feature of a session. */
export type Capability =
  | 'camera-image'
  | 'depth'
  | 'light-estimation'
  | 'hit-test'
  | 'anchors'
  | 'planes'
  | 'meshes'
  | 'hands'
  | 'microphone'
  | 'motion'
  | 'location';

/** A feature that a node uses. */
export interface Need {
  readonly capability: Capability;
  /**
   * `true`: without the feature no session starts. `false`: the session starts, with the effect that `without` describes. `alone`: required
   * only if the output shows only layers of such nodes.
   */
  readonly required: boolean | 'alone';
  /** `sampled`: the feature is needed only if a node reads the layer as an image, not if the layer is only the background. */
  readonly when: 'always' | 'sampled';
  /** The feature is needed only if a structure param has this value. */
  readonly where?: { readonly param: string; readonly is: string | number | boolean };
  /** The feature is needed only if something is connected to the input of this name. */
  readonly wired?: string;
  /** Only for `depth` that the node reads without an input: the kind of depth, as in `InputPort`. */
  readonly depthType?: 'raw';
  /** The purpose, shown to the visitor before the browser asks: “to …”. */
  readonly why: string;
  /** What happens without the feature, as a sentence. */
  readonly without: string;
}

/** The new name of a param, which may be the old one, and what else has changed. */
export interface Renamed {
  readonly to: string;
  /** The factor on its numbers if its unit has changed, else 1. */
  readonly times: number;
  /** The default in the earlier version if it has changed: projects, which store no defaults, keep it. */
  readonly was?: number | string | boolean | readonly number[];
}

/** Params as a project file stores them. */
export type SavedParams = Record<string, unknown>;

/** Converts saved params from one version of a node type to the next; returns a new object. */
export type Migration = (params: SavedParams) => SavedParams;

/** Definitions and shader texts: the generated library, overridden by a project's own shaders. */
export interface NodeLibrary {
  definition(type: string): NodeDefinition | undefined;
  /** The source of an ISF file, a technique or a chunk, an image of a technique as base64, or the outlines of a font (`glyphs.ts`). */
  shader(name: string): string | undefined;
  types(): Iterable<string>;
}

/**
 * Creates a library from definitions and shader texts.
 *
 * @param shaders Texts by name, as `SHADERS` of `nodes/generated`.
 *
 * @example
 * const library = libraryOf(DEFINITIONS, SHADERS);
 */
export function libraryOf(definitions: readonly NodeDefinition[], shaders: Readonly<Record<string, string>>): NodeLibrary {
  const byType = new Map(definitions.map((definition) => [definition.type, definition]));
  return {
    definition: (type) => byType.get(type),
    shader: (name) => (Object.hasOwn(shaders, name) ? shaders[name] : undefined),
    types: () => byType.keys(),
  };
}

/**
 * Returns a definition with its literal types, from which `NodeContext` derives the types of the runtime.
 *
 * @example
 * export const definition = defineNode({ type: 'value/double', … });
 */
export function defineNode<const D extends NodeDefinition>(definition: D): D {
  return definition;
}

/**
 * The type of the port of a param.
 *
 * @returns Undefined if no wire can be connected: curves, gradients, assets and params that recompile.
 *
 * @example
 * paramWireType({ type: 'choice', stage: 'uniform', … }); // 'number'
 */
export function paramWireType(param: ParamDefinition): ValueType | undefined {
  if (param.stage !== 'uniform' || param.type === 'curve' || param.type === 'gradient') return undefined;
  return param.type === 'choice' ? 'number' : param.type;
}
