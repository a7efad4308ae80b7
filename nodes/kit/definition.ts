import type { Curve } from './curve.ts';
import type { ValueType, WireType } from './wire-types.ts';

/**
 * What a node type is, as data: ports, params, how it lowers and what it needs. Nothing here runs.
 *
 * A definition is shared by the editor (canvas, inspector), the compiler (checks, lowering) and the docs; the behavior is in
 * `runtime.ts` beside it, which only the runtime loads.
 */
export interface NodeDefinition {
  /** `category/name`, the folder below `nodes/`, or `filter|operator|generator/NAME` for an ISF file. */
  readonly type: string;
  /** Raised by one whenever saved params would mean something else; each raise ships a migration. */
  readonly version: number;
  readonly title: string;
  /** First sentence: what it makes. Then how designers use it. Markdown without headings. */
  readonly doc: string;
  /** Other words people search for. */
  readonly keywords?: readonly string[];
  /** Ports that only a wire can fill. Names are unique over inputs and params together. */
  readonly inputs: Readonly<Record<string, InputPort>>;
  readonly outputs: Readonly<Record<string, OutputPort>>;
  /** Values edited in the inspector. A `uniform` param of a value type is also an input port: a wire to it binds it. */
  readonly params: Readonly<Record<string, ParamDefinition>>;
  readonly lowering: Lowering;
  /**
   * Outputs what its inputs had in the previous frame, or earlier: its inputs are read when the frame's values are all there (`remember` of its
   * runtime), so that wires into it may close a loop. No other node may be the one that closes a loop.
   */
  readonly delay?: true;
  /**
   * What it gives depends on more frames than this one and the one before, so that a render has to play all earlier frames. Absent: it
   * does not. An `image` lowering says the same by `access: 'persistent'`.
   */
  readonly stateful?: Stateful;
  /**
   * Visitors set it on screen. Such a node has params by these names: `label` (structure text) and `place` (structure number) all of
   * them; `value` (uniform: number, toggle) all but buttons, which count their `presses` (uniform number); `min`, `max` and `step`
   * (structure numbers) sliders; `options` (structure text, parted by commas) choices, whose value is the place from 0.
   */
  readonly control?: 'slider' | 'toggle' | 'button' | 'choice';
  readonly needs?: readonly Need[];
  /** Step `i` lifts saved params from version `i + 1` to `i + 2`. */
  readonly migrations?: readonly Migration[];
  /** The same for shader files, whose definitions are data alone (`SCRIM_RENAMED` in a header): step `i` gives params other names. */
  readonly renamed?: readonly Readonly<Record<string, Renamed>>[];
  /** Who made it, shown in the docs and in the exported page's credits. */
  readonly credit?: string;
  /** Under which terms, where they are not Scrim's own; shown in the same places. */
  readonly licence?: string;
}

/**
 * When a node is stateful: always, where a uniform number is above a limit, or where one of the params moves, by a wire, a track or an
 * expression: at a steady speed, time is a function of the clock.
 */
export type Stateful = true | { readonly param: string; readonly above: number } | { readonly moves: readonly string[] };

export interface InputPort {
  readonly type: WireType;
  readonly label: string;
  readonly doc: string;
  /** A required port without a wire is an error; an optional one has a stated meaning in `doc`. */
  readonly required: boolean;
  /** Takes several wires, in the document's order. */
  readonly multiple?: boolean;
}

export interface OutputPort {
  readonly type: WireType;
  readonly label: string;
  readonly doc: string;
  /** For layers; `same` means that of the first layer input. */
  readonly domain?: LayerDomain | 'same';
  /** For layers: whether it has depth; `same` means that of the first layer input. */
  readonly depth?: boolean | 'same';
}

/** `view`: pixel-aligned, one texture per view. `image`: its own size, one texture for all views. */
export type LayerDomain = 'view' | 'image';

/** `uniform`: set while running. `structure`: needs a recompile. `asset`: names an entry of the project's asset table. */
export type ParamStage = 'uniform' | 'structure' | 'asset';

