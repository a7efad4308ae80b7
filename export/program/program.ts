import type { ArithmeticOperation } from '../../nodes/kit/arithmetic.ts';
import type { AssetKind, LayerEncoding, ParamValue } from '../../nodes/kit/definition.ts';
import type { FoundLamps } from '../../nodes/kit/panorama/found-lamps.ts';
import type { TableType, ValueType } from '../../nodes/kit/wire-types.ts';
import type { ProgramNeed, Tier } from './needs.ts';
import type { ProgramCredit } from './program-credit.ts';
import type { Presentation } from './program-presentation.ts';

/**
 * Version of the program format. A program is the output of the compiler and the only input of the runtime: versioned JSON without data of
 * the editor. This folder imports only types of the kit, so the format can be understood on its own.
 *
 * A frame runs the operations in list order. Those with `view: 'once'` come first (values, sources, objects, shadow maps, image-domain
 * passes); those with `view: 'each'` then run as a block once per view, so views share their targets.
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
  /** Controls for visitors from top to bottom; absent if there are none. */
  readonly controls?: readonly Control[];
  /** Whether a node reads pointers, taps or controllers; absent if none does. */
  readonly readsInput?: true;
  /** Credits of its works by title; absent if no author is named. For display only: the runtime ignores them. */
  readonly credits?: readonly ProgramCredit[];
}

/**
 * A control on screen. Its value is set by `setParam(node, param, value)`: a number for a slider, a boolean or 0 and 1 for a toggle, the
 * index of the option for a choice. A button's value is its number of presses, so two presses within a frame count as two.
 */
export type Control = ControlBase &
  /** Step 0: none. A value in `rad` is shown in degrees. */
  (
    | { readonly kind: 'slider'; readonly min: number; readonly max: number; readonly step: number; readonly unit?: 'rad' }
    | { readonly kind: 'toggle' }
    | { readonly kind: 'button' }
    | { readonly kind: 'choice'; readonly options: readonly string[] }
  );

interface ControlBase {
  readonly node: string;
  readonly param: string;
  readonly label: string;
  /** Initial value; 0 or 1 for a toggle. */
  readonly value: number;
}

/** Values that change at run time. Numbers are in one flat Float64Array, texts in one table; operations refer to them by slot index. */
export interface SlotTable {
  readonly numbers: readonly number[];
  readonly texts: readonly string[];
  readonly slots: readonly Slot[];
  /** `node.param` → slot index, for every value that can be set at run time. */
  readonly params: Readonly<Record<string, number>>;
}

export type SlotType = ValueType | TableType;

export interface Slot {
  readonly type: SlotType;
  /** First index in `numbers`, or the index in `texts` for a text. */
  readonly offset: number;
}

export type ResourceId = string;

/** Data that operations read and write. Ids are readable: `blur-p3ma.out`, `blur-p3ma.pass0`. */
export type Resource =
  /** A render target, whose texture the runtime creates. */
  | {
      readonly id: ResourceId;
      readonly kind: 'target';
      readonly domain: 'view' | 'image';
      readonly size: TargetSize;
      readonly format: TargetFormat;
      /** `window`: with a readable depth buffer. `none`: color only. */
      readonly depth: 'none' | 'window';
      readonly samples: 1 | 4;
      /** Whether passes read its depth buffer, or that of a target that shares its texture. */
      readonly depthRead?: true;
      /** `persistent` targets keep the previous frame: an operation that reads and writes one reads the previous content. */
      readonly lifetime: 'frame' | 'persistent';
      /** An equal target whose texture this target shares: no operation reads the other target after this one is drawn. */
      readonly shares?: ResourceId;
    }
  /** A texture of a source: image, video or camera. */
  | { readonly id: ResourceId; readonly kind: 'external'; readonly domain: 'view' | 'image' }
  /** Depth of the real room, per view. */
  | { readonly id: ResourceId; readonly kind: 'room-depth' }
  | { readonly id: ResourceId; readonly kind: 'objects' }
  | { readonly id: ResourceId; readonly kind: 'lights' }
  /** A panorama around the scene. */
  | { readonly id: ResourceId; readonly kind: 'environment' }
  /** Sound for shaders and nodes. */
  | { readonly id: ResourceId; readonly kind: 'sound' }
  /** Events of this frame; cleared before each frame. */
  | { readonly id: ResourceId; readonly kind: 'pulses' }
  /** A rigid transform in world space, written in every frame before its readers run. */
  | { readonly id: ResourceId; readonly kind: 'pose' }
  /** A captured place, without the GPU. */
  | { readonly id: ResourceId; readonly kind: 'capture' }
  /** Physics bodies. */
  | { readonly id: ResourceId; readonly kind: 'bodies' }
  /** A curve as a table of heights, or a gradient as a table of colors (`texture-sizes.ts`), from the slot. No operation writes it. */
  | { readonly id: ResourceId; readonly kind: 'table'; readonly of: TableType; readonly slot: number }
  /** A technique. No operation writes it. */
  | TechniqueResource
  /** Pixels of a reduced image on the CPU, of an earlier frame. Nodes read them before the image of the frame is drawn. */
  | { readonly id: ResourceId; readonly kind: 'pixels' }
  /** Depth maps of all shadow-casting lights for one set of casters. */
  | { readonly id: ResourceId; readonly kind: 'shadow-maps' };

