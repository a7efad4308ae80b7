import type { ArithmeticOperation } from '../../nodes/kit/arithmetic.ts';
import type { AssetKind, Capability, ParamValue } from '../../nodes/kit/definition.ts';
import type { ValueType } from '../../nodes/kit/wire-types.ts';

/**
 * The program: what the compiler prints and the only thing the runtime plays. Plain JSON, versioned, and free of everything
 * that belongs to the editor. This folder imports types of the kit alone, so the format can be read on its own.
 *
 * Order of a frame: operations run in list order. Those with `view: 'once'` come first (values, sources, objects, shadow maps,
 * image-domain passes), then those with `view: 'each'` run as a block once per view, so that views share their targets.
 */
export const PROGRAM_VERSION = 1;

export interface Program {
  readonly format: 'scrim-program';
  readonly version: typeof PROGRAM_VERSION;
  readonly title: string;
  readonly slots: SlotTable;
  readonly resources: readonly Resource[];
  readonly operations: readonly Operation[];
  readonly shaders: readonly LinkedShader[];
  readonly assets: readonly ProgramAsset[];
  readonly presentation: Presentation;
  readonly needs: readonly ProgramNeed[];
  readonly tiers: readonly Tier[];
  /** Viewed layers, `node.port` → resource. Empty in an export. */
  readonly taps: Readonly<Record<string, LayerRef>>;
  /** What visitors can set on screen, from top to bottom; absent where there is nothing. */
  readonly controls?: readonly Control[];
  /** Credits of the works in it, by title; absent where no author is named. For display only: the runtime ignores them. */
  readonly credits?: readonly ProgramCredit[];
}

/** A work and its terms. */
export interface ProgramCredit {
  /** An effect's title, or the project path of an asset. */
  readonly title: string;
  readonly kind: 'effect' | 'asset';
  /** The author; empty where none is named. */
  readonly credit: string;
  /** Empty where none is named: effects of Scrim's own library are under Scrim's. */
  readonly licence: string;
  /** Ids of the nodes that use it. */
  readonly nodes: readonly string[];
}

/**
 * A control on screen. Setting it is `setParam(node, param, value)`: for a slider a number, for a toggle a boolean or 0 and 1, for a
 * choice the place of the option, from 0. Each press of a button sets one more than before: two within a frame count as two.
 */
export type Control = ControlBase &
  (
    | { readonly kind: 'slider'; readonly min: number; readonly max: number /** 0: none. */; readonly step: number }
    | { readonly kind: 'toggle' }
    | { readonly kind: 'button' }
    | { readonly kind: 'choice'; readonly options: readonly string[] }
  );

interface ControlBase {
  readonly node: string;
  readonly param: string;
  readonly label: string;
  /** Where it stands at first; 0 or 1 for a toggle. */
  readonly value: number;
}

/** Numbers live in one flat Float64Array, texts in one table; operations name them by slot index. */
export interface SlotTable {
  readonly numbers: readonly number[];
  readonly texts: readonly string[];
  readonly slots: readonly Slot[];
  /** `node.param` → slot index, for every value that may be set while running. */
  readonly params: Readonly<Record<string, number>>;
}

export type SlotType = ValueType | 'curve';

export interface Slot {
  readonly type: SlotType;
  /** First index in `numbers`, or the index in `texts` for a text. */
  readonly offset: number;
}

export type ResourceId = string;

/** Something operations read and write. Ids are readable: `blur-p3ma.out`, `blur-p3ma.pass0`. */
export type Resource =
  /** A texture of the runtime's own, drawn into. */
  | {
      readonly id: ResourceId;
      readonly kind: 'target';
      readonly domain: 'view' | 'image';
      readonly size: TargetSize;
      readonly format: TargetFormat;
      /** `window`: a depth buffer to draw and to read. `none`: color alone. */
      readonly depth: 'none' | 'window';
      readonly samples: 1 | 4;
      /** `persistent` keeps the previous frame: reading it while writing it gives the earlier one. */
      readonly lifetime: 'frame' | 'persistent';
      /** An equal target that no later operation reads when this one is drawn: both use one texture. */
      readonly shares?: ResourceId;
    }
  /** A texture that a source brings: picture, video, camera. */
  | { readonly id: ResourceId; readonly kind: 'external'; readonly domain: 'view' | 'image' }
  /** Real-world depth, per view. */
  | { readonly id: ResourceId; readonly kind: 'room-depth' }
  | { readonly id: ResourceId; readonly kind: 'objects' }
  | { readonly id: ResourceId; readonly kind: 'lights' }
  /** A panorama around the scene. */
  | { readonly id: ResourceId; readonly kind: 'environment' }
  /** Sound on its way to shaders. */
  | { readonly id: ResourceId; readonly kind: 'sound' }
  /** What happened in this frame: emptied before each. */
  | { readonly id: ResourceId; readonly kind: 'pulses' }
  /** A curve as a table of heights (`curve-table.ts`), of the curve in that slot; nobody writes it. */
  | { readonly id: ResourceId; readonly kind: 'curve'; readonly slot: number }
  /** A way to draw objects; nobody writes it. */
  | TechniqueResource
  /** Depth from every shadow-casting light over one set of casters. */
  | { readonly id: ResourceId; readonly kind: 'shadow-maps' };