/** The unit of the stored value. The inspector shows `rad` in degrees; everything else as stored. */
export type Unit = 'm' | 's' | 'rad' | 'px' | 'K' | 'Hz' | 'cd' | 'ratio' | 'none';

interface ParamBase {
  readonly label: string;
  readonly doc: string;
}

/**
 * The gizmo handles in the preview that change params, besides the inspector. `position`, `rotation` and `scale` are of the
 * frame that the node puts things in: meters; angles about x, y and z, turned first about z, then x, then y; factors, or sizes. `aim` is
 * a point that the node is turned towards from its position. `azimuth` and `elevation` say where light comes from.
 */
export type Handle = 'position' | 'rotation' | 'scale' | 'aim' | 'azimuth' | 'elevation';

export interface NumberParam extends ParamBase {
  readonly type: 'number';
  readonly stage: 'uniform' | 'structure';
  /** Of uniform params. */
  readonly handle?: 'scale' | 'azimuth' | 'elevation';
  readonly default: number;
  readonly min?: number;
  readonly max?: number;
  readonly step?: number;
  readonly unit?: Unit;
}

export interface VectorParam extends ParamBase {
  readonly type: 'vector2' | 'vector3' | 'vector4';
  readonly stage: 'uniform';
  /** Of vectors of three. */
  readonly handle?: 'position' | 'rotation' | 'scale' | 'aim';
  readonly default: readonly number[];
  readonly min?: readonly number[];
  readonly max?: readonly number[];
  readonly unit?: Unit;
}

/** Display-referred sRGB, straight alpha, `[r, g, b, a]` in [0, 1]. */
export interface ColorParam extends ParamBase {
  readonly type: 'color';
  readonly stage: 'uniform' | 'structure';
  readonly default: readonly [number, number, number, number];
}

export interface ToggleParam extends ParamBase {
  readonly type: 'toggle';
  readonly stage: 'uniform' | 'structure';
  readonly default: boolean;
}

export interface TextParam extends ParamBase {
  readonly type: 'text';
  readonly stage: 'uniform' | 'structure';
  readonly default: string;
  /** The text is an expression (`expression.ts`) over these numbers of the node's own; its runtime gets the postfix. */
  readonly expression?: { readonly names: readonly string[] };
}

/** One of a list. A `uniform` choice holds numbers (ISF `long`), a `structure` choice holds words. */
export interface ChoiceParam extends ParamBase {
  readonly type: 'choice';
  readonly stage: 'uniform' | 'structure';
  readonly default: string | number;
  readonly options: readonly { readonly value: string | number; readonly label: string }[];
}

/**
 * A curve over the square from (0, 0) to (1, 1), as `curve.ts` says. It is set while the project runs, but no wire, track or expression
 * carries one.
 */
export interface CurveParam extends ParamBase {
  readonly type: 'curve';
  readonly stage: 'uniform';
  readonly default: Curve;
}

/** The id of an entry in the project's asset table; the empty string means none chosen. */
export interface AssetParam extends ParamBase {
  readonly type: 'asset';
  readonly stage: 'asset';
  readonly default: '';
  readonly accept: AssetKind;
  /** Needed only where a structure param has this value. */
  readonly where?: { readonly param: string; readonly is: string | number | boolean };
}

export const ASSET_KINDS = ['image', 'model', 'video', 'audio', 'environment'] as const;

export type AssetKind = (typeof ASSET_KINDS)[number];

export type ParamDefinition = NumberParam | VectorParam | ColorParam | ToggleParam | TextParam | ChoiceParam | CurveParam | AssetParam;

/**
 * The value of a param while it is bound to nothing else. Numbers in stored units; a vector, a color or a curve is a list of numbers; a
 * choice is the value of its option, an asset its id.
 */
export type ParamValue = number | boolean | string | readonly number[];

/**
 * What an image operation reads of its inputs, from the cheapest: `pointwise` the pixel itself; `displaced` one other pixel;
 * `neighborhood` several; `persistent` its own earlier output; `resize` inputs or targets of another size.
 */
export type Access = 'pointwise' | 'displaced' | 'neighborhood' | 'persistent' | 'resize';