export interface TechniqueResource {
  readonly id: ResourceId;
  readonly kind: 'technique';
  /** Index into `shaders` of a test shader that is only compiled, to find out whether a driver accepts the text. Null in an export. */
  readonly trial: number | null;
  /** Text for the vertex and fragment shader of the material; see `export/glsl/technique/interface.ts`. */
  readonly vertex: string;
  readonly fragment: string;
  /** Passes for each object, in order. */
  readonly passes: readonly TechniquePass[];
  readonly uniforms: readonly TechniqueUniform[];
  /** Samplers of the layers that the technique reads, if any. Draws with the technique list these layers in `reads`. */
  readonly samplers?: readonly PassSampler[];
  /** Values of uniforms with which it does not read what is computed for meshes; see `TechniqueView`. */
  readonly unread?: readonly { readonly name: 'along' | 'radial'; readonly uniform: string; readonly values: readonly number[] }[];
  /** Images that it contains, by uniform name: base64 of a PNG with its mip levels side by side. */
  readonly pictures?: readonly { readonly name: string; readonly data: string }[];
}

export interface TechniquePass {
  /** Visible sides of triangles; `object` uses the side of the object's material. `edges` draws edges as lines instead of triangles. */
  readonly side: 'object' | 'front' | 'back' | 'both' | 'edges';
  /** Whether a pass of edges is drawn only for meshes with a border. */
  readonly open?: true;
}

export interface TechniqueUniform {
  readonly name: string;
  readonly type: PassUniform['type'];
  readonly slot: number;
}

/**
 * `rgba8`: a layer. `scene16f`: a scene layer (ADR 38), linear, unclamped and finite. `rgba16f`: unclamped. `rgba32f`: numbers. `r32f`: depth
 * in meters, 0 where there is none.
 */
export type TargetFormat = 'rgba8' | 'scene16f' | 'rgba16f' | 'rgba32f' | 'r32f';

/** Size of a target in pixels. An expression for each side computes it from the size of the view or of another resource (`base`). */
export interface TargetSize {
  readonly base: 'view' | ResourceId;
  readonly width: SizeExpression;
  readonly height: SizeExpression;
}

/** Postfix code over the base's `$WIDTH` and `$HEIGHT`, constants and slots. `nodes/kit/arithmetic.ts` defines the operations. */
export type SizeExpression = readonly (number | SizeToken)[];
export type SizeToken = { readonly slot: number } | { readonly op: 'width' | 'height' | ArithmeticOperation };

/** A layer: a color resource and optionally a depth resource. They are separate, because filters pass depth on. */
export interface LayerRef {
  readonly color: ResourceId;
  readonly depth: LayerDepthRef | null;
}

/** `window`: the depth buffer of the resource, decoded with the view's projection. `meters`: red channel of an `r32f` target. */
export interface LayerDepthRef {
  readonly resource: ResourceId;
  readonly encoding: 'window' | 'meters';
}

interface OperationBase {
  /** Unique, readable and stable while the graph around it changes, so that the runtime can keep state. */
  readonly id: string;
  /** The node that it was made for. Nodes of inlined subgraphs are `outer/inner`. */
  readonly node: string;
  readonly reads: readonly ResourceId[];
  readonly writes: readonly ResourceId[];
  readonly view: 'each' | 'once';
}

/**
 * An operation that the node type's `runtime.ts` plays. A type `part/NAME` writes one output of a node that draws (`OutputPort.part`). Two
 * more types are not nodes but bindings of params, and write the param's slot. `binding/expression` has the config `postfix` (see
 * `nodes/kit/expression.ts`) and `otherwise`, the numbers for a result that is not finite. `binding/track` has `times` (seconds, ascending),
 * `values` (all numbers of the first key first), `easings` (one word per key for the interpolation to the next, or control points separated
 * by commas), optional `limits` (lowest and highest value of each number, if the curve overshoots) and `repeat`.
 */
