/** How nodes with the lowering `geometry` draw: by three.js with shadow maps, or by themselves. */

/** What determines the shadow maps of a node: its ports of `casters` and `lights`. Nodes with equal wires at these ports share the maps. */
export interface ShadowMapUse {
  readonly casters: readonly string[];
  readonly lights: string;
  /** A structure toggle that turns the maps off. */
  readonly enabledBy?: string;
  /** A structure choice, and the value with which the node uses shadow maps. */
  readonly chosenBy?: { readonly param: string; readonly value: string };
}

/** How a node draws by its own GL program. */
export interface OwnDrawing {
  /** Whether it hides fragments behind the room while it draws (`NodeContext.occlusion`). Otherwise an occlusion is a pass of its own. */
  readonly hidesBehindRoom?: true;
  /**
   * Whether it only blends: its edges are smooth with one sample per pixel, and on the screen it needs no depth buffer. It writes depth only
   * where something reads it (`DrawView.readsDepth`).
   */
  readonly blends?: true;
}