export type Lowering =
  /** One or more full-screen passes of an ISF shader; needs no three.js. `shader` names it in the library or the project. */
  | {
      readonly kind: 'image';
      readonly shader: string;
      readonly access: Access;
      /** The same result can be had by discarding fragments while a scene is drawn, when what this node takes in is that scene. */
      readonly early?: 'occlusion';
    }
  /** Pixels of one layer, changed by the processor in a worker (`worker.ts` of the node): its layer is a frame late (ADR 21). */
  | { readonly kind: 'cpu' }
  /** Makes, arranges or draws objects and lights (three.js). Draws when it has a layer output. */
  | { readonly kind: 'geometry'; readonly shadowMap?: ShadowMapUse }
  /** A way to draw objects, made of a technique file. `shader` names it in the library or the project. */
  | { readonly kind: 'technique'; readonly shader: string }
  /** A function of values, evaluated on the CPU once a frame. */
  | { readonly kind: 'value' }
  /** Brings something in from outside: files, camera, room. */
  | { readonly kind: 'source'; readonly background?: 'world' }
  /** Reads and writes over time: physics, placing, logic. */
  | { readonly kind: 'behavior' }
  /** What the visitor sees; one per graph. */
  | { readonly kind: 'present' };

/** Which of a node's ports decide its shadow maps; equal wires share one map. */
export interface ShadowMapUse {
  readonly casters: readonly string[];
  readonly lights: string;
  /** A structure toggle that turns the maps off. */
  readonly enabledBy?: string;
  /** A structure choice, and the one of its values at which the node uses maps; at others it does without. */
  readonly chosenBy?: { readonly param: string; readonly value: string };
}

/** What a session may offer beyond drawing. */
export type Capability =
  | 'camera-image'
  | 'depth'
  | 'light-estimation'
  | 'hit-test'
  | 'anchors'
  | 'planes'
  | 'meshes'
  | 'hands'
  | 'microphone';

export interface Need {
  readonly capability: Capability;
  /**
   * A required need refuses the session; an optional one degrades as `without` says. `alone`: required where the screen shows
   * nothing but what comes from such nodes, because nothing would be left.
   */
  readonly required: boolean | 'alone';
  /** `sampled`: only when some node reads the layer as an image, not when it is merely the background. */
  readonly when: 'always' | 'sampled';
  /** Only where a structure param has this value. */
  readonly where?: { readonly param: string; readonly is: string | number | boolean };
  /** Shown to the visitor before the browser asks, in the form "to …". */
  readonly why: string;
  /** What the picture does without it. */
  readonly without: string;
}

/** What became of a param. Its numbers are multiplied with `times`, where it is measured otherwise now. */
export interface Renamed {
  readonly to: string;
  readonly times: number;
}

export type SavedParams = Record<string, unknown>;
export type Migration = (params: SavedParams) => SavedParams;

/** Where definitions and shader texts come from: the generated library, with a project's own shaders before it. */
export interface NodeLibrary {
  definition(type: string): NodeDefinition | undefined;
  /** ISF source of an `image` lowering, the text of a technique or chunk, or a picture that techniques carry, as base64. */
  shader(name: string): string | undefined;
  types(): Iterable<string>;
}

/** A library of what `nodes/generated` lists, or of a part of that. */
export function libraryOf(definitions: readonly NodeDefinition[], shaders: Readonly<Record<string, string>>): NodeLibrary {
  const byType = new Map(definitions.map((definition) => [definition.type, definition]));
  return {
    definition: (type) => byType.get(type),
    shader: (name) => (Object.hasOwn(shaders, name) ? shaders[name] : undefined),
    types: () => byType.keys(),
  };
}

/** Keeps the literal types, so that a runtime can be typed from its definition; adds nothing. */
export function defineNode<const D extends NodeDefinition>(definition: D): D {
  return definition;
}

/** The value type under which a param can be wired, or undefined where it cannot. */
export function paramWireType(param: ParamDefinition): ValueType | undefined {
  if (param.stage !== 'uniform' || param.type === 'curve') return undefined;
  return param.type === 'choice' ? 'number' : param.type;
}
