import type { AssetKind, ParamValue } from '../../nodes/kit/definition.ts';
import type { Easing } from '../../nodes/kit/ease.ts';
import type { PosterFraming } from '../../nodes/kit/poster-framing.ts';

/**
 * A project in memory: immutable values, changed only by commands. `load.ts` and `save.ts` convert between it and the files of a project
 * folder without loss.
 */
export interface Project {
  readonly title: string;
  /** Metadata of the exported page. */
  readonly page: PageInfo;
  /** `main` is the main graph; all others are subgraphs, usable as node type `graph/NAME`. */
  readonly graphs: Readonly<Record<string, Graph>>;
  readonly layout: Readonly<Record<string, GraphLayout>>;
  /** Texts of the project's own shaders by file name in `shaders/`: `edge.fs`, `chunks/ink/dots.glsl`. */
  readonly sources: Readonly<Record<string, string>>;
  readonly assets: Readonly<Record<string, Asset>>;
  /** Only of recipes: what the palette must know beside the title, the description and the graph `recipe` (`read-recipe.ts`). */
  readonly recipe?: RecipeInfo;
}

export interface RecipeInfo {
  /** Other words that people search for. */
  readonly keywords: readonly string[];
}

/** Everything that the rendering depends on: input of the compiler and of validation. */
export type ProjectLogic = Omit<Project, 'layout'>;

export interface PageInfo {
  readonly description: string;
  /** BCP 47 language tag. */
  readonly language: string;
  /** Path of the poster, a JPEG in `assets/`; absent: each export draws one. */
  readonly poster?: string;
  /** What the poster shows if each export draws one; absent: the objects. */
  readonly framing?: PosterFraming;
}

export const MAIN_GRAPH = 'main';

export interface Graph {
  readonly nodes: Readonly<Record<string, GraphNode>>;
  /** The order of wires matters at ports that take several. */
  readonly wires: readonly Wire[];
  /** Ports and params that a subgraph exposes; empty for the main graph. */
  readonly exposed: ExposedPorts;
}

export interface ExposedPorts {
  readonly inputs: readonly ExposedPort[];
  readonly outputs: readonly ExposedPort[];
}

/** Exposes the port or param `port` of node `node` as `name`. */
export interface ExposedPort {
  readonly name: string;
  readonly node: string;
  readonly port: string;
}

export interface GraphNode {
  readonly type: string;
  /** Version of the node type at the last save. */
  readonly version: number;
  /** Params that differ from the default. */
  readonly params: Readonly<Record<string, Binding>>;
  /** Whether the node is bypassed: its first layer passes through. */
  readonly muted?: boolean;
  /** Whether the node's passes keep shaders of their own (docs/adr/0043). */
  readonly unfused?: boolean;
}

/** Source of a param's value. `port` holds the value while the port is not connected. */
export type Binding =
  | { readonly value: ParamValue }
  | { readonly track: Track }
  | { readonly expression: string }
  | { readonly port: ParamValue };

/** Keyframes sorted by time. Before its first key a track has that key's value. */
export interface Track {
  readonly keys: readonly Keyframe[];
  /** After the last key: keep its value, restart at the first, or reverse. */
  readonly repeat: 'once' | 'loop' | 'mirror';
}

export interface Keyframe {
  /** Seconds since the session began. */
  readonly timeS: number;
  readonly value: number | readonly number[];
  /** Interpolation to the next key. */
  readonly easing: Easing;
}

/** A connection. Saved as `"video-a1b2.layer -> sepia-k7q2.inputImage"`. */
export interface Wire {
  readonly from: PortAddress;
  readonly to: PortAddress;
}

export interface PortAddress {
  readonly node: string;
  readonly port: string;
}

export interface Asset {
  /** Relative to the project folder, with `/` between folders. */
  readonly path: string;
  readonly kind: AssetKind;
  readonly credit?: string;
  readonly licence?: string;
}

export interface GraphLayout {
  readonly nodes: Readonly<Record<string, NodeLayout>>;
  readonly frames: Readonly<Record<string, Frame>>;
  readonly notes: Readonly<Record<string, Note>>;
  /** Points that routes pass through. Each is on at least one route; several wires of one output may share it. */
  readonly reroutes: Readonly<Record<string, Reroute>>;
  /** Wire, as `printWire` writes it → ids of its reroutes from source to target. Wires without reroutes are absent. */
  readonly routes: Readonly<Record<string, readonly string[]>>;
  /** Top left corners of the borders of a subgraph. A border without place stands beside the nodes. */
  readonly borders?: Readonly<Partial<Record<keyof ExposedPorts, Place>>>;
}

/** Position in canvas units (CSS pixels at zoom 1); the origin is arbitrary, y is down. */
export interface NodeLayout {
  readonly x: number;
  readonly y: number;
  readonly collapsed?: boolean;
}

export interface Frame {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly title: string;
  readonly color?: string;
}

export interface Note {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  readonly text: string;
}

/** Canvas units. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** Center of the point. */
export type Reroute = Place;