export interface NodeOperation extends OperationBase {
  readonly kind: 'value' | 'source' | 'behavior' | 'geometry' | 'draw' | 'cpu';
  readonly type: string;
  readonly inputs: Readonly<Record<string, readonly InputRef[]>>;
  /** Input ports that take several wires: the node's runtime gets an array for these, else one value or null. */
  readonly multiple: readonly string[];
  /** Input ports of pulses, if any: the node's runtime gets one list per port. */
  readonly pulses?: readonly string[];
  /** Input ports of poses, if there are any. If one of them gets another wire, the node and its state are kept. */
  readonly poses?: readonly string[];
  /** Whether its inputs are read after the values of the frame are computed, so it may come before operations that it depends on. */
  readonly delay?: true;
  /** Whether its output depends on all earlier frames; with a slot, only if its number is above the limit. */
  readonly stateful?: true | { readonly slot: number; readonly above: number };
  /** Whether it starts a worker of its own. */
  readonly worker?: true;
  readonly outputs: Readonly<Record<string, OutputRef>>;
  /** Uniform params → slot. */
  readonly params: Readonly<Record<string, number>>;
  /** Structure params → value; the postfix code for a text that is an expression. */
  readonly config: Readonly<Record<string, ParamValue>>;
  /** Asset params → asset id, or null if none is chosen. */
  readonly assets: Readonly<Record<string, string | null>>;
  /** Whether it draws the depth meshes of its captures. */
  readonly depthMeshes?: true;
}

export type InputRef =
  | { readonly kind: 'resource'; readonly resource: ResourceId }
  | { readonly kind: 'layer'; readonly layer: LayerRef }
  | { readonly kind: 'slot'; readonly slot: number };

export type OutputRef = InputRef;

/** Draws objects to a target or to the session's framebuffer; with `ownDrawing` by the node's own GL program, without three.js. */
export interface DrawOperation extends NodeOperation {
  readonly kind: 'draw';
  readonly view: 'each';
  readonly target: ResourceId | 'screen';
  readonly shadowMaps: ResourceId | null;
  /** Occlusion that discards fragments behind the room while drawing; the params are those of the occlusion node. */
  readonly occlusion: DrawOcclusion | null;
  /** What glass shows where there are no objects. Null: nothing. Absent: the background, if the draw is the first one to the screen. */
  readonly under?: DrawUnder | null;
  /** Whether techniques of its objects read what is behind them. Models may contain glass without it. */
  readonly glass?: true;
  readonly ownDrawing?: true;
  /** It needs no depth buffer on the screen, and one sample per pixel. */
  readonly onlyBlends?: true;
  /** Effects that its materials compute at their end, in place of passes over its layer (ADR 55). */
  readonly effects?: DrawEffects;
}

/** Effects in the materials of a draw whose objects are opaque. */
export interface DrawEffects {
  /** The nodes of the effects, in drawing order. */
  readonly nodes: readonly string[];
  /** Text for fragment shaders: `vec4 scrimEffects(vec4 color)`, from the color of an opaque surface to the color to draw. */
  readonly text: string;
  readonly uniforms: readonly PassUniform[];
  /** Samplers of tables, if any. */
  readonly samplers?: readonly PassSampler[];
  /**
   * Index into `shaders` of the pass with the same effects, which is only compiled, so that errors are on the author's line. Null in an
   * export.
   */
  readonly trial: number | null;
}
export type DrawUnder = { readonly resource: ResourceId; readonly fit: PassSampler['fit']; readonly encoding: LayerEncoding };

/** Sends a texture to a worker and draws the result of an earlier frame, else the texture itself. Both targets have the same size. */
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

/** Renders the casters of one or more lights to depth textures. */
export interface ShadowMapOperation extends OperationBase {
  readonly kind: 'shadow-maps';
  readonly view: 'once';
  readonly casters: readonly ResourceId[];
  readonly lights: readonly ResourceId[];
}

/** Reads a small image back to the CPU: that of the first view, or of all views. */
export interface ReadbackOperation extends OperationBase {
  readonly kind: 'readback';
  readonly picture: ResourceId;
  readonly pixels: ResourceId;
}

/** Draws one full-screen triangle. */
export interface PassOperation extends OperationBase {
  readonly kind: 'pass';
  /** Index into `shaders`. */
  readonly shader: number;
  readonly target: ResourceId | 'screen';
  /** `over`: premultiplied alpha blending; only with `screen`. */
  readonly blend: 'replace' | 'over';
  readonly samplers: readonly PassSampler[];
  readonly uniforms: readonly PassUniform[];
  /** ISF `PASSINDEX`. */
  readonly passIndex: number;
  /** How it reads its inputs, from the cheapest. Informative, like `nodes`: the runtime does not use it. */
  readonly access?: 'pointwise' | 'displaced' | 'neighborhood' | 'persistent' | 'resize';
  /** Present if it only copies the image of its sampler. */
  readonly copies?: true;
  /** Present if views of equal size need it once: for the second one, its target still has the image. */
  readonly sameForViews?: true;
  /** The nodes whose passes are fused in it, in drawing order; absent if it is a pass of `node` alone. */
  readonly nodes?: readonly string[];
}

