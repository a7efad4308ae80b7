import type { NodeRuntime } from '../../../nodes/kit/runtime.ts';
import type { GlObjects } from './gl-objects.ts';

/**
 * Attributes GPU objects to the nodes that draw themselves and to the assets that they draw, for the preview and for tests. Pages have none.
 */
export interface OwnedObjects {
  /** Creates a node, and follows its calls until it is disposed. What it leaves then is a leak. */
  followNode(node: string, create: () => NodeRuntime): NodeRuntime;
  /** Begins to follow the asset of a file. */
  followAsset(path: string, objects: GlObjects): FollowedAsset;
}

export interface FollowedAsset {
  /** What the asset creates its objects with. */
  readonly objects: GlObjects;
  /** Call it when the asset has been disposed. What is left then is a leak. */
  end(): void;
}

/** The GPU objects of one owner. */
export interface OwnedMemory {
  readonly kind: 'node' | 'asset';
  /** Id of the node in the program, or path of the asset. */
  readonly name: string;
  readonly objects: number;
  /** Textures and buffers. */
  readonly bytes: number;
  /** Whether the owner has been disposed, so that the objects are a leak. */
  readonly isLeft: boolean;
}
