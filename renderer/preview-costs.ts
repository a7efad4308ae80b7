/** Cost of one operation of the program in one frame, all views together. */
export interface OperationCost {
  readonly id: string;
  readonly draws: number;
  /** GPU time. Null if the browser does not support `EXT_disjoint_timer_query_webgl2`, or has no result yet. */
  readonly gpuMs: number | null;
}

/** The GPU objects of a node that draws itself, or of an asset that such a node draws. */
export interface MemoryCost {
  readonly kind: 'node' | 'asset';
  /** Id of the node in the program, or path of the asset. */
  readonly name: string;
  readonly objects: number;
  readonly bytes: number;
  /** Whether the node or asset is gone and the objects remain. */
  readonly isLeft: boolean;
}
