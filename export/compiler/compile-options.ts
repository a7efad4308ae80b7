export interface CompileOptions {
  /** Layers to view, as `node.port`; missing ones are left out of `program.taps`. */
  readonly taps?: readonly string[];
  /**
   * Further layers to view, in small. One that would make the program request a capability, read input, show controls or depend on earlier frames is left out, so
   * that thumbnails do not change how the program plays.
   */
  readonly thumbnails?: readonly string[];
  /** Bound the loops of shaders (docs/adr/0012): for previews, never for exports. */
  readonly loopBudget?: boolean;
  /** Keep the source maps of shaders; true by default. */
  readonly sourceMaps?: boolean;
  /** Draw several passes by one shader where the image stays the same (docs/adr/0043): for exports and plans. */
  readonly fuse?: boolean;
  /** Ids of image assets without transparency, whose fused passes need not divide by alpha. */
  readonly opaqueImages?: readonly string[];
  /** Ids of model assets without transparent materials, in which effects can be computed (docs/adr/0055). */
  readonly opaqueModels?: readonly string[];
  /** Compute once what is the same in every frame while only controls of the page set params (docs/adr/0048): for exports and plans. */
  readonly fold?: boolean;
  /** Report nodes that the output does not depend on (SCR021). */
  readonly reportUnused?: boolean;
}