export interface TechniqueResource {
  readonly id: ResourceId;
  readonly kind: 'technique';
  /**
   * Index into `shaders`: one that shows whether a driver takes the text, and whose source map is the text's. It draws nothing.
   * Null in an export.
   */
  readonly trial: number | null;
  /** Text for the vertex and the fragment shader of the material that draws objects; see `export/glsl/technique/interface.ts`. */
  readonly vertex: string;
  readonly fragment: string;
  /** Draws of each object, in order. */
  readonly passes: readonly TechniquePass[];
  readonly uniforms: readonly TechniqueUniform[];
  /** Colors of layers that it reads, if any; draws with it name them among their reads. */
  readonly samplers?: readonly PassSampler[];
  /** Pictures that it brings along, by the name of their uniform: base64 of a PNG with its mip levels side by side. */
  readonly pictures?: readonly { readonly name: string; readonly data: string }[];
}

export interface TechniquePass {
  /** Which sides of triangles are drawn; `object`: those that the object's own material shows. */
  readonly side: 'object' | 'front' | 'back' | 'both';
}

export interface TechniqueUniform {
  readonly name: string;
  readonly type: PassUniform['type'];
  readonly slot: number;
}

/** `rgba8`: a layer. `rgba16f`: unclamped. `rgba32f`: numbers. `r32f`: depth in meters, 0 where there is none. */
export type TargetFormat = 'rgba8' | 'rgba16f' | 'rgba32f' | 'r32f';

/** Pixels: the view's, or another resource's; each side times `scale`, or an ISF size expression over slots. */
export interface TargetSize {
  readonly base: 'view' | ResourceId;
  readonly width: SizeExpression;
  readonly height: SizeExpression;
}

/**
 * Postfix over the base's `$WIDTH` and `$HEIGHT`, constants and slots, so that no parser is needed at run time;
 * `nodes/kit/arithmetic.ts` says what each operation does.
 */
export type SizeExpression = readonly (number | SizeToken)[];
export type SizeToken = { readonly slot: number } | { readonly op: 'width' | 'height' | ArithmeticOperation };

/** A layer is a color resource and, where it has one, a depth resource: two ids, because filters keep the depth they get. */
export interface LayerRef {
  readonly color: ResourceId;
  readonly depth: LayerDepthRef | null;
}

/** `window`: the resource's depth buffer, decoded with the view's projection. `meters`: red channel of an `r32f` target. */
export interface LayerDepthRef {
  readonly resource: ResourceId;
  readonly encoding: 'window' | 'meters';
}

interface OperationBase {
  /** Unique and readable; stable while the graph around it changes, so that the runtime keeps what it can. */
  readonly id: string;
  /** The node it came from, or the node that caused it. Inlined subgraphs give `outer/inner`. */
  readonly node: string;
  readonly reads: readonly ResourceId[];
  readonly writes: readonly ResourceId[];
  readonly view: 'each' | 'once';
}

/**
 * Played by the node type's `runtime.ts`. Two types are no nodes but what params are bound to, and write the param's slot:
 * `binding/expression` (config `postfix`, as `nodes/kit/expression.ts` says, and the numbers used `otherwise`, where a result is not
 * finite), and `binding/track` (config `times` in seconds, ascending; `values`, all numbers of the first key first; `easings`, one
 * word per key for the way to the next, or handles parted by commas; `limits` where these overshoot, a lowest and a highest value for
 * each number; `repeat`).
 */