export interface PassSampler {
  /** Uniform name. If declared, `NAME_uvFromViewUv`, `NAME_size` (pixels) and, with room depth, `NAME_interpolate` (bool) are set too. */
  readonly name: string;
  readonly source:
    | { readonly kind: 'color'; readonly resource: ResourceId }
    /** Layer depth or room depth; with it `NAME_decode` (vec4), as `export/glsl` documents. */
    | { readonly kind: 'depth'; readonly depth: LayerDepthRef }
    | { readonly kind: 'room-depth'; readonly resource: ResourceId }
    /** The most recent sound, `count` samples or bins wide, with one row per channel; see `export/runtime/sound`. */
    | { readonly kind: 'sound'; readonly resource: ResourceId; readonly analysis: 'waveform' | 'spectrum'; readonly count: number }
    | { readonly kind: 'table'; readonly resource: ResourceId }
    /** Image assets: one, or the six faces of a cube in the order +x, -x, +y, -y, +z, -z. */
    | { readonly kind: 'import'; readonly assets: readonly string[]; readonly cube: boolean };
  /** How an image-domain layer is fitted to a view; `none` if the domains are equal. */
  readonly fit: 'none' | 'cover' | 'contain' | 'stretch';
  /** Present if pixels are read at their centers only: filtering would mix in neighbors, because positions are rounded. */
  readonly unfiltered?: true;
}

export interface PassUniform {
  readonly name: string;
  readonly type: 'float' | 'int' | 'bool' | 'vec2' | 'vec3' | 'vec4' | 'mat4';
  readonly source:
    | { readonly slot: number }
    | { readonly builtin: BuiltinUniform }
    /** Whether any of these lists of pulses has one in this frame. */
    | { readonly pulses: readonly ResourceId[] };
}

/** ISF's automatic uniforms (docs.isf.video, “Automatically Created Uniforms”). */
type IsfUniform = 'TIME' | 'TIMEDELTA' | 'FRAMEINDEX' | 'DATE' | 'RENDERSIZE' | 'PASSINDEX';

/** The projection of the view and its pose in world space are column-major 4×4; of the first view in passes that run once per frame. */
export type BuiltinUniform = IsfUniform | 'SCRIM_CLIP_FROM_VIEW' | 'SCRIM_WORLD_FROM_VIEW';

export type Operation = NodeOperation | DrawOperation | CpuOperation | ShadowMapOperation | ReadbackOperation | PassOperation;

/** Complete GLSL ES 3.00. Equal sources are stored once. */
export interface LinkedShader {
  /** Hash of both texts. */
  readonly id: string;
  readonly vertex: string;
  readonly fragment: string;
  /**
   * Present if the vertex shader is written by an author: draw 6 vertices as TRIANGLES (a quad) instead of one triangle. A `moved-quad` may
   * not cover all pixels: clear the target first.
   */
  readonly geometry?: 'quad' | 'moved-quad';
  /** Present if the shader's loops are probed but never ended early (`loop-budget.ts`). */
  readonly loops?: 'counted';
  /** The same as `sourceMap` for the lines of an author's vertex shader. */
  readonly vertexMap?: SourceMap;
  /** Printed line (from 0) → author's line. Left out of an export. */
  readonly sourceMap?: SourceMap;
}

export interface SourceMap {
  /** Source names, such as `filters/sepia.fs`. */
  readonly sources: readonly string[];
  /** The node that the text belongs to, per source. */
  readonly nodes: readonly string[];
  /** Per printed fragment line: `[source, line, column]`, lines and columns from 1, or null for text of the linker. */
  readonly lines: readonly (readonly [source: number, line: number, column: number] | null)[];
}

export interface ProgramAsset {
  readonly id: string;
  readonly kind: AssetKind;
  /** Relative to the project folder in a preview, to the page in an export. */
  readonly path: string;
  /** For a panorama in an export: the lamps that its nodes look for, by `lampKey`, so that the page does not search it. */
  readonly lamps?: Readonly<Record<string, FoundLamps>>;
  /** For a capture: whether its depth meshes are drawn. */
  readonly depthMeshes?: true;
  /** For splats in an export: the most bytes that they take on the GPU of a phone or headset. A capture has it in its document. */
  readonly phoneGpuBytes?: number;
}
