import type { ParamValue } from '../../nodes/kit/definition.ts';
import type { Easing } from '../../nodes/kit/ease.ts';

/**
 * A project in memory: immutable values, changed only through commands. `load.ts` and `save.ts` turn it into the
 * files of a project folder and back, byte for byte.
 */
export interface Project {
  readonly title: string;
  /** What the exported page says about itself. */
  readonly page: PageInfo;
  /** The main graph is `main`; all others are subgraphs, usable as node type `graph/NAME`. */
  readonly graphs: Readonly<Record<string, Graph>>;
  readonly layout: Readonly<Record<string, GraphLayout>>;
  /** Shader texts of the project's own, by file name in `shaders/`: `edge.fs`, `chunks/ink/dots.glsl`. */
  readonly sources: Readonly<Record<string, string>>;
  readonly assets: Readonly<Record<string, Asset>>;
}

/** All that a picture depends on: what the compiler and validation take. */
export type ProjectLogic = Omit<Project, 'layout'>;

export interface PageInfo {
  readonly description: string;
  /** BCP 47. */
  readonly language: string;
}

export const MAIN_GRAPH = 'main';

export interface Graph {
  readonly nodes: Readonly<Record<string, GraphNode>>;
  /** In order: where a port takes several wires, they count in this order. */
  readonly wires: readonly Wire[];
  /** Ports and params that a subgraph shows to the graph using it; empty for the main graph. */
  readonly exposed: ExposedPorts;
}

export interface ExposedPorts {
  readonly inputs: readonly ExposedPort[];
  readonly outputs: readonly ExposedPort[];
}

/** `name` outside stands for port or param `port` of node `node` inside. */
export interface ExposedPort {
  readonly name: string;
  readonly node: string;
  readonly port: string;
}

export interface GraphNode {
  readonly type: string;
  /** Version of the node type that the params were saved with. */
  readonly version: number;
  /** Only params that differ from the default; a missing one has the definition's default. */
  readonly params: Readonly<Record<string, Binding>>;
  /** Bypassed: its first layer passes through. */
  readonly muted?: boolean;
}

/** Where a param's value comes from. `port` is the value while the port is not connected. */
export type Binding =
  | { readonly value: ParamValue }
  | { readonly track: Track }
  | { readonly expression: string }
  | { readonly port: ParamValue };

/** In the order of time. Before its first key a track has that key's value. */
export interface Track {
  readonly keys: readonly Keyframe[];
  /** After the last key: stay there, begin anew at the first, or go back and forth. */
  readonly repeat: 'once' | 'loop' | 'mirror';
}

export interface Keyframe {
  /** Since the session began. */
  readonly timeS: number;
  readonly value: number | readonly number[];
  /** On the way to the next key. */
  readonly easing: Easing;
}

/** Saved as `"video-a1b2.layer -> sepia-k7q2.inputImage"`. */
export interface Wire {
  readonly from: PortAddress;
  readonly to: PortAddress;
}

export interface PortAddress {
  readonly node: string;
  readonly port: string;
}

export interface Asset {
  /** Relative to the project folder, `/` between parts. */
  readonly path: string;
  readonly kind: 'image' | 'model' | 'video' | 'audio' | 'environment';
  readonly credit?: string;
  readonly licence?: string;
}

export interface GraphLayout {
  readonly nodes: Readonly<Record<string, NodeLayout>>;
  readonly frames: Readonly<Record<string, Frame>>;
  readonly notes: Readonly<Record<string, Note>>;
  /** Points that wires are led through. Each is on a route; several wires from one output may share it. */
  readonly reroutes: Readonly<Record<string, Reroute>>;
  /** Wire, as `printWire` writes it → the ids of its reroutes from source to target. None of a wire that runs straight. */
  readonly routes: Readonly<Record<string, readonly string[]>>;
}

/** Canvas units (CSS pixels at zoom 1), origin anywhere, y down. */
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

/** The middle of the point. */
export interface Reroute {
  readonly x: number;
  readonly y: number;
}