export interface NodeOperation extends OperationBase {
  readonly kind: 'value' | 'source' | 'behavior' | 'geometry' | 'draw' | 'cpu';
  readonly type: string;
  readonly inputs: Readonly<Record<string, readonly InputRef[]>>;
  /** Input ports that take several wires: the node's runtime sees an array for these, else one view or null. */
  readonly multiple: readonly string[];
  /** Input ports of pulses, if any: the node's runtime sees one list per port, of all its wires or of none. */
  readonly pulses?: readonly string[];
  /** Its inputs are read after the frame's values are computed, so that it may come before what they depend on. */
  readonly delay?: true;
  /** What it gives depends on all earlier frames; with a slot, where that number is above the limit. */
  readonly stateful?: true | { readonly slot: number; readonly above: number };
  readonly outputs: Readonly<Record<string, OutputRef>>;
  /** Uniform params → slot. */
  readonly params: Readonly<Record<string, number>>;
  /** Structure params → value. Of a text that is an expression, its postfix. */
  readonly config: Readonly<Record<string, ParamValue>>;
  /** Asset params → asset id, or null where none is chosen. */
  readonly assets: Readonly<Record<string, string | null>>;
}

export type InputRef =
  | { readonly kind: 'resource'; readonly resource: ResourceId }
  | { readonly kind: 'layer'; readonly layer: LayerRef }
  | { readonly kind: 'slot'; readonly slot: number };

export type OutputRef = InputRef;

/** Draws objects: into a target, or straight into the session's framebuffer. */
export interface DrawOperation extends NodeOperation {
  readonly kind: 'draw';
  readonly view: 'each';
  readonly target: ResourceId | 'screen';
  readonly shadowMaps: ResourceId | null;
  /** Fragments behind the room are discarded while drawing; the params are those of the occlusion node. */
  readonly occlusion: DrawOcclusion | null;
}

/**
 * Sends a texture to a worker and draws the result of an earlier frame, or the texture itself while there is no result. Both are
 * targets of the same size.
 */
export interface CpuOperation extends NodeOperation {
  readonly kind: 'cpu';
  readonly picture: ResourceId;
  readonly target: ResourceId;
}

export interface DrawOcclusion {
  readonly node: string;
  readonly roomDepth: ResourceId;
  readonly params: Readonly<Record<string, number>>;
}

/** Renders the casters of one or more lights into depth textures. */
export interface ShadowMapOperation extends OperationBase {
  readonly kind: 'shadow-maps';
  readonly view: 'once';
  readonly casters: readonly ResourceId[];
  readonly lights: readonly ResourceId[];
}

/** One full-screen triangle. */
export interface PassOperation extends OperationBase {
  readonly kind: 'pass';
  /** Index into `shaders`. */
  readonly shader: number;
  readonly target: ResourceId | 'screen';
  /** `over`: premultiplied source over what is there. Only with `screen`. */
  readonly blend: 'replace' | 'over';
  readonly samplers: readonly PassSampler[];
  readonly uniforms: readonly PassUniform[];
  /** ISF `PASSINDEX`. */
  readonly passIndex: number;
  /** What it reads of its inputs, from the cheapest. Says what could be fused; playing needs it not. */
  readonly access?: 'pointwise' | 'displaced' | 'neighborhood' | 'persistent' | 'resize';
}

export interface PassSampler {
  /**
   * Uniform name in the linked shader; `NAME_uvFromViewUv` (mat3) and `NAME_size` (vec2, pixels) come with it when declared, and
   * `NAME_interpolate` (bool) with room depth, for `export/program/room-depth.ts`.
   */
  readonly name: string;
  readonly source:
    | { readonly kind: 'color'; readonly resource: ResourceId }
    /** Layer depth, or room depth; with it `NAME_decode` (vec4) as `export/glsl` documents. */
    | { readonly kind: 'depth'; readonly depth: LayerDepthRef }
    | { readonly kind: 'room-depth'; readonly resource: ResourceId }
    /** What was heard last, `count` samples or bins wide and as many rows high as there are channels; see `export/runtime/sound`. */
    | { readonly kind: 'sound'; readonly resource: ResourceId; readonly analysis: 'waveform' | 'spectrum'; readonly count: number }
    | { readonly kind: 'curve'; readonly resource: ResourceId }
    /** Assets that are pictures: one, or the six sides of a cube in the order +x, -x, +y, -y, +z, -z. */
    | { readonly kind: 'import'; readonly assets: readonly string[]; readonly cube: boolean };
  /** How an image-domain layer is laid onto a view; `none` where the domains agree. */
  readonly fit: 'none' | 'cover' | 'contain' | 'stretch';
}

export interface PassUniform {
  readonly name: string;
  readonly type: 'float' | 'int' | 'bool' | 'vec2' | 'vec3' | 'vec4';
  readonly source:
    | { readonly slot: number }
    | { readonly builtin: BuiltinUniform }
    /** Whether any of these lists of pulses holds one in this frame. */
    | { readonly pulses: readonly ResourceId[] };
}

/** ISF's automatic uniforms (docs.isf.video, "Automatically Created Uniforms"). */
export type BuiltinUniform = 'TIME' | 'TIMEDELTA' | 'FRAMEINDEX' | 'DATE' | 'RENDERSIZE' | 'PASSINDEX';

export type Operation = NodeOperation | DrawOperation | CpuOperation | ShadowMapOperation | PassOperation;

/** GLSL ES 3.00, complete. Equal sources are stored once. */
export interface LinkedShader {
  /** Hash of both texts. */
  readonly id: string;
  readonly vertex: string;
  readonly fragment: string;
  /**
   * Its vertex shader is an author's: draw 6 vertices as TRIANGLES, a quad, in the place of one triangle. A `moved-quad` may leave
   * pixels out: clear what it draws into first.
   */
  readonly geometry?: 'quad' | 'moved-quad';
  /** Its loops are looked at, but never cut short (`loop-budget.ts`). */
  readonly loops?: 'counted';
  /** As `sourceMap`, for the lines of the vertex shader, where that is an author's. */
  readonly vertexMap?: SourceMap;
  /** Printed line (from 0) → where the author wrote it. Left out of an export. */
  readonly sourceMap?: SourceMap;
}

export interface SourceMap {
  /** Source names, such as `filters/sepia.fs`. */
  readonly sources: readonly string[];
  /** Node that the text belongs to, per source. */
  readonly nodes: readonly string[];
  /** Per printed fragment line: `[source, line, column]`, lines and columns from 1, or null for text of the linker's own. */
  readonly lines: readonly (readonly [source: number, line: number, column: number] | null)[];
}

export interface ProgramAsset {
  readonly id: string;
  readonly kind: AssetKind;
  /** Relative to the project folder in a preview, to the page in an export. */
  readonly path: string;
}

/** Fixed before a session starts: WebXR framebuffers cannot change afterwards. */
export interface Presentation {
  /** `forward`: draws straight into the session's framebuffer. `composed`: at least one layer is needed as an image. */
  readonly mode: 'forward' | 'composed';
  readonly antialias: boolean;
  /** `world`: passthrough or the session's camera image. A color is display-referred sRGB, straight alpha. */
  readonly background: 'world' | readonly [number, number, number, number];
  readonly blend: 'alpha';
  /** Start of the orbit camera, where it differs from the default: its target (meters, world space) and its distance in meters. */
  readonly around?: { readonly targetWorld: readonly [number, number, number]; readonly distanceM: number };
}

export interface ProgramNeed {
  readonly capability: Capability;
  readonly required: boolean;
  /** Nodes that need it. */
  readonly nodes: readonly string[];
  readonly why: string;
  readonly without: string;
}

/** What one kind of session gives of this program, best first. */
export interface Tier {
  readonly id: 'ar-camera' | 'ar' | 'camera' | 'authored-vr' | 'orbit';
  /** Needs that this tier cannot meet, with what the picture does then. */
  readonly without: readonly { readonly capability: Capability; readonly effect: string }[];
}

/**
 * Checks the format and version of a program. A page and its program are built together, so a mismatch is a fault.
 *
 * @param json Parsed `program.json`.
 * @throws Error where this runtime cannot play it.
 */
export function readProgram(json: unknown): Program {
  const header = json as { format?: unknown; version?: unknown } | null;
  if (header?.format !== 'scrim-program') throw new Error('Not a Scrim program: the key "format" is missing or wrong.');
  if (header.version !== PROGRAM_VERSION) {
    throw new Error(
      `Program version ${String(header.version)} cannot be played: this runtime plays version ${PROGRAM_VERSION}. Export again.`,
    );
  }
  return json as Program;
}
